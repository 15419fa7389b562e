"""Holding the buffers of another implementation against the stages: which one is the first that is wrong."""
