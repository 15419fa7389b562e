"""What the channels of a buffer are called, in EXR files and wherever a picture is made of it."""

import numpy as np

from sss_ref.passes.buffers import described

COLOUR = "linear RGB"
BY_COUNT = {1: ("Y",), 2: ("U", "V"), 3: ("X", "Y", "Z")}


def channel_names(name: str, buffer: np.ndarray) -> tuple[str, ...]:
    """One name per channel: R, G, B of a colour; X, Y, Z of a point or direction; U, V of texture coordinates.

    A scalar is Y, the name of luminance in EXR: viewers show that as grey, and an unknown name not at all.
    """
    count = 1 if buffer.ndim == 2 else buffer.shape[2]
    return ("R", "G", "B") if count == 3 and described(name).unit == COLOUR else BY_COUNT[count]
