"""A scene's passes, drawn and folded over a dictionary of buffers."""
