"""The picture's size and the grid that window positions are snapped to (rules R2 and R3)."""

from dataclasses import dataclass

from sss_ref.errors import SceneError

LARGEST = 16384  # pixels a side: keeps every edge function below 2^53, exact in int64 and in float64 alike
FINEST = 8  # subpixel bits, for the same reason


@dataclass(frozen=True)
class Viewport:
    """A picture of `width` x `height` pixels; row 0 is the bottom, the sample of a pixel is its centre.

    width, height: pixels, 1 to 16384.
    subpixel_bits: window positions are snapped to 1/2^subpixel_bits pixel, 0 to 8 bits.
    Raises SceneError for a size or a precision outside these limits.
    """

    width: int
    height: int
    subpixel_bits: int = FINEST

    def __post_init__(self) -> None:
        if not (1 <= self.width <= LARGEST and 1 <= self.height <= LARGEST):
            raise SceneError(
                f"picture size: expected 1 to {LARGEST} pixels a side, got {self.width} x {self.height}; "
                "choose a smaller picture"
            )
        if not 0 <= self.subpixel_bits <= FINEST:
            raise SceneError(
                f"subpixel_bits: expected 0 to {FINEST}, got {self.subpixel_bits}; most graphics processors have 8 or 4"
            )

    @property
    def step(self) -> int:
        """The distance of two neighbouring samples in snapped units, 2^subpixel_bits."""
        return 1 << self.subpixel_bits
