"""Changes that must change nothing: a scene is drawn twice, and what comes out is compared bit for bit."""
