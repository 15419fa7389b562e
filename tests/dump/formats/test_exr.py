import numpy as np
import OpenEXR
import pytest

from sss_ref.dump.files import parts_of
from sss_ref.dump.formats.exr_compression import is_spoiled
from sss_ref.errors import DumpError

FORM = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}


def planes(kind, names, seed=1):
    """A plane of arbitrary values for each channel."""
    generator = np.random.default_rng(seed)
    return {name: (generator.random((4, 6)) * 1000).astype(kind) for name in names}


def write(path, *parts):
    """Name and channels of each part; OpenEXR gets copies, because it replaces the arrays by objects of its own."""
    OpenEXR.File(
        [OpenEXR.Part(FORM | ({"name": name} if name else {}), dict(channels)) for name, channels in parts]
    ).write(str(path))


@pytest.mark.parametrize(("kind", "storage"), [("f4", "float32"), ("f2", "float16"), ("u4", "uint32")])
def test_every_type(tmp_path, kind, storage):
    channels = planes(kind, "RGB")
    if kind == "u4":
        channels["R"][0, 0] = 4294967295
    write(tmp_path / "x.exr", ("", channels))
    (texels,) = parts_of(tmp_path / "x.exr")
    assert texels.storage == storage and texels.data.dtype == kind
    assert sorted(texels.channels) == sorted(channels)
    for index, name in enumerate(texels.channels):
        assert np.array_equal(texels.data[..., index], channels[name])


def test_parts_and_types_in_one_part(tmp_path):
    mixed = planes("f2", ["normal.x", "normal.y"], 2) | planes("u4", ["id"], 3) | planes("f4", ["Z"], 4)
    write(tmp_path / "x.exr", ("a", planes("f4", "Y")), ("b", mixed))
    found = {(texels.part, texels.channels): texels for texels in parts_of(tmp_path / "x.exr")}
    assert set(found) == {("a", ("Y",)), ("b", ("normal.x", "normal.y")), ("b", ("id",)), ("b", ("Z",))}
    assert np.array_equal(found["b", ("normal.x", "normal.y")].data[..., 1], mixed["normal.y"])
    assert np.array_equal(found["b", ("id",)].data[..., 0], mixed["id"])


@pytest.mark.parametrize("missing", [10, 100])
def test_a_file_cut_off_is_refused(tmp_path, missing, capfd):
    write(tmp_path / "x.exr", ("a", planes("f4", "Y")), ("b", planes("f4", "Y", 2)))
    data = (tmp_path / "x.exr").read_bytes()
    (tmp_path / "x.exr").write_bytes(data[:-missing])
    with pytest.raises(DumpError, match=r"x\.exr: expected 2 whole parts, got [01]; "):
        parts_of(tmp_path / "x.exr")
    assert capfd.readouterr() == ("", "")  # the library tells the terminal


def test_no_exr_at_all(tmp_path, capfd):
    (tmp_path / "x.exr").write_bytes(b"nothing")
    with pytest.raises(DumpError, match=r"x\.exr: expected a whole EXR file, got one that is damaged"):
        parts_of(tmp_path / "x.exr")


def test_a_declared_size_is_checked_before_the_pixels_are_read(tmp_path):
    window = (np.zeros(2, np.int32), np.array([5, 3], np.int32))
    OpenEXR.File([OpenEXR.Part(FORM | {"dataWindow": window}, planes("f4", "Y"))]).write(str(tmp_path / "x.exr"))
    data = (tmp_path / "x.exr").read_bytes()
    corner = np.array([5, 3], "<i4").tobytes()
    (tmp_path / "x.exr").write_bytes(data.replace(corner, np.array([99999, 3], "<i4").tobytes()))
    with pytest.raises(DumpError, match="expected a width and a height from 1 to 16384, got 100000 x 4"):
        parts_of(tmp_path / "x.exr")


SMOOTH = np.sin(np.arange(64) / 9)[:, np.newaxis] * np.cos(np.arange(64) / 7) * 10 + 20
CHANNELS = ("R", "G", "B", "Y", "RY", "BY", "A", "Z", "r", "red", "Position.X", "Position.Y", "Position.Z", "n.R")
# Compression -> the types, and the channels, that it changes: OpenEXR's documentation, and its library asked.
OF_DWA = {"R", "G", "B", "Y", "RY", "BY", "Position.Y", "n.R"}
CHANGED = {
    **dict.fromkeys(("NO", "RLE", "ZIPS", "ZIP", "PIZ"), ("", set())),
    "PXR24": ("", set()),  # which is a storage of its own: see below
    "B44": ("f2", set(CHANNELS)),
    "B44A": ("f2", set(CHANNELS)),
    "DWAA": ("f2 f4", OF_DWA),
    "DWAB": ("f2 f4", OF_DWA),
}


