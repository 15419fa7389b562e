"""A picture of each lesson for the course's page: one of those that the lesson draws, taken from the built site.

    docs/build.sh && python docs/generate/lesson_pictures.py

The pictures are kept in docs/images/course, since the page that shows them is read before the lessons run.
"""

import re
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).parents[1]
PAGES = DOCS / "_build/html/generated/course"
TAKEN = {  # lesson -> which of its pictures, from 0
    "00_one_picture": 0,
    "01_light_and_distance": 1,
    "02_shadow_map": 3,
    "03_phong": 2,
    "04_blur": 0,
    "05_translucency": 5,
    "06_texture_space": 0,
    "07_screen_or_texture": 0,
    "08_float32": 2,
    "09_validate_your_shader": 0,
    "10_diffusion": 0,
    "11_taps_and_thickness": 2,
    "12_how_far": 1,
    "13_your_own_method": 0,
}
SIZE = 640, 320  # pixels at most


def main() -> None:
    """Take them all."""
    for lesson, number in TAKEN.items():
        sources = re.findall(r'<img[^>]+src="([^":]+_images/[^"]+)"', (PAGES / f"{lesson}.html").read_text())
        picture = Image.open(PAGES / sources[number]).convert("RGB")
        picture.thumbnail(SIZE, Image.Resampling.LANCZOS)
        picture.save(DOCS / "images/course" / f"{lesson}.jpg", quality=88)
        print(lesson, *picture.size)


if __name__ == "__main__":
    main()
