"""The interpreters: each runs the same stages, and all that give values give the same bits."""
