"""Which rules the buffers are computed by: rasterization, arithmetic and the equations of the stages together."""

RULES_VERSION = 2
"""Raised whenever a rule changes on purpose and with it the bits; results of two versions are not comparable."""
