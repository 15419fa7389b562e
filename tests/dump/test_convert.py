"""What users' tools write, held against the same buffers as we render them; the scene is that of `saved_scene`."""

import numpy as np
import OpenEXR
import pytest

from sss_ref.dump.depths import ray_cosines
from sss_ref.dump.encoding import Encoding
from sss_ref.dump.loss import Loss
from sss_ref.dump.read import read_dump
from sss_ref.errors import DumpError
from sss_ref.scene.load import load_scene

WIDTH, HEIGHT = 48, 32  # of the camera


def mapped(folder, text):
    (folder / "m.toml").write_text(text)
    return folder / "m.toml"


def refusal(path, scene):
    with pytest.raises(DumpError) as caught:
        read_dump(path, scene)
    (line,) = str(caught.value).splitlines()
    return line


def in_bits(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def exr(path, channels, compression=OpenEXR.ZIP_COMPRESSION, **header):
    """An EXR file of planes whose row 0 is at the bottom."""
    upright = {name: np.ascontiguousarray(plane[::-1]) for name, plane in channels.items()}
    OpenEXR.File({"compression": compression, "type": OpenEXR.scanlineimage, **header}, upright).write(str(path))


def planes(buffer, names="RGB"):
    return {name: buffer[..., index] for index, name in enumerate(names)}


@pytest.mark.parametrize(
    ("name", "channels"),
    [("entry_point", "XYZ"), ("entry_point", "STP"), ("uv", "UV"), ("uv", "xy"), ("lit", "RGB"), ("depth", "X")],
)
def test_letters_are_places_where_a_file_names_no_channels(result, tmp_path, name, channels):
    np.save(tmp_path / "x.npy", result[name])
    path = mapped(tmp_path, f'[buffers.{name}]\nfile = "x.npy"\nchannels = "{channels}"')
    assert in_bits(read_dump(path, result.scene).buffers[name].data, result[name])


def test_letters_of_two_families_are_no_places(result, tmp_path):
    np.save(tmp_path / "x.npy", result["lit"])
    path = mapped(tmp_path, '[buffers.lit]\nfile = "x.npy"\nchannels = "RGX"')
    assert "buffers.lit.channels: expected R, G, X in x.npy, got R, G, B; " in refusal(path, result.scene)


def test_in_a_file_with_names_a_letter_is_a_name(result, tmp_path):
    exr(tmp_path / "lit.exr", planes(result["lit"]))
    path = mapped(tmp_path, '[buffers.lit]\nfile = "lit.exr"\nchannels = "XYZ"')
    assert "expected X, Y, Z in lit.exr, got B, G, R; name those of the buffer" in refusal(path, result.scene)


@pytest.mark.parametrize("kind", ["DWAA", "DWAB"])
def test_colours_that_a_compression_has_changed_are_refused(result, tmp_path, kind):
    compression = getattr(OpenEXR, f"{kind}_COMPRESSION")
    exr(tmp_path / "lit.exr", planes(result["lit"]), compression)
    assert f"got B, G, R changed by the compression {kind}; " in refusal(tmp_path, result.scene).replace(
        "R, G, B", "B, G, R"
    )
    exr(tmp_path / "lit.exr", planes(result["lit"], ["l.r", "l.g", "l.b"]), compression)
    assert in_bits(read_dump(tmp_path, result.scene).buffers["lit"].data, result["lit"])


def test_of_a_position_only_y_is_changed(result, tmp_path):
    """Which looks like a shader's fault, so it is told by name."""
    exr(
        tmp_path / "p.exr",
        planes(result["position_world"], [f"Position.{axis}" for axis in "XYZ"]),
        OpenEXR.DWAA_COMPRESSION,
    )
    path = mapped(tmp_path, '[buffers.position_world]\nfile = "p.exr"\npart = "Position"')
    assert "expected channels as they were drawn, got Y changed by the compression DWAA; " in refusal(
        path, result.scene
    )


def test_halves_that_b44_has_packed_are_refused(result, tmp_path):
    exr(tmp_path / "lit.exr", planes(result["lit"].astype("f2")), OpenEXR.B44_COMPRESSION)
    assert "R, G, B changed by the compression B44; " in refusal(tmp_path, result.scene)


def test_floats_of_24_bits_are_judged_with_their_loss(result, tmp_path):
    exr(tmp_path / "lit.exr", planes(result["lit"]), OpenEXR.PXR24_COMPRESSION)
    found = read_dump(tmp_path, result.scene).buffers["lit"]
    assert found.encoding == Encoding("float24", rounded_from="float32")
    assert found.notes == ("its compression PXR24 keeps 24 bits of 32",)
    error = np.abs(found.data.astype("f8") - result["lit"])
    assert error.max() > 0 and (error <= np.abs(found.data) * 2.0**-15).all()


def test_types_that_are_mixed_are_named(result, tmp_path):
    exr(tmp_path / "lit.exr", {**planes(result["lit"]), "G": result["lit"][..., 1].astype("f2")})
    told = "expected one type for R, G, B in lit.exr, got R float32, G float16, B float32; write them in one type"
    assert told in refusal(tmp_path, result.scene)


def test_an_autocropped_picture_is_placed_and_the_rest_is_background(result, tmp_path):
    """The rows of an EXR file begin at the top, so the window is counted from there."""
    shown = np.argwhere(result["coverage"] == 1)
    (y0, x0), (y1, x1) = shown.min(axis=0), shown.max(axis=0)
    windows = {
        "dataWindow": (np.array([x0, HEIGHT - 1 - y1], "i4"), np.array([x1, HEIGHT - 1 - y0], "i4")),
        "displayWindow": (np.array([0, 0], "i4"), np.array([WIDTH - 1, HEIGHT - 1], "i4")),
    }
    for name in ("lit", "depth", "triangle"):  # whose backgrounds are 0, 1 and -1
        cut = result[name][y0 : y1 + 1, x0 : x1 + 1]
        channels = planes(cut) if cut.ndim == 3 else {"Z": cut.astype("f4")}
        exr(tmp_path / f"{name}.exr", channels, **windows)
        found = read_dump(tmp_path, result.scene).buffers[name]
        assert in_bits(found.data, result[name])
        assert "the rest of it is background" in found.notes[0]


@pytest.mark.parametrize("kind", ["u2", "u1", "i2", "u4"])
def test_triangle_numbers_in_integers_of_any_size(result, tmp_path, kind):
    np.save(tmp_path / "triangle.npy", result["triangle"].astype("i8").astype(kind))  # -1 becomes the largest
    assert in_bits(read_dump(tmp_path, result.scene).buffers["triangle"].data, result["triangle"])


@pytest.fixture(scope="module")
def head():
    """A mesh of 20,000 triangles: more than halves can tell apart, fewer than 16 bits can."""
    return load_scene("figure3_with", **{"camera.width": 48, "camera.height": 32})


def triangles(last):
    """A different number in each pixel, up to the last."""
    return np.arange(last + 1 - WIDTH * HEIGHT, last + 1, dtype="f4").reshape(HEIGHT, WIDTH)


def test_numbers_that_halves_cannot_tell_apart_are_refused(head, tmp_path):
    np.save(tmp_path / "triangle.npy", triangles(2047).astype("f2"))
    assert in_bits(read_dump(tmp_path, head).buffers["triangle"].data, triangles(2047).astype("i4"))
    np.save(tmp_path / "triangle.npy", triangles(2049).astype("f2"))
    told = (
        "expected numbers up to 2048 in triangle, as float16 holds no more of them whole, got 2048 of a mesh of 20000"
    )
    assert told in refusal(tmp_path, head)


def test_eight_bits_are_too_few_for_a_head(head, tmp_path):
    np.save(tmp_path / "triangle.npy", np.zeros((HEIGHT, WIDTH), "u1"))
    told = "expected a number for each of 20000 triangles in triangle, got uint8, which has fewer; dump them as 32-bit"
    assert told in refusal(tmp_path, head)


def test_the_background_counts_where_nothing_is_drawn(result, tmp_path):
    """A triangle's number where nothing is, as Mitsuba's 0: only the coverage can tell the two."""
    drawn = result["coverage"] == 1
    first = int(result["triangle"][drawn].min())
    np.save(tmp_path / "triangle.npy", np.where(drawn, result["triangle"], first))
    np.save(tmp_path / "depth.npy", np.where(result["coverage"] == 1, result["depth"], 0).astype("f4"))
    table = "".join(
        f'[buffers.{name}]\nfile = "{name}.npy"\nbackground = {number}\n'
        for name, number in (("triangle", first), ("depth", 0))
    )
    alone = read_dump(mapped(tmp_path, table), result.scene).buffers
    assert in_bits(alone["triangle"].data, result["triangle"]) and in_bits(alone["depth"].data, result["depth"])
    told = "its background is taken where coverage says that nothing is drawn (the scene's, as the dump has none)"
    assert alone["triangle"].notes == (told,)
    more = result["coverage"].copy()
    more[0, 0] = 1  # where the other renderer says that it drew something, the number is one
    np.save(tmp_path / "coverage.npy", more)
    both = read_dump(mapped(tmp_path, table + '[buffers.coverage]\nfile = "coverage.npy"'), result.scene).buffers
    assert result["triangle"][0, 0] == -1 and both["triangle"].data[0, 0] == first
    assert "(the dump's)" in both["triangle"].notes[0]


def test_the_background_of_vectors_counts_where_all_channels_have_it(result, tmp_path):
    drawn = result["coverage"][..., np.newaxis] == 1
    np.save(tmp_path / "p.npy", np.where(drawn, result["position_world"], np.float32(-7)))
    path = mapped(tmp_path, '[buffers.position_world]\nfile = "p.npy"\nbackground = -7')
    assert in_bits(read_dump(path, result.scene).buffers["position_world"].data, result["position_world"])


@pytest.mark.parametrize("kind", ["view", "ray", "ray_from_near"])
def test_depth_as_a_distance(result, tmp_path, kind):
    camera, drawn = result.scene.camera, result["coverage"] == 1
    at = result["position_world"].astype("f8") @ camera.view[:3, :3].T + camera.view[:3, 3]
    along = -at[..., 2]
    distance = {"view": along, "ray": along / ray_cosines(camera)}.get(
        kind, (along - camera.near) / ray_cosines(camera)
    )
    np.save(tmp_path / "d.npy", np.where(drawn, distance, 1e10).astype("f4"))
    path = mapped(tmp_path, f'[buffers.depth]\nfile = "d.npy"\ndepth = "{kind}"')
    found = read_dump(path, result.scene).buffers["depth"]
    assert (found.data[~drawn] == 1).all()
    assert np.abs(found.data - result["depth"])[drawn].max() <= found.encoding.loss.least + 2.0**-22
    assert found.encoding.rounded_from == "float32" and 0 < found.encoding.loss.least < 1e-6
    assert found.notes == (f"window depth computed from a distance ({kind}), nearly as exact as that",)


def test_depth_in_halves_is_said_to_be_coarse(result, tmp_path):
    exr(tmp_path / "depth.exr", {"D": result["depth"].astype("f2")})
    found = read_dump(tmp_path, result.scene).buffers["depth"]
    assert found.storage == "float16" and found.notes[0].startswith(
        "half floats have 11 bits of a depth, and no texture"
    )


def test_scale_and_offset_for_each_channel(result, tmp_path):
    flipped = result["uv"].astype("f8") * [1, -1] + [0, 1]
    np.save(tmp_path / "uv.npy", flipped.astype("f4"))
    path = mapped(tmp_path, '[buffers.uv]\nfile = "uv.npy"\nscale = [1, -1]\noffset = [0, 1]')
    found = read_dump(path, result.scene).buffers["uv"]
    assert np.abs(found.data - result["uv"]).max() <= found.encoding.loss.least <= 2.0**-21
    assert found.encoding.loss == Loss(least=found.encoding.loss.least) and found.encoding.rounded_from == "float32"
    path = mapped(tmp_path, '[buffers.uv]\nfile = "uv.npy"\nscale = [1, -1, 1]')
    assert "buffers.uv.scale: expected one number or 2, got 3; one for each channel" in refusal(path, result.scene)


@pytest.mark.parametrize(
    ("table", "told"),
    [
        ('[buffers.lit]\nfile = "x.npy"\ndepth = "ray"', 'lit.depth: expected "window", as lit is no depth, got "ray"'),
        (
            '[buffers.image]\nfile = "x.npy"\nbackground = 0',
            "image.background: expected nothing, as all of image is drawn, got 0.0; remove it",
        ),
    ],
)
def test_keys_that_a_buffer_cannot_have(result, tmp_path, table, told):
    np.save(tmp_path / "x.npy", result["lit"])
    assert told in refusal(mapped(tmp_path, table), result.scene)
