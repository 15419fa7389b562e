"""The pictures of the README and of the site's first page, all made by the code.

python docs/generate/images.py                # needs the extras `docs` and `test`; writes into docs/images
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from PIL import Image, ImageDraw

import sss_ref
from sss_ref.cli import main
from sss_ref.pictures.lettering import BRIGHT, font
from sss_ref.pictures.overview import write_overview
from sss_ref.pictures.png_file import encoding_of, image_encoding_of, write_png
from sss_ref.rendering.samples import render_samples
from sss_ref.scene.catalogue import METHODS, TECHNIQUES
from sss_ref.scene_file.kernels import TABLE1
from sss_ref.truth.material_fit import fitted_material
from sss_ref.truth.media import volumes
from sss_ref.truth.radiance import nothing_gathered
from sss_ref.yardstick.ladder import Ladder
from sss_ref.yardstick.ladder_pictures import SPAN, colour_bar, exposed, signed

ROOT = Path(__file__).parents[2]
IMAGES = ROOT / "docs" / "images"
SIDE = 512
GALLERY = ("figure3_with", "teeth_layers_backlit", "wax", "glass", "figure5")

sys.path[:0] = [str(ROOT / folder) for folder in ("tests/support", "benchmarks")]


def scene(name: str, **overrides: float | str) -> sss_ref.Scene:
    """A shipped scene, 512 x 512."""
    return sss_ref.load_scene(name, **{"camera.width": SIDE, "camera.height": SIDE}, **overrides)


def poster(path: Path) -> None:
    """The default scene with smooth edges, on nothing."""
    shown = scene("default")
    result = render_samples(shown, 4)
    write_png(path, result.foreground, result.coverage, image_encoding_of(shown.settings))


def overview(path: Path) -> None:
    """Every stage of a picture, the sheet at half its size."""
    with TemporaryDirectory() as folder:
        whole = Path(folder, "overview.png")
        write_overview(whole, sss_ref.render(scene("figure3_with")))
        sheet = Image.open(whole)
        sheet.reduce(2).save(path, quality=85)


def validation(path: Path) -> None:
    """A fault that no eye sees, and the pixels where `validate` finds it."""
    from sss_ref.course import figures

    right = sss_ref.render(scene("figure3_with"))
    wrong = sss_ref.render(scene("figure3_with", **{"translucency.exponent": 0.751}))
    finding = sss_ref.validate(right, dict(wrong.buffers)).finding
    assert finding is not None
    check = finding.check
    apart = np.abs(check.got.astype(np.float64) - check.expected)
    outside = check.where & (apart > check.reach)
    figure, axes = figures.row(3, height=3.0, width=3.1)
    figures.picture(axes[0], right.image, "exponent 0.75: the reference")
    figures.picture(axes[1], wrong.image, "exponent 0.751: a shader's mistake")
    times = apart / np.maximum(check.reach, 1e-12)
    figures.values(axes[2], times, "translucency, out of reach", "times what is allowed", outside)
    path.write_bytes(figures.png_of(figure))


def gallery(path: Path) -> None:
    """Five of the shipped scenes beside each other."""
    strip = Image.new("RGB", (len(GALLERY) * SIDE // 2, SIDE // 2))
    for place, name in enumerate(GALLERY):
        shown = scene(name)
        codes = image_encoding_of(shown.settings)(render_samples(shown, 2).image)
        strip.paste(Image.fromarray(codes[::-1]).reduce(2), (place * SIDE // 2, 0))
    strip.save(path, optimize=True)


def techniques(path: Path) -> None:
    """Every method on the same head with hard shadows, and below it a part at four times the size: where one ends."""
    part, label, columns = (165, 300, 293, 428), 24, 3  # the part from its upper left to its lower right, in pixels
    methods, half = (*METHODS, *TECHNIQUES), SIDE // 2
    sheet = Image.new("RGB", (columns * half, len(methods) // columns * (label + SIDE)), (22, 25, 31))
    for place, method in enumerate(methods):
        shown = scene("figure3_with", method=method, **{"shadow_map.test": "slope"})
        picture = Image.fromarray(encoding_of(shown.settings)(sss_ref.render(shown, keep="final").image)[::-1])
        left, top = place % columns * half, place // columns * (label + SIDE)
        ImageDraw.Draw(sheet).text((left + 10, top + 4), method, BRIGHT, font(14))
        sheet.paste(picture.reduce(2), (left, top + label))
        enlarged = picture.crop(part).resize((half, half), Image.Resampling.NEAREST)
        sheet.paste(enlarged, (left, top + label + half))
    sheet.save(path, optimize=True)


def measure(path: Path) -> None:
    """Two bodies: the truth, every technique with fitted keys, and below what lies between them."""
    from measure import yardstick_of

    fit = fitted_material(volumes("skin2"), 40_000, diffuse=True)
    scenes = [yardstick_of(name, 96) for name in ("bust", "sphere")]
    beside_the_truth([Ladder(of, nothing_gathered(of.tracing).more(160), fit, ()) for of in scenes]).save(path)


def beside_the_truth(bodies: list[Ladder]) -> Image.Image:
    """For each body a row of pictures with one exposure, and one of signed differences under its techniques."""
    side, gap, label = 144, 4, 22
    columns = 1 + len(METHODS | TECHNIQUES)
    sheet = Image.new("RGB", (columns * (side + gap) - gap, len(bodies) * 2 * (side + gap) + label), (22, 25, 31))
    draw = ImageDraw.Draw(sheet)

    def put(pixels: np.ndarray, column: int, row: int, height: int = side) -> None:
        tile = Image.fromarray(np.ascontiguousarray(pixels[::-1])).resize((side, height), Image.Resampling.NEAREST)
        sheet.paste(tile, (column * (side + gap), label + row * (side + gap)))

    for body, ladder in enumerate(bodies):
        assert ladder.fit is not None
        keys = ladder.fit.keys(ladder.of.given.settings.mm_per_unit, ladder.fit.nearer_law)
        put(exposed(ladder.truth.mean, ladder.truth), 0, 2 * body)
        for column, method in enumerate((*METHODS, *TECHNIQUES), start=1):
            image = sss_ref.render(ladder.of.scene_of(method, keys), keep="final").image
            put(exposed(image, ladder.truth), column, 2 * body)
            put(signed(image, ladder.truth, ladder.masks["everywhere"]), column, 2 * body + 1)
    for column, name in enumerate(("truth", *METHODS, *TECHNIQUES)):
        draw.text((column * (side + gap) + 4, 4), name, BRIGHT, font(13))
    put(colour_bar(side, 1), 0, 1, 12)
    draw.text((4, label + side + gap + 18), f"{SPAN:.0%} of white darker\n... {SPAN:.0%} brighter", BRIGHT, font(12))
    return sheet


def kernel(path: Path) -> None:
    """The paper's Table 1 as notebook 4 draws it."""
    from sss_ref.course import figures

    taps = np.array(TABLE1)
    figure, axes = figures.row(3, height=3.0)
    for panel, channel, name in zip(axes, range(3), ("red", "green", "blue"), strict=True):
        figures.taps(panel, taps[:, :2], taps[:, 2 + channel], name, figures.CHANNELS[channel])
    path.write_bytes(figures.png_of(figure))


