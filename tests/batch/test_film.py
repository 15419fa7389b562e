import sys
from pathlib import Path
from types import SimpleNamespace

import imageio.v3 as imageio
import numpy as np
import pytest
from PIL import Image

from sss_ref.batch import film
from sss_ref.batch.film import write_films
from sss_ref.errors import DumpError

COLOURS = [(250, 10, 10), (10, 250, 10), (10, 10, 250)]


@pytest.fixture
def pictures(tmp_path):
    """Three of 15 x 9 pixels, each of one colour, the last half transparent."""
    paths = [tmp_path / f"{number}.png" for number in range(3)]
    for path, colour in zip(paths, COLOURS, strict=True):
        Image.new("RGB", (15, 9), colour).save(path)
    Image.new("RGBA", (15, 9), (*COLOURS[2], 128)).save(paths[2])
    return paths


def test_a_gif_has_every_picture_in_its_time(tmp_path, pictures, monkeypatch):
    monkeypatch.setattr(film, "has_encoder", lambda: False)
    assert write_films(tmp_path, "turn", pictures, 20) == [tmp_path / "turn.gif"]
    with Image.open(tmp_path / "turn.gif") as gif:
        assert (gif.n_frames, gif.info["duration"], gif.info["loop"]) == (3, 50, 0)
    found = imageio.imread(tmp_path / "turn.gif", index=None)
    assert found.shape == (3, 9, 15, 3)
    assert [tuple(frame[4, 7]) for frame in found] == [*COLOURS[:2], (5, 5, 125)]


def test_an_mp4_has_every_picture_and_even_sides(tmp_path, pictures):
    pytest.importorskip("imageio_ffmpeg", reason="needs the extra video")
    assert write_films(tmp_path, "turn", pictures, 20)[1] == tmp_path / "turn.mp4"
    found = np.stack(list(imageio.imiter(tmp_path / "turn.mp4", plugin="FFMPEG")))
    assert found.shape == (3, 10, 16, 3)
    expected = np.array([*COLOURS[:2], (5, 5, 125)])
    assert np.abs(found.mean(axis=(1, 2)) - expected).max() < 12  # H.264 is lossy, and its colours another space


@pytest.mark.parametrize(
    ("size", "even"), [((15, 9), (16, 10)), ((14, 9), (14, 10)), ((15, 8), (16, 8)), ((14, 8), (14, 8))]
)
def test_an_encoder_gets_the_last_pixels_twice_where_a_side_is_odd(tmp_path, monkeypatch, size, even):
    """In the place of ffmpeg, which not everyone has: what it is asked for and sent."""
    asked, sent = [], []

    def write_frames(path, size, **settings):
        asked.append((size, settings))
        Path(path).write_bytes(b"a film")
        while True:
            sent.append((yield))

    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", SimpleNamespace(write_frames=write_frames))
    monkeypatch.setattr(film, "has_encoder", lambda: True)
    width, height = size
    paths, rows = [tmp_path / "a.png", tmp_path / "b.png"], np.arange(height * width * 3, dtype=np.uint8)
    pictures = [rows.reshape(height, width, 3), 255 - rows.reshape(height, width, 3)]
    for path, picture in zip(paths, pictures, strict=True):
        Image.fromarray(picture).save(path)
    assert write_films(tmp_path, "turn", paths, 7) == [tmp_path / "turn.gif", tmp_path / "turn.mp4"]
    settings = {"fps": 7, "quality": 8, "macro_block_size": 1, "ffmpeg_log_level": "error"}
    assert asked == [(even, settings)] and len(sent) == 2
    assert (tmp_path / "turn.mp4").read_bytes() == b"a film"
    for frame, picture in zip(sent, pictures, strict=True):
        assert frame.shape == (even[1], even[0], 3) and frame.flags.c_contiguous
        rows, columns = (np.minimum(np.arange(side), last - 1) for side, last in ((even[1], height), (even[0], width)))
        assert (frame == picture[rows][:, columns]).all()


@pytest.mark.parametrize(("rate", "milliseconds"), [(1, 1000), (24, 40), (30, 30), (60, 20), (100, 10)])
def test_a_gif_counts_hundredths_of_a_second(tmp_path, pictures, monkeypatch, rate, milliseconds):
    monkeypatch.setattr(film, "has_encoder", lambda: False)
    (path,) = write_films(tmp_path, "turn", pictures, rate)
    with Image.open(path) as gif:
        assert gif.info["duration"] == milliseconds


def test_pictures_of_two_sizes_and_none_are_told(tmp_path, pictures):
    Image.new("RGB", (8, 8)).save(pictures[1])
    with pytest.raises(DumpError, match=r"1.png: expected 15 x 9 pixels, as the first picture has, got 8 x 8 pixels"):
        write_films(tmp_path, "turn", pictures, 20)
    with pytest.raises(DumpError, match="film: expected pictures, got none"):
        write_films(tmp_path, "turn", [], 20)
