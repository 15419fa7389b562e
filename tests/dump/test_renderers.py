"""The mapping files of the documentation, on files laid out as Mitsuba 3.9 and Blender 5.0 were seen to write them."""

import shutil
from pathlib import Path

import numpy as np
import OpenEXR
import pytest

from sss_ref.dump.depths import ray_cosines
from sss_ref.dump.read import read_dump

MAPPINGS = Path(__file__).parents[2] / "docs" / "mappings"


def upright(plane):
    return np.ascontiguousarray(np.asarray(plane, np.float32)[::-1])


@pytest.fixture
def drawn(result):
    """Coverage, the distance along the view axis and the cosine of the pixel's ray to it, as float64."""
    camera = result.scene.camera
    at = result["position_world"].astype("f8") @ camera.view[:3, :3].T + camera.view[:3, 3]
    return result["coverage"] == 1, -at[..., 2], ray_cosines(camera)


def vectors(layer, buffer, names="XYZ"):
    return {f"{layer}.{name}": buffer[..., index] for index, name in enumerate(names)}


def assert_reads(path, result, drawn):
    """What was given comes back, in bits where nothing was converted, else within the loss that is told."""
    found = read_dump(path, result.scene).buffers
    for name, buffer in found.items():
        loss = buffer.encoding.loss
        if loss is None:
            assert buffer.data.tobytes() == result[name].tobytes(), name
        else:
            apart = np.abs(buffer.data.astype("f8") - result[name])
            assert apart.max() <= loss.least + 2.0**-22 and loss.least < 1e-6, name
            assert (buffer.data[~drawn] == result[name][~drawn]).all(), name
    return set(found)


def test_mitsuba(result, drawn, tmp_path):
    """One part; prim_index and depth are 0 where nothing is; depth counts from the near plane; v is turned round."""
    covered, along, cosine = drawn
    channels = {name: np.zeros(covered.shape) for name in "RGB"}
    channels |= {"shape.I": covered, "triangle.I": np.where(covered, result["triangle"], 0)}
    channels["depth.T"] = np.where(covered, (along - result.scene.camera.near) / cosine, 0)
    channels |= vectors("position", result["position_world"]) | vectors("normal", result["normal_world"])
    turned = np.where(covered[..., np.newaxis], result["uv"].astype("f8") * [1, -1] + [0, 1], 0)
    channels |= vectors("uv", turned, "UV")
    form = {"compression": OpenEXR.PIZ_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(form, {name: upright(plane) for name, plane in channels.items()}).write(str(tmp_path / "mitsuba.exr"))
    shutil.copy(MAPPINGS / "mitsuba.toml", tmp_path)
    names = {"coverage", "triangle", "depth", "position_world", "normal_world", "uv"}
    assert assert_reads(tmp_path / "mitsuba.toml", result, covered) == names


def test_blender(result, drawn, tmp_path):
    """A part for each pass, whose name its channels repeat; Z is up; depth is 1e10 where nothing is."""
    covered, along, _ = drawn
    axes = [0, 2, 1], [1, -1, 1]  # of Blender: x, -z, y of the mesh file
    passes = {
        "Combined": {"A": covered, "B": along, "G": along, "R": along},
        "Depth": {"Z": np.where(covered, along, 1e10)},
        "Position": dict(zip("XYZ", np.moveaxis(result["position_world"][..., axes[0]] * axes[1], -1, 0), strict=True)),
        "Normal": dict(zip("XYZ", np.moveaxis(result["normal_world"][..., axes[0]] * axes[1], -1, 0), strict=True)),
        "UV": {"A": covered, "U": result["uv"][..., 0], "V": result["uv"][..., 1]},
    }
    form = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    parts = [
        OpenEXR.Part(
            form | {"name": f"ViewLayer.{layer}"},
            {f"ViewLayer.{layer}.{name}": upright(plane) for name, plane in channels.items()},
        )
        for layer, channels in passes.items()
    ]
    OpenEXR.File(parts).write(str(tmp_path / "blender.exr"))
    shutil.copy(MAPPINGS / "blender.toml", tmp_path)
    names = {"coverage", "depth", "position_world", "normal_world", "uv"}
    assert assert_reads(tmp_path / "blender.toml", result, covered) == names


@pytest.mark.parametrize("one_part", [True, False])
def test_the_layer_alone_finds_its_channels(result, tmp_path, one_part):
    channels = {name: upright(plane) for name, plane in vectors("ViewLayer.Position", result["position_world"]).items()}
    other = {"ViewLayer.Depth.Z": upright(result["depth"])}
    form = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    parts = [OpenEXR.Part(form | {"name": "ViewLayer"}, channels | other)]
    if not one_part:
        named = (("ViewLayer.Position", channels), ("ViewLayer.Depth", other))
        parts = [OpenEXR.Part(form | {"name": name}, planes) for name, planes in named]
    OpenEXR.File(parts).write(str(tmp_path / "b.exr"))
    (tmp_path / "m.toml").write_text('[buffers.position_world]\nfile = "b.exr"\npart = "ViewLayer.Position"')
    found = read_dump(tmp_path / "m.toml", result.scene).buffers["position_world"]
    assert found.data.tobytes() == result["position_world"].tobytes()
