"""Pictures that hold numbers and no colours: normal maps and specular maps, whose codes are not sRGB."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.cache.recent import of_unchanged_file
from sss_ref.errors import SceneError
from sss_ref.errors.array_file import mapped_array
from sss_ref.scene_file.color_texture import codes_of

FloatArray = NDArray[np.float32]


@of_unchanged_file
def load_linear(path: Path) -> FloatArray:
    """The texels of a PNG or JPEG file, code/255 or, of 16 bits, code/65535, float32 (H, W, 3), row 0 at the bottom.

    The quotient is rounded once. Grey becomes RGB; alpha is not used. An NPY file holds the very texels, as a bundle
    has them. Raises SceneError as `codes_of` does, and for an array of another form or with numbers outside 0 to 1.
    """
    if path.suffix == ".npy":
        return _array(path)
    codes = codes_of(path, deepest=16)
    return (codes / np.float64(np.iinfo(codes.dtype).max)).astype(np.float32, order="C")


def _array(path: Path) -> FloatArray:
    expected, remedy = "an NPY file of float32 (H, W, 3) from 0 to 1", "write the array again"
    try:
        texels = mapped_array(path)
    except Exception:  # whatever a broken file makes NumPy raise
        raise SceneError(f"expected {expected}, got one that cannot be read; {remedy}") from None
    if texels is None:
        raise SceneError(f"expected {expected}, got an archive; {remedy}")
    if texels.dtype != np.float32 or texels.shape[2:] != (3,) or not texels.size:
        raise SceneError(f"expected {expected}, got {texels.dtype} {texels.shape}; {remedy}")
    if not ((texels >= 0) & (texels <= 1)).all():
        raise SceneError(f"expected {expected}, got other numbers; {remedy}")
    return np.array(texels)
