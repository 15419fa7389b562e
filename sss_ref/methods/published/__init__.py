"""What the printed figures compute: its own stages, byte targets, and the passes of both methods."""
