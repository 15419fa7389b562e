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


def test_pictures_of_two_sizes_and_none_are_told(tmp_path, pictures):
    Image.new("RGB", (8, 8)).save(pictures[1])
    with pytest.raises(DumpError, match=r"1.png: expected 15 x 9 pixels, as the first picture has, got 8 x 8 pixels"):
        write_films(tmp_path, "turn", pictures, 20)
    with pytest.raises(DumpError, match="film: expected pictures, got none"):
        write_films(tmp_path, "turn", [], 20)
