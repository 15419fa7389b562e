"""Passes as compiled loops: from the stages to Python that numba compiles."""
