"""A bundle in every shading language: its files fit each other, and what it says of them is so."""

import json
import re

import numpy as np
import pytest
from lavapipe import LAVAPIPE, needs_lavapipe

from sss_ref import webgpu
from sss_ref.bundle.languages import LANGUAGES
from sss_ref.bundle.writing import write_bundle
from sss_ref.cli import main
from sss_ref.interpret.shader import DIALECTS, array_lengths, shader_files
from sss_ref.scene.load import load_scene

SMALL = {f"{t}.{s}": 32 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}
BINDINGS = {  # how each language says the place of a texture or of the constants: group or set (if any), number, name
    "vulkan": re.compile(r"set = (\d+), binding = (\d+)\) uniform (?:\w+ )?(\w+)"),
    "hlsl": re.compile(r"()(\w+) : register\([bt](\d+)\)"),
    "wgsl": re.compile(r"@group\((\d+)\) @binding\((\d+)\) var(?:<uniform>)? (\w+):"),
}


def test_there_is_one_for_every_dialect():
    assert set(LANGUAGES) == set(DIALECTS)


@pytest.fixture(scope="module", params=LANGUAGES)
def bundle(request, tmp_path_factory):
    """The language, the folder, and what its passes.json says."""
    folder = tmp_path_factory.mktemp("dialect") / request.param
    write_bundle(load_scene("figure5", **SMALL), folder, request.param)
    return request.param, folder, json.loads((folder / "passes.json").read_text())


def test_the_shaders_are_of_that_language(bundle):
    name, folder, listed = bundle
    scene = load_scene("figure5", **SMALL)
    files = shader_files(scene.method, array_lengths(scene.uniforms, DIALECTS[name]), DIALECTS[name])
    assert {path.name: path.read_text() for path in (folder / "shaders").iterdir()} == files
    named = {one["vertex_shader"] for one in listed["passes"]}
    named |= {draw["fragment_shader"] for one in listed["passes"] for draw in one["draws"]}
    assert named == {f"shaders/{file}" for file in files} and listed["dialect"] == name


def test_every_target_has_a_format_of_its_api(bundle):
    name, _, listed = bundle
    formats = {target["format"] for one in listed["passes"] for draw in one["draws"] for target in draw["targets"]}
    assert formats == set(LANGUAGES[name].formats.values())


def test_what_is_bound_by_number_is_listed_with_its_number(bundle):
    name, folder, listed = bundle
    for one in listed["passes"]:
        shaders = [(one["vertex_shader"], one), *((draw["fragment_shader"], draw) for draw in one["draws"])]
        for file, given in shaders:
            assert ("resources" in given) == (name in BINDINGS)
            if name in BINDINGS:
                found = {_named(name, each) for each in BINDINGS[name].finditer((folder / file).read_text())}
                assert found == set(_listed(name, given["resources"])), file


def _named(dialect, found):
    """Group, name and number of a binding in a text; the constants under one name."""
    group, second, third = found.groups()
    word, number = (second, third) if dialect == "hlsl" else (third, second)
    return (group or "0", "constants" if word.lower() == "uniforms" else word, int(number))


def _listed(dialect, resources):
    if resources["constants"]:
        yield (str(resources["group"]), "constants", resources["constants"]["binding"])
    for word, number in resources["textures"].items():
        yield (str(resources["group"]), word, number)


def test_the_guide_says_what_is_so(bundle):
    name, folder, listed = bundle
    guide, dialect = (folder / "PORTING.md").read_text(), DIALECTS[name]
    assert LANGUAGES[name].version in guide and max(map(len, guide.partition("## Conventions")[2].splitlines())) <= 120
    meshes = [one["draw"] for one in listed["passes"] if one["draw"]["kind"] == "mesh"]
    assert {draw["indexed"] for draw in meshes} == {dialect.indexed} == {"without indices" not in guide}
    texts = "".join(path.read_text() for path in (folder / "shaders").glob("*.vert"))
    mirrored = "1.0, -1.0, 1.0, 1.0" in texts
    assert ('origin = "bottom"' in guide) == mirrored == (name in BINDINGS)
    assert ("The sums are `precise`" in guide) == bool(dialect.exact) == ("precise" in texts)
    assert ("row_major" in guide) == ("row_major" in texts)
    assert ("set (`group`)" in guide) == (name == "vulkan")


def test_an_array_is_a_texture_where_the_language_has_none(bundle):
    name, folder, _ = bundle
    uniforms = json.loads((folder / "uniforms.json").read_text())
    assert ("file" in uniforms["tap_weight"]) == (name == "wgsl")


@needs_lavapipe
@pytest.mark.parametrize("scene", ["figure5", "figure4_wax"])
def test_a_wgsl_bundle_alone_gives_the_same_buffers(scene, tmp_path):
    """figure5 has rounds and a layout, figure4_wax a texture at the vertices and targets of bytes."""
    from webgpu_player import WebGpuPlayer

    from sss_ref.webgpu.adapter import open_device

    loaded = load_scene(scene, **SMALL)
    folder = write_bundle(loaded, tmp_path / "bundle", "wgsl")
    expected, device = webgpu.draw(loaded, adapter=LAVAPIPE), open_device(LAVAPIPE)
    played = WebGpuPlayer(device, folder).play()
    assert list(played) == list(expected)
    for name, buffer in expected.items():
        assert played[name][..., : np.atleast_3d(buffer).shape[2]].tobytes() == buffer.tobytes(), name
    device.destroy()


def test_on_the_command_line(tmp_path, capsys):
    assert main(["bundle", "wedge", "-o", str(tmp_path / "b"), "--dialect", "hlsl"]) == 0
    assert "cbuffer Uniforms : register(b0)" in (tmp_path / "b" / "shaders" / "camera.vert").read_text()
    assert main(["bundle", "wedge", "-o", str(tmp_path / "b"), "--dialect", "metal"]) == 2
    assert "dialect" in capsys.readouterr().err