@pytest.mark.parametrize("kind", ["f2", "f4", "u4"])
@pytest.mark.parametrize("compression", CHANGED)
def test_what_a_compression_changes_is_said_and_all_else_is_whole(tmp_path, compression, kind):
    noise = np.random.default_rng(1).random((64, 64))
    written = {name: (SMOOTH + noise).astype(kind) for name in CHANNELS}
    form = {"compression": getattr(OpenEXR, f"{compression}_COMPRESSION"), "type": OpenEXR.scanlineimage}
    OpenEXR.File(form, dict(written)).write(str(tmp_path / "x.exr"))
    (texels,) = parts_of(tmp_path / "x.exr")
    kinds, names = CHANGED[compression]
    assert texels.spoiled == (dict.fromkeys(names, compression) if kind in kinds.split() else {})
    whole = {name: np.array_equal(texels.data[..., i], written[name]) for i, name in enumerate(texels.channels)}
    if (compression, kind) == ("PXR24", "f4"):
        assert texels.storage == "float24" and not any(whole.values())
        assert texels.notes == ("its compression PXR24 keeps 24 bits of 32",)
        assert not (texels.data.view("u4") & 0xFF).any()
    else:
        assert {name for name in whole if not whole[name]} == set(texels.spoiled)


def test_the_newer_compressions_by_their_documentation():
    assert [is_spoiled("LJ2K", name, "f4") for name in ("R", "p.g", "blue", "Position.Y", "Z", "A")] == [True] * 3 + [
        False
    ] * 3
    assert not is_spoiled("LJ2K", "R", "u4") and is_spoiled("SOMETHING", "Z", "u4")
    assert not any(is_spoiled(name, "R", "f4") for name in ("HTJ2K256", "HTJ2K32", "ZSTD"))


def boxed(path, data, data_window, display_window):
    """A file of one float channel; windows as x, y of the upper left pixel and of the lower right one."""
    windows = {
        name: (np.array(ends[:2], np.int32), np.array(ends[2:], np.int32))
        for name, ends in (("dataWindow", data_window), ("displayWindow", display_window))
    }
    OpenEXR.File([OpenEXR.Part(FORM | windows, {"Z": data.copy()})]).write(str(path))


@pytest.mark.parametrize(
    ("x", "y", "left", "top"),
    [(2, 1, 0, 0), (-2, -1, 0, 0), (-7, 5, -9, 4), (3, 0, 5, 2), (0, 0, 0, 0), (5, 5, 0, 0)],
)
def test_the_data_window_is_placed_in_the_display_window(tmp_path, x, y, left, top):
    """Cut out, beyond the edges, with origins below 0; every pixel has the coordinates that it was written with."""
    data, (height, width) = planes("f4", "Z")["Z"], (7, 9)
    boxed(tmp_path / "x.exr", data, (x, y, x + 5, y + 3), (left, top, left + width - 1, top + height - 1))
    (texels,) = parts_of(tmp_path / "x.exr")
    placed, outside = texels.placed()
    for row in range(height):
        for column in range(width):
            inside = y <= row + top < y + 4 and x <= column + left < x + 6
            expected = data[row + top - y, column + left - x] if inside else 0
            assert placed.data[row, column, 0] == expected and outside[row, column] == (not inside)


def test_a_data_window_larger_than_the_display_window(tmp_path):
    data = planes("f4", "Z")["Z"]
    boxed(tmp_path / "x.exr", data, (-1, -1, 4, 2), (0, 0, 3, 1))
    placed, outside = parts_of(tmp_path / "x.exr")[0].placed()
    assert np.array_equal(placed.data[..., 0], data[1:3, 1:5]) and not outside.any()


def test_windows_that_do_not_meet(tmp_path):
    boxed(tmp_path / "x.exr", planes("f4", "Z")["Z"], (10, 0, 15, 3), (0, 0, 9, 3))
    with pytest.raises(DumpError, match="meets the display window, got 6 x 4 pixels from 10,0 in a picture of 10 x 4"):
        parts_of(tmp_path / "x.exr")


def test_subsampled_channels_are_refused_by_name(tmp_path):
    write(tmp_path / "x.exr", ("", planes("f4", ["RY", "Y"])))
    data = (tmp_path / "x.exr").read_bytes()
    at = data.index(b"RY\0") + 3 + 8  # after the type, and whether the channel is linear
    (tmp_path / "x.exr").write_bytes(data[:at] + np.array([2, 2], "<i4").tobytes() + data[at + 8 :])
    with pytest.raises(DumpError, match="expected a value of each channel for each pixel, got RY of every 2 x 2; "):
        parts_of(tmp_path / "x.exr")


def test_a_deep_part_is_refused_by_name(tmp_path):
    samples = np.empty((4, 6), object)
    for at in np.ndindex(4, 6):
        samples[at] = np.ones(2, np.float32)
    form = {"compression": OpenEXR.ZIPS_COMPRESSION, "type": OpenEXR.deepscanline}
    OpenEXR.File(form, {"Z": samples}).write(str(tmp_path / "x.exr"))
    with pytest.raises(DumpError, match="expected one value for each pixel, got a part of type deepscanline; flatten"):
        parts_of(tmp_path / "x.exr")


def test_a_layer_is_what_stands_before_the_dot(tmp_path):
    channels = planes("f4", ["ViewLayer.Position.X", "ViewLayer.Position.Y", "ViewLayer.Depth.Z", "A"])
    write(tmp_path / "x.exr", ("", channels))
    (texels,) = parts_of(tmp_path / "x.exr")
    layer = texels.layer("ViewLayer.Position")
    assert (layer.part, layer.channels) == ("ViewLayer.Position", ("X", "Y"))
    assert np.array_equal(layer.data[..., 1], channels["ViewLayer.Position.Y"])
    assert texels.layer("Position") is None and texels.layer("A") is None
