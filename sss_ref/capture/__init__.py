"""Pictures of which nobody says what they hold: found in a folder or a capture, and placed by what is in them."""
