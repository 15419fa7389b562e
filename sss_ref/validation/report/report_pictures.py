"""The buffer that is wrong, in pictures: as drawn, as it should be, each pixel's outcome, and how far off it is."""

from collections.abc import Iterator

import numpy as np

from sss_ref.pictures import tiles
from sss_ref.pictures.self_contained import data_url
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.verdict.outcomes import (
    AMBIGUOUS,
    CERTAIN,
    FAIL,
    NOT_COMPARED,
    OUTCOMES,
    UNBOUNDED,
    UNDEFINED,
    outcome_map,
)

LARGEST_SIDE = 640  # pixels of a picture in the page; a larger one is thinned
COLOURS = {
    CERTAIN: (47, 143, 91),
    AMBIGUOUS: (214, 162, 58),
    FAIL: (226, 70, 52),
    UNDEFINED: (146, 104, 190),
    UNBOUNDED: (84, 128, 190),
}  # sRGB
COVERED = np.array([tiles.GROUND, COLOURS[AMBIGUOUS], COLOURS[CERTAIN]], np.uint8)  # by MUST_NOT, MAY, MUST
BY_WEIGHT = (NOT_COMPARED, CERTAIN, AMBIGUOUS, UNBOUNDED, UNDEFINED, FAIL)  # the last is shown where pixels are thinned
DECADES = 3  # below and above its reach that the picture of the distance spans


def css_colour(outcome: str) -> str:
    """The colour of one of OUTCOMES."""
    return "#{:02x}{:02x}{:02x}".format(*COLOURS[OUTCOMES.index(outcome)])


def legend() -> str:
    """What the colours stand for, as HTML."""
    keys = "".join(f'<span><i style="background:{css_colour(name)}"></i>{name}</span>' for name in OUTCOMES)
    return f'<p class="legend">{keys}</p>'


def pictures(check: Check) -> Iterator[tuple[str, str]]:
    """Captions and pictures, the latter as data URLs."""
    step = -(-max(check.where.shape) // LARGEST_SIDE)
    for caption, buffer in (("as drawn", check.got), ("as it should be", check.expected)):
        buffer = np.nan_to_num(buffer)
        spread = tiles.value_range(buffer, check.where)
        yield (
            caption,
            data_url(tiles.picture(check.buffer, buffer[::step, ::step], check.where[::step, ::step], spread)),
        )
    yield "what became of each pixel", data_url(_outcome_picture(check, step))
    if check.covered is not None:
        yield "green must be covered, yellow may be", data_url(COVERED[_most_in_blocks(check.covered, step)])
    if check.expected.dtype.kind == "f":
        yield "how far off: dark far within its reach, bright far beyond", data_url(_distance_picture(check, step))


def _outcome_picture(check: Check, step: int) -> np.ndarray:
    """Every pixel in the colour of its outcome, thinned so that no wrong one is lost."""
    weights = np.zeros(256, np.uint8)
    weights[list(BY_WEIGHT)] = range(len(BY_WEIGHT))
    colours = np.array([tiles.GROUND, *(COLOURS[each] for each in BY_WEIGHT[1:])], np.uint8)
    return colours[_most_in_blocks(weights[outcome_map(check)], step)]


def _distance_picture(check: Check, step: int) -> np.ndarray:
    """The distance from what is expected as a share of its reach, on a logarithmic scale."""
    expected, got, reach = (
        np.atleast_3d(array).astype(np.float64) for array in (check.expected, check.got, check.reach)
    )
    with np.errstate(all="ignore"):
        apart = np.abs(got - expected)
        same = (got == expected) | (np.isnan(got) & np.isnan(expected))
        share = np.where(same, 0.0, apart / reach).max(axis=-1)
        decades = np.nan_to_num(np.log10(share), nan=DECADES, posinf=DECADES, neginf=-DECADES)
    shown = tiles.RAMP[tiles.stretched(_most_in_blocks(decades, step), -DECADES, DECADES)]
    return tiles.over_ground(shown, _most_in_blocks(check.where.astype(np.uint8), step) != 0)


def _most_in_blocks(values: np.ndarray, step: int) -> np.ndarray:
    """The largest value in every block of step x step pixels."""
    rows, columns = (-(-side // step) for side in values.shape)
    padding = [(0, count * step - side) for count, side in zip((rows, columns), values.shape, strict=True)]
    return np.pad(values, padding, mode="edge").reshape(rows, step, columns, step).max(axis=(1, 3))
