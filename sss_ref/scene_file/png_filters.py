"""The five prediction filters of PNG, undone; every byte depends on the one before, so this loop is compiled."""

from typing import Any

from sss_ref.cache.compiled import compiled

NONE, SUB, UP, AVERAGE, PAETH = range(5)


@compiled
def unfilter(lines: Any, step: int) -> None:
    """Replace filtered bytes by the original ones, in place.

    lines: uint8 (H, 1 + row bytes), the filter of a row first. step: bytes of a texel. PNG specification, section 9.
    """
    for row in range(lines.shape[0]):
        for i in range(1, lines.shape[1]):
            left = int(lines[row, i - step]) if i > step else 0
            above = int(lines[row - 1, i]) if row > 0 else 0
            corner = int(lines[row - 1, i - step]) if row > 0 and i > step else 0
            lines[row, i] = (int(lines[row, i]) + predicted(lines[row, 0], left, above, corner)) & 255


@compiled
def predicted(kind: int, left: int, above: int, corner: int) -> int:
    """What a filter expects of a byte from its neighbours."""
    if kind == SUB:
        return left
    if kind == UP:
        return above
    if kind == AVERAGE:
        return (left + above) // 2
    return paeth(left, above, corner) if kind == PAETH else 0


@compiled
def paeth(left: int, above: int, corner: int) -> int:
    """The neighbour nearest to left + above - corner; of equally near ones the first in this order."""
    to_left, to_above, to_corner = abs(above - corner), abs(left - corner), abs(left + above - 2 * corner)
    if to_left <= to_above and to_left <= to_corner:
        return left
    return above if to_above <= to_corner else corner
