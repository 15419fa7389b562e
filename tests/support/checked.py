"""A check of a buffer given as arrays."""

import numpy as np

from sss_ref.validation.accept.rebased import Check


def check_of(expected, got, reach=0.0, where=None, buffer="seen", stage="stage", **others):
    """A check of arrays (H, W) or (H, W, C), floats as float32; by default of all pixels."""
    expected, got = map(_as_buffer, (expected, got))
    where = np.ones(expected.shape[:2], bool) if where is None else np.array(where)
    reaches = np.broadcast_to(np.float64(reach), expected.shape)
    return Check("pass", stage, buffer, where, expected, got, reaches, **others)


def _as_buffer(values):
    array = np.asarray(values)
    return array.astype(np.float32) if array.dtype.kind == "f" else array
