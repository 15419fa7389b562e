"""Matrices, and the views of the camera and the lights."""
