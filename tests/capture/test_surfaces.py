"""What is known of a picture without a name, and which pictures a folder has."""

from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from PIL import Image

from sss_ref.capture.surfaces import Unnamed, surfaces_of
from sss_ref.dump.loss import Loss
from sss_ref.dump.texels import StoredTexels
from sss_ref.errors import DumpError


def unnamed(data, channels="RGBA", storage="float32", file="a.npy", loss=None, **more):
    data = np.asarray(data)
    data = data.reshape(*data.shape[:2], -1)
    return Unnamed(Path(file), StoredTexels(data, tuple(channels[: data.shape[2]]), storage, loss=loss), **more)


def test_a_size_is_width_and_height():
    assert unnamed(np.zeros((2, 5))).size == (5, 2)


def test_values_are_numbers_and_what_is_none_is_0():
    found = unnamed(np.float32([[np.nan, np.inf, -np.inf, -3]])).values
    assert found.dtype == np.float64 and found[0, :, 0].tolist() == [0, 0, 0, -3]
    assert unnamed(np.uint8([[0, 51, 255]]), storage="unorm8").values.ravel() == pytest.approx([0, 0.2, 1], abs=1e-7)


def test_values_may_be_off_by_half_a_step_and_a_little():
    assert unnamed(np.uint8([[0, 255]]), storage="unorm8").tolerance.ravel() == pytest.approx([0.51 / 255] * 2)
    assert unnamed(np.float16([[4]]), storage="float16").tolerance.item() == pytest.approx(0.51 * 4 / 1024)
    assert unnamed(np.float32([[4]])).tolerance.item() == 0
    assert unnamed(np.float32([[4]]), loss=Loss(least=0.5)).tolerance.item() == pytest.approx(0.255)


def test_the_content_is_the_same_upside_down_and_with_channels_in_another_order():
    data = np.arange(12, dtype=np.float32).reshape(2, 2, 3)
    content = unnamed(data).content
    assert unnamed(data[::-1]).content == unnamed(data[..., ::-1]).content == unnamed(data[::-1, :, [1, 0, 2]]).content
    assert unnamed(data[:, ::-1]).content != content != unnamed(data + 1).content


@pytest.mark.parametrize(
    ("rows", "blank", "even"),
    [
        ([[1, 1], [1, 1]], True, True),
        ([[1, 1], [1, 2]], False, False),
        ([[1, 2], [1, 2]], False, True),
        ([[1, 2], [3, 4], [1, 2]], False, True),
        ([[2, 1], [1, 1]], False, False),
        ([[1]], True, True),
    ],
)
def test_what_is_blank_and_what_is_the_same_upside_down(rows, blank, even):
    found = unnamed(np.float32(rows))
    assert (found.is_blank, found.is_even) == (blank, even)


@pytest.mark.parametrize(
    ("channels", "last", "opacity"),
    [
        ("RGBA", (0, 1), 3),
        ("RGBA", (0, 0.5), None),
        ("RGBX", (0, 1), None),
        ("ARGB", (0, 1), None),
        ("RGA", (0, 1), None),
    ],
)
def test_an_opacity_is_0_or_1_of_four_channels(channels, last, opacity):
    data = np.full((1, 2, len(channels)), 0.25, np.float32)
    data[0, :, -1] = last
    assert unnamed(data, channels).opacity == opacity
    if channels == "ARGB":
        data[0, :, 0] = last
        assert unnamed(data, channels).opacity == 0


@pytest.mark.parametrize(("file", "origin"), [("a.npy", "bottom"), ("a.PFM", "bottom"), ("a.png", "top")])
def test_the_row_that_files_of_a_kind_begin_with(file, origin):
    assert unnamed(np.zeros((1, 1)), file=file).usual_origin == origin


def test_what_a_mapping_file_says_of_where_it_is():
    alone = unnamed(np.zeros((1, 1, 3)), file="in/a.npy")
    part = unnamed(np.zeros((1, 1, 3)), part="left", given={"encoding": "unorm8"})
    assert alone.keys((2, 0), "top") == {"file": "a.npy", "channels": ["B", "R"], "origin": "top"}
    assert part.keys((1,), "bottom") == {
        "file": "a.npy",
        "part": "left",
        "channels": ["G"],
        "origin": "bottom",
        "encoding": "unorm8",
    }
    assert (str(alone), str(part)) == ("a.npy", "a.npy (left: R, G, B)")


def exr(path, *parts):
    """Name and channels of each part, all 2 x 2."""
    form = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    planes = [{channel: np.full((2, 2), k, np.float32) for k, channel in enumerate(each)} for _, each in parts]
    named = [form | ({"name": name} if name else {}) for name, _ in parts]
    OpenEXR.File([OpenEXR.Part(*each) for each in zip(named, planes, strict=True)]).write(str(path))


def test_the_surfaces_of_a_folder_by_name_and_what_is_none(tmp_path):
    """A file's only surface needs no part; layers and parts are surfaces of their own."""
    exr(tmp_path / "a.exr", ("", "RGB"))
    exr(tmp_path / "b.exr", ("", ["m.X", "n.X", "n.Y", "Z"]))
    exr(tmp_path / "c.exr", ("left", "R"), ("right", "G"))
    Image.fromarray(np.zeros((2, 2), np.uint8)).save(tmp_path / "d.png")
    (tmp_path / "e.txt").write_text("none")
    (tmp_path / "f").write_text("none")
    (tmp_path / "g.raw").write_bytes(bytes(4))
    (tmp_path / "h.npy").mkdir()
    found, notes = surfaces_of(tmp_path)
    assert [(each.path.name, each.part, sorted(each.channels)) for each in found] == [
        ("a.exr", None, ["B", "G", "R"]),
        ("b.exr", "0", ["Z"]),
        ("b.exr", "0", ["m.X"]),
        ("b.exr", "0", ["n.X", "n.Y"]),
        ("c.exr", "left", ["R"]),
        ("c.exr", "right", ["G"]),
        ("d.png", None, ["R"]),
    ]
    assert found[3].values[0, 0].tolist() == [1, 2], "its own channels, not the first ones"
    said = [note.removeprefix(f"{tmp_path}/").partition(" (")[0] for note in notes]
    assert said[:2] == ["e.txt: expected a picture", "f: expected a picture"]
    assert notes[1].endswith("got no suffix; it is left out") and "got .txt" in notes[0]
    assert said[2] == "g.raw: expected a file that gives its shape, got raw bytes; write a mapping file"


def test_channels_that_a_compression_has_spoiled_are_no_surface(tmp_path):
    noise = np.random.default_rng(1).random((64, 64)).astype(np.float32)
    form = {"compression": OpenEXR.DWAA_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(form, {name: noise.copy() for name in ("R", "Z")}).write(str(tmp_path / "a.exr"))
    (only,), notes = surfaces_of(tmp_path)
    assert only.channels == ("Z",) and only.part is None and not notes
    assert np.array_equal(only.values[..., 0], noise.astype(np.float64))


def test_a_folder_without_pictures_or_none(tmp_path):
    with pytest.raises(
        DumpError, match=r": expected pictures \(\.npy, .*\), got none that can be read; give the folder"
    ):
        surfaces_of(tmp_path)
    with pytest.raises(DumpError, match="none: expected a folder, got No such file or directory; check the path"):
        surfaces_of(tmp_path / "none")
