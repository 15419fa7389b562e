"""Pictures one after the other: as MP4 (H.264) by ffmpeg, and as GIF."""

from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from sss_ref.errors import DumpError
from sss_ref.errors.whole_file import whole_file
from sss_ref.errors.wording import told

ENCODER = "imageio_ffmpeg"  # the module of the extra `video`
QUALITY = 8  # of 0 to 10, imageio-ffmpeg's scale


def write_films(folder: Path, stem: str, pictures: Sequence[Path], rate: int) -> list[Path]:
    """Write STEM.gif, and STEM.mp4 where the extra `video` is installed; returns the files.

    pictures: PNG files of one size; where they are transparent, they are laid over black. rate: of them, per second.
    Raises DumpError where there is none, or one has another size.
    """
    check_sizes(pictures)
    paths = [folder / f"{stem}.gif"]
    with whole_file(paths[0]) as hidden:
        _write_gif(hidden, pictures, rate)
    if has_encoder():
        paths.append(folder / f"{stem}.mp4")
        with whole_file(paths[1]) as hidden:
            _write_mp4(hidden, pictures, rate)
    return paths


def has_encoder() -> bool:
    """Whether MP4 can be written."""
    return find_spec(ENCODER) is not None


def check_sizes(pictures: Sequence[Path]) -> None:
    """Raise DumpError unless there are pictures, all of the size of the first."""
    from PIL import Image

    if not pictures:
        raise DumpError("film: expected pictures, got none; see which items failed")
    sizes = {}
    for path in pictures:
        with Image.open(path) as picture:
            sizes[picture.size] = path
    if len(sizes) > 1:
        (first, _), (other, path), *_ = sizes.items()
        expected, came = (f"{width} x {height} pixels" for width, height in (first, other))
        raise DumpError(told(str(path), f"{expected}, as the first picture has", came, "vary no size"))


def frames(pictures: Sequence[Path]) -> Iterator[np.ndarray]:
    """The pictures as sRGB uint8 (H, W, 3), top row first, over black."""
    from PIL import Image

    for path in pictures:
        with Image.open(path) as picture:
            black = Image.new("RGBA", picture.size, "black")
            yield np.asarray(Image.alpha_composite(black, picture.convert("RGBA")).convert("RGB"))


def _write_gif(path: Path, pictures: Sequence[Path], rate: int) -> None:
    """Repeated without end. The format counts hundredths of a second."""
    import imageio.v3 as imageio

    imageio.imwrite(path, list(frames(pictures)), extension=".gif", duration=round(100 / rate) * 10, loop=0)


def _write_mp4(path: Path, pictures: Sequence[Path], rate: int) -> None:
    """Colour has half the resolution, as players expect, so sizes are even: an odd one gets its last pixels twice."""
    import imageio_ffmpeg

    height, width, _ = next(frames(pictures[:1])).shape
    size = width + width % 2, height + height % 2
    writer = imageio_ffmpeg.write_frames(
        str(path), size, fps=rate, quality=QUALITY, macro_block_size=1, ffmpeg_log_level="error"
    )
    writer.send(None)
    for frame in frames(pictures):
        writer.send(np.ascontiguousarray(np.pad(frame, ((0, height % 2), (0, width % 2), (0, 0)), mode="edge")))
    writer.close()
