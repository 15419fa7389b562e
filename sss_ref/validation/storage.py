"""How far a stored value may be from the one that was computed: a texture rounds, one way or the other."""

import numpy as np

# Storage -> the step between neighbours: relative to the value, and at least.
STEPS = {
    "float16": (2.0**-10, 2.0**-24),
    "float11": (2.0**-6, 2.0**-20),
    "float10": (2.0**-5, 2.0**-19),
    "unorm8": (0.0, 1 / 255),
    "unorm10": (0.0, 1 / 1023),
    "unorm16": (0.0, 1 / 65535),
    "unorm24": (0.0, 1 / (2**24 - 1)),
    "srgb8": (0.0, 3.3 / 255),  # a code near white stands for more linear light than one near black
}


def step_of(storage: str, values: np.ndarray) -> np.ndarray:
    """The step of a storage at these values, float64; 0 for float32 and integers."""
    if storage not in STEPS:
        return np.zeros(values.shape)
    relative, least = STEPS[storage]
    return np.maximum(np.abs(values.astype(np.float64)) * relative, least)
