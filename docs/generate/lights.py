"""A sheet of the bust in ten random lights, to be looked at where preset robust is changed.

    python docs/generate/lights.py SHEET.png [--seed N] [--size N]

Each picture has one or two point lights anywhere around the bust, white or coloured, the same for a seed on every
machine. Prints where they are.
"""

import argparse
from typing import Any

import numpy as np
from PIL import Image

import sss_ref
from sss_ref.pictures.png_file import encoding_of

PICTURES, IN_A_ROW = 10, 5
DISTANCE = (2.5, 5.0)  # scene units from the middle of the bust


def main() -> None:
    """Draw the sheet."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sheet")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--size", type=int, default=384)
    asked = parser.parse_args()
    random = np.random.Generator(np.random.PCG64(asked.seed))
    size = asked.size
    sheet = Image.new("RGB", (IN_A_ROW * size, PICTURES // IN_A_ROW * size))
    for number in range(PICTURES):
        lights = [light(random) for _ in range(1 + number % 2)]
        print(number, lights)
        drawn = {"camera.width": size, "camera.height": size, "camera.azimuth": float(random.integers(-60, 60))}
        scene = sss_ref.load_scene("figure3_with", lights=lights, **drawn)
        codes = encoding_of(scene.settings)(sss_ref.render(scene).image)
        sheet.paste(Image.fromarray(codes[::-1]), (number % IN_A_ROW * size, number // IN_A_ROW * size))
    sheet.save(asked.sheet)


def light(random: np.random.Generator) -> dict[str, Any]:
    """A light from any direction, a little warm or a little cold."""
    azimuth, height, away, warmth = (random.random() for _ in range(4))
    return {
        "azimuth": round(360 * azimuth, 1),
        "elevation": round(140 * height - 60, 1),
        "distance": round(DISTANCE[0] + away * (DISTANCE[1] - DISTANCE[0]), 2),
        "color": [1.0, round(0.95 - 0.35 * warmth, 2), round(1.0 - 0.6 * warmth, 2)],
    }


if __name__ == "__main__":
    main()
