"""A scene file: its tables and keys, presets, kernels, and how it is read."""
