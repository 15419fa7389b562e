"""Buffers that another renderer wrote: found, decoded, and brought into the form of ours."""