def relighting(path: Path) -> None:
    """The sweep of the page on relighting, as its contact sheet shows it."""
    text = (ROOT / "docs" / "how_to" / "relighting.md").read_text()
    with TemporaryDirectory() as folder:
        sweep = Path(folder, "candle.toml")
        sweep.write_text(text.partition("```toml\n")[2].partition("```")[0])
        main(["batch", str(sweep), "-o", f"{folder}/candle", "--video", "8", "--jobs", "1"])
        Image.open(f"{folder}/candle/contact_sheet.png").save(path, optimize=True)


def viewer(path: Path) -> None:
    """The page of `sss-ref view`, by Chromium and playwright."""
    from viewing import ViewerPage, chromium, viewing

    with viewing("default", "--port", "0") as process, chromium() as browser:
        page = ViewerPage(browser, process.address, 1300, 760).page
        page.select_option("#buffer", "image")
        page.screenshot(path=path, type="jpeg", quality=85)


PICTURES = {
    "poster.png": poster,
    "overview.jpg": overview,
    "validation.png": validation,
    "gallery.png": gallery,
    "techniques.png": techniques,
    "measure.png": measure,
    "kernel.png": kernel,
    "relighting.png": relighting,
    "viewer.jpg": viewer,
}


if __name__ == "__main__":
    for name, draw in PICTURES.items():
        draw(IMAGES / name)
