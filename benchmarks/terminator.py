"""How dark the line between light and shade is on a shipped scene, and how bright its thin rims.

    python benchmarks/terminator.py [SCENE ...] [--size N] [--set KEY=NUMBER ...]

Each light is looked at alone, without highlights. A row is a run of pixels on one line of the picture along which N.L
goes from .4 to -.4 and never turns back; its dip is how far the deepest valley of luminance lies below the lower of the
two heights beside it, as a share of that. Some rows have a valley for another reason, which is measured, in this order:

  shadowed   another part stands before the light: a pixel with N.L > .05 is not directly lit, or the thickness jumps by
             7.5 mm from one pixel to the next
  thin       where N.L is -.4 the body is thinner than 15 mm: the rim glows, as it should
  thinner    on the way into the dark the body gets thinner again, by 1 mm and more

What is left, open, is the terminator alone. The last table is of the bust of figure3_with with its light right behind
it: thickness and luminance, medians over the rows of an ear, at so many mm from the outline; at 32 mm it is the cheek.
"""

import argparse
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

import sss_ref
from sss_ref.language.names import Name

LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
STEEPEST = 0.4  # |N.L| at the ends of a row
ENOUGH = 0.75  # of the way from .4 to -.4 that the pixels' centres must have gone
SHORTEST = 6  # pixels
JUMP_MM, THIN_MM, FALL_MM = 7.5, 15.0, 1.0
CLASSES = ("shadowed", "thin", "thinner", "open")
EAR = {"camera.azimuth": 0.0, "camera.elevation": 0.0, "lights.0.position": [0.0, 0.6, -4.0], "phong.specular": 0.0}
EAR_ROWS = (0.5, 0.64)  # of the picture's height, from below
FROM_OUTLINE_MM = (1, 2, 3, 4, 6, 8, 16, 32)


def main() -> None:
    """Print one line per scene, light and class of rows; then the rim."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", default=["figure3_with", "default"])
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--set", action="append", default=[], metavar="KEY=NUMBER", help="a key of the scenes")
    asked = parser.parse_args()
    given = {key: float(number) for key, _, number in (each.partition("=") for each in asked.set)}
    given |= {"camera.width": asked.size, "camera.height": asked.size, "phong.specular": 0.0}
    print(f"{'scene':16} light  {'rows':10} {'number':>6} {'median':>7} {'p90':>7} {'deepest':>7} {'> 2 %':>6}")
    for name in asked.scenes:
        for light in range(len(sss_ref.load_scene(name).lights)):
            for kind, dips in classified(name, light, given).items():
                print(f"{name:16} {light + 1:5}  {kind:10} {line(np.array(dips))}", flush=True)
    print(f"\n{'mm from outline':>15} {'mm thick':>9} {'luminance':>9}")
    for away, thickness, brightness in rim({**given, **EAR}):
        print(f"{away:15} {thickness:9.1f} {brightness:9.3f}")


def line(dips: NDArray[np.float64]) -> str:
    """How many rows, and of their dips the median, the 90th percentile, the deepest, and the share beyond 2 %."""
    if not len(dips):
        return f"{0:6}"
    half, most, deepest = np.percentile(dips, (50, 90, 100))
    return f"{len(dips):6} {half:7.1%} {most:7.1%} {deepest:7.1%} {(dips > 0.02).mean():6.0%}"


def classified(name: str, light: int, given: dict[str, float]) -> dict[str, list[float]]:
    """Class -> dips of its rows, in the light of one lamp, by its place in the scene."""
    others = set(range(len(sss_ref.load_scene(name).lights))) - {light}
    alone = {f"lights.{other}.intensity": 0.0 for other in others}
    result = sss_ref.render(sss_ref.load_scene(name, **given, **alone))
    number = light + 1 if others else 0
    brightness = result.image @ LUMINANCE
    found: dict[str, list[float]] = {kind: [] for kind in CLASSES}
    for row, run, cosine in rows(result, light):
        thickness = result[str(Name("thickness", number))][row, run] * result.scene.settings.mm_per_unit
        lit = result[str(Name("directly_lit", number))][row, run] == 1
        found[class_of(cosine, thickness, lit)].append(dip(brightness[row, run]))
    return found


def rows(result: sss_ref.Result, light: int) -> Iterator[tuple[int, NDArray[np.int_], NDArray[np.float64]]]:
    """The line of the picture, the pixels from the lit to the dark end, and N.L at each."""
    way = result.scene.lights[light].position - result["position_world"]
    cosine = (result["normal_world"] * way).sum(axis=-1) / np.linalg.norm(way, axis=-1)
    near = (result["coverage"] == 1) & (np.abs(cosine) < STEEPEST)
    for row in range(len(near)):
        pixels = np.flatnonzero(near[row])
        for run in np.split(pixels, np.flatnonzero(np.diff(pixels) > 1) + 1):
            along = cosine[row, run]
            if len(run) >= SHORTEST and np.ptp(along) > ENOUGH * 2 * STEEPEST:
                inwards = run if along[0] > 0 else run[::-1]
                if (np.diff(cosine[row, inwards]) <= 0).all():
                    yield row, inwards, cosine[row, inwards]


def class_of(cosine: NDArray[np.float64], thickness: NDArray[np.float64], lit: NDArray[np.bool_]) -> str:
    """Why a row may have a valley; thickness in mm."""
    if ((cosine > 0.05) & ~lit).any() or np.abs(np.diff(thickness)).max() > JUMP_MM:
        return "shadowed"
    if thickness[-1] < THIN_MM:
        return "thin"
    dark = thickness[cosine < 0]
    return "thinner" if (np.maximum.accumulate(dark) - dark).max() > FALL_MM else "open"


def dip(values: NDArray[np.float64]) -> float:
    """How far the deepest valley lies below the lower of the two heights on its sides, as a share of that."""
    heights = np.minimum(np.maximum.accumulate(values), np.maximum.accumulate(values[::-1])[::-1])
    return float(((heights - values) / heights).max())


def rim(given: dict[str, Any]) -> Iterator[tuple[int, float, float]]:
    """Distance from the outline of the ear in mm, thickness in mm, luminance."""
    result = sss_ref.render(sss_ref.load_scene("figure3_with", **given))
    first, end = (round(share * len(result.image)) for share in EAR_ROWS)
    outline = [np.flatnonzero(line)[-1] for line in result["coverage"][first:end]]
    lines = np.arange(first, end)
    steps = result["mm_per_pixel"][lines, outline]
    for away in FROM_OUTLINE_MM:
        at = lines, np.round(outline - away / steps).astype(int)
        thickness = np.median(result["thickness"][at]) * result.scene.settings.mm_per_unit
        yield away, float(thickness), float(np.median(result.image[at] @ LUMINANCE))


if __name__ == "__main__":
    main()
