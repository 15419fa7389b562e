import numpy as np
import OpenEXR

from sss_ref.pictures.channels import channel_names
from sss_ref.results.exr_file import _channels, plane_by_plane, write_exr

KINDS = {
    "triangle": (np.int32, ()),
    "coverage": (np.uint8, ()),
    "depth": (np.float32, ()),
    "uv": (np.float32, (2,)),
    "normal_world": (np.float32, (3,)),
    "image": (np.float32, (3,)),
}


def random_buffers(generator, width, height):
    """Buffers of every kind with arbitrary bits, NaN patterns aside."""
    buffers = {}
    for name, (kind, channels) in KINDS.items():
        shape = (height, width, *channels)
        bits = generator.integers(-1, 0x7F7FFFFF, shape, np.int32)
        buffers[name] = (bits & 1).astype(np.uint8) if kind is np.uint8 else bits.view(kind)
    buffers["triangle"][0, 0] = -1
    buffers["depth"][buffers["depth"] != buffers["depth"]] = -0.0
    return buffers


def read(path):
    """Buffer -> (header, array), bottom row first, channels in the order of `channel_names`."""
    parts = {}
    for part in OpenEXR.File(str(path), separate_channels=True).parts:
        names = next(
            names for names in (["R", "G", "B"], ["X", "Y", "Z"], ["U", "V"], ["Y"]) if names[0] in part.channels
        )
        planes = [part.channels[name].pixels[::-1] for name in names]
        parts[part.header["name"]] = part.header, planes[0] if len(planes) == 1 else np.dstack(planes)
    return parts


def test_every_kind_of_buffer_comes_back_in_bits(tmp_path):
    buffers = random_buffers(np.random.default_rng(1), 13, 9)
    write_exr(tmp_path / "x.exr", buffers, (13, 9), {})
    parts = read(tmp_path / "x.exr")
    assert [*parts] == ["image", *(name for name in buffers if name != "image")]  # viewers open the first
    for name, buffer in buffers.items():
        expected = buffer.astype(np.uint32) if buffer.dtype == np.uint8 else buffer.view(np.uint32)
        assert np.array_equal(np.ascontiguousarray(parts[name][1]).view(np.uint32), expected), name
    assert parts["triangle"][1].dtype == np.uint32 and parts["triangle"][1][0, 0] == 4294967295


def test_buffers_of_other_sizes_keep_their_own_window(tmp_path):
    generator = np.random.default_rng(2)
    large, small = generator.random((40, 30), np.float32), generator.random((3, 4), np.float32)
    write_exr(tmp_path / "x.exr", {"light_depth": large, "depth": small}, (4, 3), {})
    parts = read(tmp_path / "x.exr")
    assert np.array_equal(parts["light_depth"][1], large) and np.array_equal(parts["depth"][1], small)
    for header, _ in parts.values():
        assert header["displayWindow"][1].tolist() == [3, 2]
    assert parts["light_depth"][0]["dataWindow"][1].tolist() == [29, 39]


def test_metadata_and_the_image_first(tmp_path):
    buffers = random_buffers(np.random.default_rng(3), 4, 3)
    write_exr(tmp_path / "x.exr", buffers, (4, 3), {"version": "1.2", "rules_version": 7})
    parts = read(tmp_path / "x.exr")
    assert list(parts) == ["image", *(name for name in buffers if name != "image")]
    header = parts["normal_world"][0]
    assert (header["sss_ref:version"], header["sss_ref:rules_version"]) == ("1.2", 7)
    assert header["sss_ref:unit"] == "unit vector, world space"


def test_what_is_put_apart_before_is_written_as_it_is(tmp_path):
    """Nothing is copied again of what EXR has a type for: all but masks."""
    buffers = random_buffers(np.random.default_rng(5), 13, 37)
    apart = {name: plane_by_plane(buffer) for name, buffer in buffers.items()}
    for name, buffer in buffers.items():
        assert apart[name].dtype == buffer.dtype and apart[name].shape == buffer.shape
        assert apart[name].tobytes() == buffer.tobytes()
        planes = _channels(name, apart[name]).values()
        assert all(np.shares_memory(plane, apart[name]) for plane in planes) == (buffer.dtype != np.uint8)
    for name, each in {"once": buffers, "apart": apart}.items():
        write_exr(tmp_path / name, each, (13, 37), {})
    assert (tmp_path / "once").read_bytes() == (tmp_path / "apart").read_bytes()


def test_channel_names():
    buffers = random_buffers(np.random.default_rng(4), 4, 3)
    names = {name: "".join(channel_names(name, buffer)) for name, buffer in buffers.items()}
    assert names == {
        "triangle": "Y", "coverage": "Y", "depth": "Y", "uv": "UV", "normal_world": "XYZ", "image": "RGB",
    }  # fmt: skip
