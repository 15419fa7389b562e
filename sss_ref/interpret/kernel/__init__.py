"""Stages as compiled loops over strips of fragments: from the stages to Python that numba compiles."""
