"""Versions and extensions that a file needs (glTF 2.0, 3.2 and 3.12)."""

import json

import numpy as np
import pytest
from gltf_files import CORNERS, message, refusal, tetrahedron

VERSIONS = {
    "1.0": "expected glTF 2.0, got glTF 1.0; convert it to glTF 2.0",
    "1.1": "expected glTF 2.0, got glTF 1.1; convert it to glTF 2.0",
    "3.0": "expected glTF 2.0, got glTF 3.0; export it as glTF 2.0",
    "two": 'asset.version: expected a version such as "2.0", got "two"; export the mesh again',
    "": 'asset.version: expected a version such as "2.0", got ""; export the mesh again',
}


@pytest.mark.parametrize("version, expected", VERSIONS.items())
def test_other_versions(tmp_path, version, expected):
    assert refusal(tetrahedron(asset={"version": version}), tmp_path) == expected


def test_first_version_without_asset(tmp_path):
    """In glTF 1.0 the tables are objects, and asset may be left out."""
    path = tmp_path / "a.gltf"
    path.write_text(json.dumps({"meshes": {"m": {"primitives": []}}, "accessors": {}, "nodes": {}}))
    assert message(path) == "expected glTF 2.0, got glTF 1.0; convert it to glTF 2.0"


def test_later_minor_versions(tmp_path):
    assert len(tetrahedron(asset={"version": "2.1"}).loaded(tmp_path).triangles) == 4
    assert len(tetrahedron(asset={"version": "2.1", "minVersion": "2.0"}).loaded(tmp_path).triangles) == 4
    later = tetrahedron(asset={"version": "2.1", "minVersion": "2.1"})
    assert refusal(later, tmp_path) == "expected glTF 2.0, got glTF 2.1; export it as glTF 2.0"


@pytest.mark.parametrize("asset", [None, {}, {"version": 2.0}, "2.0"])
def test_version_that_is_not_given(tmp_path, asset):
    assert refusal(tetrahedron(asset=asset), tmp_path).startswith("asset")


LOOKS = ["KHR_materials_unlit", "KHR_materials_of_the_future", "KHR_texture_basisu", "KHR_lights_punctual", "MSFT_lod"]
APPLIED = ["KHR_texture_transform", "KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_draco_mesh_compression"]


@pytest.mark.parametrize("name", LOOKS + APPLIED)
def test_extensions_that_may_be_required(tmp_path, name):
    loaded = tetrahedron(extensionsUsed=[name], extensionsRequired=[name]).loaded(tmp_path)
    assert np.array_equal(loaded.positions, CORNERS)


@pytest.mark.parametrize("name", ["CESIUM_RTC", "KHR_gaussian_splatting", "XX_bends_everything", ""])
def test_extensions_that_are_not_known(tmp_path, name):
    refused = tetrahedron(extensionsUsed=[name], extensionsRequired=["KHR_materials_unlit", name])
    assert refusal(refused, tmp_path) == (
        f"extensionsRequired: expected extensions that are known here, got {json.dumps(name)}; "
        "export the mesh without it"
    )
    assert np.array_equal(tetrahedron(extensionsUsed=[name]).loaded(tmp_path).positions, CORNERS)
