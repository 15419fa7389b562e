"""Buffers as pictures to look at."""
