"""The value of a pixel as text."""

import numpy as np


def pixel_text(pixel: np.ndarray) -> str:
    """A number, or several in brackets."""
    parts = [str(part) for part in np.atleast_1d(pixel)]
    return parts[0] if len(parts) == 1 else f"({', '.join(parts)})"
