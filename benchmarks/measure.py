"""Every technique against the traced truth, on five bodies that come with the package.

    python benchmarks/measure.py --output measured

Prints for each body what `sss-ref measure` finds, then one table of all: mean error of radiance and delta E 2000. With
--output it leaves the pages in a folder, and goes on from the truths there. `head` is the bust again, in two lights.
"""

import argparse
import time
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from sss_ref.scene_file.reading import opened
from sss_ref.truth.material_fit import MaterialFit, fitted_material
from sss_ref.truth.media import volumes
from sss_ref.truth.truth_folder import begun, write_truth
from sss_ref.yardstick.ladder import Ladder, climbed
from sss_ref.yardstick.ladder_folder import TRUTH, write_ladder
from sss_ref.yardstick.ladder_table import as_markdown
from sss_ref.yardstick.rungs import ALL, FITTED, SHIPPED
from sss_ref.yardstick.yardstick import Yardstick

SLAB: Mapping[str, Any] = {  # 20 x 20 x 2 mm, its charts apart, lit from behind
    "mesh": {"path": "seam_cube", "scale": [1.0, 1.0, 0.1]},
    "camera": {"type": "orbit", "azimuth": 25.0, "elevation": 12.0, "distance": 5.0, "fov_y": 31.0},
    "lights": [{"position": [1.0, 1.5, -4.0]}],
}
BODIES: Mapping[str, tuple[str | Mapping[str, Any], str, str, float]] = {  # scene, medium, material, mm a unit
    "bust": ("figure3_with", "skin2", "skin", 150.0),
    "sphere": ("sphere", "skin2", "skin", 10.0),
    "slab": (SLAB, "skin2", "skin", 10.0),
    "head": ("default", "skin2", "skin", 150.0),
    "teeth": ("teeth_backlit", "enamel", "enamel", 1.0),
}


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=96, help="pixels a side")
    parser.add_argument("--samples", type=int, default=160, help="of the truth")
    parser.add_argument("--photons", type=int, default=40_000, help="of each walk that is fitted to")
    parser.add_argument("--output", type=Path, help="a folder for pages and truths")
    given = parser.parse_args()
    start, fits = time.process_time(), {}
    found: dict[str, Ladder] = {}
    with TemporaryDirectory() as temporary:
        for name, (_, medium, *_) in BODIES.items():
            fits[medium] = fits.get(medium) or fitted_material(volumes(medium), given.photons, diffuse=True)
            folder = (given.output or Path(temporary)) / name
            found[name] = measured(name, fits[medium], folder, given.size, given.samples)
            print(f"{name}: {medium}, {given.size} x {given.size}\n\n{as_markdown(found[name])}", flush=True)
    print(together(found))
    print(f"{time.process_time() - start:.0f} s of processor time")


def measured(name: str, fit: MaterialFit, folder: Path, size: int, samples: int) -> Ladder:
    """One body by all techniques; its page, record and truth in a folder."""
    of = yardstick_of(name, size)
    before = begun(folder / TRUTH, of.tracing)
    radiance = before.more(samples - before.samples) if before.samples < samples else before
    write_truth(folder / TRUTH, radiance)
    ladder = climbed(of, radiance, ALL, fit)
    write_ladder(ladder, folder)
    return ladder


def yardstick_of(name: str, size: int) -> Yardstick:
    """What one of the bodies is held against, so many pixels a side."""
    scene, medium, material, unit = BODIES[name]
    overrides = {"preset": "robust", "material": material, "mm_per_unit": unit}
    overrides |= {"camera.width": size, "camera.height": size}
    return Yardstick(uncoloured(scene), overrides, medium)


def uncoloured(scene: str | Mapping[str, Any]) -> Mapping[str, Any]:
    """A scene whose colour and light from behind are its material's, not those that somebody chose by eye."""
    data = dict(opened(scene).data)
    data["mesh"] = {key: value for key, value in data["mesh"].items() if key != "color"}
    return {key: value for key, value in data.items() if key not in ("translucency", "blur")}


def together(found: Mapping[str, Ladder]) -> str:
    """The table of all bodies."""
    lines = [f"| technique | {' | '.join(found)} |", "|---" + "|---:" * len(found) + "|"]
    noise = [cell(ladder.noise["everywhere"]) for ladder in found.values()]
    lines.append(f"| noise of the truth | {' | '.join(noise)} |")
    for parameters in (SHIPPED, FITTED):
        for method in ALL:
            name = f"{method}, {parameters}"
            cells = [cell(ladder.deviations[name]["everywhere"]) for ladder in found.values()]
            lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def cell(deviation: Any) -> str:
    """Mean error and delta E 2000."""
    color = "" if deviation.color is None else f", {deviation.color:.1f}"
    return f"{deviation.mean:.1%}{color}"


if __name__ == "__main__":
    main()
