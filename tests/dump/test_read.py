"""From files to buffers that compare with a rendering: the scene is the one of the folder above."""

import numpy as np
import OpenEXR
import pytest
import tifffile
from PIL import Image

from sss_ref.dump.encoding import Encoding
from sss_ref.dump.read import read_dump
from sss_ref.errors import DumpError
from sss_ref.pictures.png_file import srgb_edges

WIDTH, HEIGHT = 48, 32  # of the camera; the maps have 64 x 64


def mapped(folder, text):
    (folder / "m.toml").write_text(text)
    return folder / "m.toml"


def refusal(path, result):
    with pytest.raises(DumpError) as caught:
        read_dump(path, result.scene)
    return str(caught.value).splitlines()


def in_bits(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def test_our_own_result_comes_back_in_bits(result, saved):
    dump = read_dump(saved, result.scene)
    assert list(dump.buffers) == list(result.buffers) and dump.notes == ()
    for name, buffer in result.buffers.items():
        found = dump.buffers[name]
        assert in_bits(found.data, buffer) and found.path == saved / "buffers" / f"{name}.npy"
        assert found.storage == {"f": "float32", "i": "int32", "u": "uint8"}[buffer.dtype.kind]
        assert found.notes == ()


def test_our_own_exr_by_the_names_of_its_parts(result, saved):
    tables = "".join(f'[buffers.{name}]\nfile = "out/buffers.exr"\n' for name in result.buffers)
    dump = read_dump(mapped(saved.parent, tables), result.scene)
    assert list(dump.buffers) == list(result.buffers)
    assert all(in_bits(dump.buffers[name].data, buffer) for name, buffer in result.buffers.items())


def test_pictures_begin_at_the_top_and_arrays_at_the_bottom(result, tmp_path):
    depth, image = result["depth"], result["image"]
    np.save(tmp_path / "depth.npy", depth[..., np.newaxis])
    tifffile.imwrite(tmp_path / "image.tif", image[::-1], photometric="rgb")
    Image.fromarray(result["coverage"][::-1] * np.uint8(255)).save(tmp_path / "coverage.png")
    dump = read_dump(tmp_path, result.scene)
    assert list(dump.buffers) == ["depth", "coverage", "image"]
    assert all(in_bits(dump.buffers[name].data, result[name]) for name in dump.buffers)
    assert dump.buffers["coverage"].storage == "unorm8"
    flipped = read_dump(mapped(tmp_path, 'origin = "top"\n[buffers.depth]\nfile = "depth.npy"'), result.scene)
    assert in_bits(flipped.buffers["depth"].data, np.ascontiguousarray(depth[::-1]))


def test_raw_with_swapped_channels_in_half_floats(result, tmp_path):
    stored = result["lit"].astype(np.float16)
    np.dstack((stored[..., ::-1], stored[..., 0])).tofile(tmp_path / "x.raw")
    table = f"""[buffers.lit]
        file = "x.raw"
        shape = [{HEIGHT}, {WIDTH}, 4]
        dtype = "float16"
        origin = "bottom"
        channels = ["B", "G", "R"]
        rounded_from = "float32"
    """
    found = read_dump(mapped(tmp_path, table), result.scene).buffers["lit"]
    assert in_bits(found.data, stored.astype(np.float32))
    assert found.encoding == Encoding("float16", rounded_from="float32")
    assert found.notes == ("channels B, G, R of R, G, B, A",)


def test_ids_as_unsigned_as_float_and_moved_by_one(result, tmp_path):
    triangle = result["triangle"]
    assert triangle.min() == -1
    np.save(tmp_path / "u.npy", triangle.view(np.uint32))
    np.save(tmp_path / "f.npy", triangle.astype(np.float32))
    np.save(tmp_path / "b.npy", (triangle + 1).astype(np.uint8))
    for table in ('file = "u.npy"', 'file = "f.npy"', 'file = "b.npy"\noffset = -1'):
        found = read_dump(mapped(tmp_path, f"[buffers.triangle]\n{table}"), result.scene).buffers["triangle"]
        assert in_bits(found.data, triangle)


def test_a_named_part_with_its_channels(result, tmp_path):
    normal = result["normal_world"]
    planes = {f"n.{axis}": np.ascontiguousarray(normal[::-1, :, i]) for i, axis in enumerate("xyz")}
    planes["id"] = np.ones((HEIGHT, WIDTH), np.uint32)
    form = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    parts = [OpenEXR.Part(form | {"name": name}, dict(planes)) for name in ("first", "second")]
    OpenEXR.File(parts).write(str(tmp_path / "g.exr"))
    table = '[buffers.normal_world]\nfile = "g.exr"\n'
    channels = 'channels = ["n.x", "n.y", "n.z"]\n'
    for part in ('part = "second"\n', "part = 1\n"):
        found = read_dump(mapped(tmp_path, table + part + channels), result.scene)
        assert in_bits(found.buffers["normal_world"].data, normal)
    where = f"{tmp_path / 'm.toml'}: buffers.normal_world"
    assert refusal(mapped(tmp_path, table + channels), result) == [
        f"{where}.part: expected the part normal_world in g.exr, got first, second; name one of these"
    ]
    for more in ("part = 1", 'part = "n"', 'part = "second"\nchannels = "xyz"'):  # the one layer that has x, y, z
        part = read_dump(mapped(tmp_path, table + more), result.scene)
        assert in_bits(part.buffers["normal_world"].data, normal)
    assert refusal(mapped(tmp_path, '[buffers.uv]\nfile = "g.exr"\npart = 1\nchannels = "UV"'), result) == [
        f"{tmp_path / 'm.toml'}: buffers.uv.channels: expected U, V in g.exr, got n.x, n.y, n.z, id; "
        "name those of the buffer"
    ]
    assert refusal(mapped(tmp_path, table + 'part = 1\nchannels = ["n.x"]'), result) == [
        f"{where}.channels: expected 3 channels, got n.x; name as many as the buffer has"
    ]


@pytest.mark.parametrize(
    ("names", "expected"),
    [
        (("B", "G", "R"), (2, 1, 0)),
        (("X", "Y", "Z"), (0, 1, 2)),
        (("r", "g", "b"), (0, 1, 2)),
        (("A", "B", "G", "R"), (3, 2, 1)),
    ],
)
def test_usual_channel_names_whatever_their_order(result, tmp_path, names, expected):
    planes = {name: np.full((HEIGHT, WIDTH), index, np.float32) for index, name in enumerate(names)}
    form = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(form, planes).write(str(tmp_path / "image.exr"))
    found = read_dump(tmp_path, result.scene).buffers["image"]
    assert found.data[0, 0].tolist() == list(expected)
    assert "blank: every pixel is the same" in found.notes


def test_the_only_channel_may_have_any_name(result, tmp_path):
    plane = np.ascontiguousarray(result["depth"][::-1])
    form = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(form, {"ViewLayer.Depth.V": plane}).write(str(tmp_path / "depth.exr"))
    assert in_bits(read_dump(tmp_path, result.scene).buffers["depth"].data, result["depth"])


def test_normals_in_view_space_moved_to_0_1(result, tmp_path):
    camera, covered = result.scene.camera, result["coverage"] == 1
    in_view = np.einsum("ij,hwj->hwi", camera.view[:3, :3], result["normal_world"].astype(np.float64))
    Image.fromarray(np.rint((in_view[::-1] * 0.5 + 0.5) * 255).astype(np.uint8)).save(tmp_path / "n.png")
    table = '[buffers.normal_world]\nfile = "n.png"\nnormals = "n*.5+.5"\nspace = "view"'
    found = read_dump(mapped(tmp_path, table), result.scene).buffers["normal_world"]
    error = np.abs(found.data - result["normal_world"])[covered]
    assert error.max() <= np.sqrt(3) / 255 + 1e-6  # half a code in each component, however turned
    assert found.encoding == Encoding("unorm8", space="view", normals="n*.5+.5", loss=found.encoding.loss)
    assert 2 * np.sqrt(3) / 255 < found.encoding.loss.least < 2.001 * np.sqrt(3) / 255  # a step of n, turned
    assert len(found.notes) == 2


def test_octahedral_normals_take_two_channels(result, tmp_path):
    stored = np.zeros((HEIGHT, WIDTH, 2), np.float32)
    stored[..., 0] = 1
    np.save(tmp_path / "n.npy", stored)
    table = '[buffers.normal_world]\nfile = "n.npy"\nnormals = "octahedral"'
    found = read_dump(mapped(tmp_path, table), result.scene).buffers["normal_world"]
    assert (found.data == np.float32([1, 0, 0])).all()


def test_positions_in_view_space(result, tmp_path):
    world, camera = result["position_world"], result.scene.camera
    in_view = np.einsum("ij,hwj->hwi", camera.view[:3, :3], world.astype(np.float64)) + camera.view[:3, 3]
    covered = result["coverage"][..., np.newaxis] == 1
    np.save(tmp_path / "p.npy", np.where(covered, in_view, 0).astype(np.float32))
    table = '[buffers.position_world]\nfile = "p.npy"\nspace = "view"'
    found = read_dump(mapped(tmp_path, table), result.scene).buffers["position_world"]
    assert np.abs(found.data - world).max() <= 2.0**-21  # two roundings to float32 of numbers below 4
    assert (found.data[~covered[..., 0]] == 0).all()


def test_srgb_picture(result, tmp_path):
    codes = np.searchsorted(srgb_edges(), np.clip(result["image"], 0, 1), side="right").astype(np.uint8)
    Image.fromarray(codes[::-1]).save(tmp_path / "image.png")
    table = '[buffers.image]\nfile = "image.png"\nencoding = "srgb8"'
    found = read_dump(mapped(tmp_path, table), result.scene).buffers["image"]
    again = np.searchsorted(srgb_edges(), found.data, side="right")
    assert np.array_equal(again, codes) and found.storage == "srgb8"


def test_blank_and_not_finite_are_counted_and_kept(result, tmp_path):
    depth = result["depth"].copy()
    depth[0, :3] = np.nan, np.inf, -np.inf
    np.save(tmp_path / "depth.npy", depth)
    np.save(tmp_path / "uv.npy", np.full((HEIGHT, WIDTH, 2), np.nan, np.float32))
    buffers = read_dump(tmp_path, result.scene).buffers
    assert (buffers["depth"].is_blank, buffers["depth"].not_finite) == (False, 3)
    assert in_bits(buffers["depth"].data, depth)
    assert buffers["depth"].notes == (f"3 of {WIDTH * HEIGHT} values are NaN or infinite",)
    assert (buffers["uv"].is_blank, buffers["uv"].not_finite) == (True, 2 * WIDTH * HEIGHT)


@pytest.mark.parametrize(
    ("name", "array", "message"),
    [
        ("depth", np.zeros((HEIGHT, WIDTH + 1), "f4"), "expected 48 x 32 pixels, as camera of the scene, got 49 x 32"),
        ("light_depth", np.zeros((HEIGHT, WIDTH), "f4"), "expected 64 x 64 pixels, as shadow_map of the scene"),
        ("image", np.zeros((HEIGHT, WIDTH), "f4"), "expected 3 channels with usual names in image.npy, got R; "),
        (
            "image",
            np.zeros((HEIGHT, WIDTH, 3), "i4"),
            "expected floats, or a byte's share of 1 for image, got integers",
        ),
        ("triangle", np.full((HEIGHT, WIDTH), 0.5, "f4"), "expected whole numbers in triangle, got 0.5 at pixel 0,0"),
        ("triangle", np.full((HEIGHT, WIDTH), np.nan, "f4"), "expected whole numbers in triangle, got nan"),
        ("triangle", np.full((HEIGHT, WIDTH), 2.0**31, "f4"), "expected whole numbers in triangle, got 2.1474836e+09"),
        ("coverage", np.full((HEIGHT, WIDTH), 255, "u1"), "expected 0 or 1 in coverage, got 255 at pixel 0,0"),
        ("coverage", np.full((HEIGHT, WIDTH), 0.5, "f4"), "expected 0 or 1 in coverage, got 0.5"),
    ],
)
def test_what_does_not_fit_the_scene(result, tmp_path, name, array, message):
    np.save(tmp_path / f"{name}.npy", array)
    (line,) = refusal(tmp_path, result)
    assert line.startswith(str(tmp_path / f"{name}.npy")) and message in line


def test_all_problems_at_once_each_under_its_key(result, tmp_path):
    np.save(tmp_path / "a.npy", np.zeros((HEIGHT, WIDTH, 3), np.float32))
    np.save(tmp_path / "cut.npy", np.zeros((HEIGHT, WIDTH), np.float32))
    (tmp_path / "cut.npy").write_bytes((tmp_path / "cut.npy").read_bytes()[:-1])
    path = mapped(
        tmp_path,
        """
        [buffers.dept]
        file = "a.npy"
        [buffers.irradiance]
        file = "a.npy"
        [buffers.lit]
        file = "a.raw"
        shape = [32, 48, 3]
        dtype = "uint8"
        [buffers.phong]
        file = "a.npy"
        space = "view"
        [buffers.albedo]
        file = "a.npy"
        normals = "octahedral"
        [buffers.scattered]
        file = "a.npy"
        encoding = "uint8"
        [buffers.image]
        file = "a.npy"
        channels = "RGX"
        [buffers.position_world]
        file = "a.npy"
        part = "b"
        [buffers.depth]
        file = "cut.npy"
        """,
    )
    (tmp_path / "a.raw").write_bytes(bytes(32 * 48 * 3))
    lines = refusal(path, result)
    starts = [
        "buffers.dept: expected a buffer of this scene, got this one; did you mean depth?",
        "buffers.irradiance: expected a buffer of this scene, got this one; remove it",
        'buffers.phong.space: expected "world", as phong has no space, got "view"; remove it',
        'buffers.albedo.normals: expected "xyz", as albedo is no normal, got "octahedral"; remove it',
        "buffers.scattered.encoding: expected one of float32, unorm8, srgb8, rgb10a2, unorm16, ",
        "buffers.image.channels: expected R, G, X in a.npy, got R, G, B; name those of the buffer",
        "buffers.position_world.part: expected the part b in a.npy, got 0; name one of these",
        'buffers.lit.origin: expected "top" or "bottom" for a raw file, got nothing; add it',
    ]
    for start, line in zip([f"{path}: {start}" for start in starts], lines, strict=False):
        assert line.startswith(start)
    assert lines[8].startswith(f"{tmp_path / 'cut.npy'}: expected a whole NPY file, got one that is damaged")
    assert len(lines) == 9


def test_a_folder_without_buffers(result, tmp_path):
    (line,) = refusal(tmp_path, result)
    assert line.startswith(f"{tmp_path}: expected a file for a buffer (light_triangle, ")
