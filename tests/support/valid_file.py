"""A valid file with what it refers to, before anything is changed; bytes as libraries write them."""

from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from PIL import Image


@dataclass(frozen=True)
class Valid:
    """Files by name, and what kind of thing the first of them is; `changeable` are those that a change may hit."""

    kind: str
    name: str
    files: dict[str, bytes]

    @property
    def first(self):
        """The file that is handed to the reader."""
        return next(iter(self.files))


def picture(width, height, channels):
    """A PNG file of so many channels: grey, grey and alpha, colours, colours and alpha."""
    values = np.random.default_rng(channels).integers(0, 256, (height, width, channels), np.uint8)
    values = values // 128 * 255 if channels == 1 else values
    image = Image.fromarray(values[..., 0] if channels == 1 else values)
    return made(lambda path, _: image.save(path), "a.png", None)


def made(write, name, content):
    """The bytes of a file as a library writes it."""
    with TemporaryDirectory() as folder:
        write(Path(folder) / name, content)
        return (Path(folder) / name).read_bytes()
