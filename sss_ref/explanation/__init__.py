"""One pixel explained: every stage that made it, line by line."""
