import numpy as np
import OpenEXR
import pytest

from sss_ref.dump.files import parts_of
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


def test_no_exr_at_all(tmp_path, capfd):
    (tmp_path / "x.exr").write_bytes(b"nothing")
    with pytest.raises(DumpError, match=r"x\.exr: expected a whole file of its format, got RuntimeError: "):
        parts_of(tmp_path / "x.exr")


def test_a_declared_size_is_checked_before_the_pixels_are_read(tmp_path):
    window = (np.zeros(2, np.int32), np.array([5, 3], np.int32))
    OpenEXR.File([OpenEXR.Part(FORM | {"dataWindow": window}, planes("f4", "Y"))]).write(str(tmp_path / "x.exr"))
    data = (tmp_path / "x.exr").read_bytes()
    corner = np.array([5, 3], "<i4").tobytes()
    (tmp_path / "x.exr").write_bytes(data.replace(corner, np.array([99999, 3], "<i4").tobytes()))
    with pytest.raises(DumpError, match="expected a width and a height from 1 to 16384, got 100000 x 4"):
        parts_of(tmp_path / "x.exr")
