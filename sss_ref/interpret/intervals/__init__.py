"""Stages on intervals: all that a correct processor may compute."""
