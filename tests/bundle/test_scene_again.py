"""A bundle is a scene: it renders to the same bits as the one it was written from, wherever it lies."""

import json
import shutil

import numpy as np
import pytest
from detailed import bumpy
from PIL import Image
from scenes import around, sphere, written

import sss_ref
from sss_ref.bundle.writing import write_bundle
from sss_ref.cli import main
from sss_ref.errors import MeshError, SceneError

SMALL = {f"{t}.{s}": 32 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}
CHANGED = {"translucency.exponent": 0.61, "lights.0.position": [2.0, 1.0, 3.0]}
COLORS = "newmtl red\nKd 0.9 0.1 0.2\nnewmtl blue\nKd 0.1 0.2 0.9\n"


def textured(folder):
    """A scene file with a picture on a sphere; texels of every code."""
    path = written(folder / "sphere.obj", *sphere(8))
    codes = np.arange(256 * 3, dtype=np.uint32) * 41 % 256
    Image.fromarray(codes.astype(np.uint8).reshape(16, 16, 3)).save(folder / "paint.png")
    data = around(path, 32)
    return data | {"mesh": data["mesh"] | {"texture": str(folder / "paint.png")}}


def with_materials(folder):
    positions, triangles, _ = sphere(8)
    lines = ["mtllib two.mtl", *(f"v {x!r} {y!r} {z!r}" for x, y, z in positions.tolist())]
    for number, corners in enumerate((triangles + 1).tolist()):
        lines += [f"usemtl {'red' if number % 3 else 'blue'}", "f " + " ".join(map(str, corners))]
    (folder / "two.obj").write_text("\n".join(lines))
    (folder / "two.mtl").write_text(COLORS)
    data = around(str(folder / "two.obj"), 32)
    return data | {"mesh": data["mesh"] | {"color": "material"}}


def unwrapped(folder):
    pytest.importorskip("xatlas", reason="install .[unwrap]")
    positions, triangles, _ = sphere(8)
    data = around(written(folder / "bare.obj", positions, triangles), 32, method="texture_space")
    return data | {"mesh": data["mesh"] | {"unwrap": True}}


def layered(folder):
    positions, triangles, _ = sphere(8)
    inside = written(folder / "inner.obj", positions * 0.8, triangles)
    layers = [{"path": inside, "extinction_per_mm": [0.1, 0.2, 0.5], "phong": {"specular": 0.0}}]
    return around(written(folder / "outer.obj", positions, triangles), 32, layers=layers)


SCENES = {
    "figure3_with": lambda _: "figure3_with",
    "figure5": lambda _: "figure5",
    "figure4_glass": lambda _: "figure4_glass",
    "default": lambda _: "default",
    "textured": textured,
    "with_materials": with_materials,
    "unwrapped": unwrapped,
    "bumpy": bumpy,
    "layered": layered,
}


@pytest.mark.parametrize("name", SCENES)
def test_a_moved_bundle_renders_to_the_same_bits(name, tmp_path, monkeypatch):
    """Its own files are gone, and the folder is another."""
    files = tmp_path / "files"
    files.mkdir()
    scene = sss_ref.load_scene(SCENES[name](files), **SMALL, **CHANGED)
    expected = sss_ref.render(scene, "arrays").hashes
    write_bundle(scene, tmp_path / "written")
    shutil.rmtree(files)
    (tmp_path / "written").rename(tmp_path / "moved")
    monkeypatch.chdir(tmp_path / "moved")
    again = sss_ref.load_scene(".")
    assert again.input_hashes() == scene.input_hashes()
    assert sss_ref.render(again, "arrays").hashes == expected
    assert dict(again.forms) == dict(scene.forms)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory):
    """Of a scene with overrides, and the dump of a right implementation beside it."""
    folder = tmp_path_factory.mktemp("project")
    overrides = [f"{key}={value}" for key, value in {**SMALL, "translucency.exponent": 0.61}.items()]
    options = [word for each in overrides for word in ("--set", each)]
    assert main(["bundle", "sphere", "-o", str(folder / "bundle"), *options]) == 0
    assert main(["render", "sphere", "-o", str(folder / "out"), *options]) == 0
    shutil.copytree(folder / "out" / "buffers", folder / "dump")
    return folder / "bundle"


def test_the_guides_own_command_passes_as_printed(bundle, monkeypatch, capsys):
    text = (bundle / "PORTING.md").read_text()
    (command,) = [line.split() for line in text.splitlines() if line.startswith("    sss-ref validate ")]
    monkeypatch.chdir(bundle)
    assert main([*command[1:], "--profile", "ieee"]) == 0
    assert "pass: " in capsys.readouterr().out


def test_the_bundles_overrides_count(bundle, capsys):
    """The same dump is wrong for the scene without them, and for the bundle with another number on top."""
    dump, size = str(bundle.parent / "dump"), [word for key in SMALL for word in ("--set", f"{key}=32")]
    assert main(["validate", "sphere", dump, *size]) == 1
    assert main(["validate", str(bundle), dump, "--set", "translucency.exponent=0.6"]) == 1
    assert capsys.readouterr().out.count("fail: stage translucency") == 2


def test_the_bundles_mapping_reads_the_dump(bundle):
    shutil.copy(bundle / "mapping.toml", bundle.parent / "dump")
    assert main(["validate", str(bundle), str(bundle.parent / "dump" / "mapping.toml"), "--profile", "ieee"]) == 0


def test_a_result_of_a_bundle_can_be_verified(bundle, tmp_path, capsys):
    assert main(["render", str(bundle), "-o", str(tmp_path / "out")]) == 0
    assert main(["verify", str(tmp_path / "out")]) == 0
    assert "verified" in capsys.readouterr().out


def spoiled(bundle, folder, file, change):
    """A copy of a bundle with one file changed."""
    shutil.copytree(bundle, folder)
    change(folder / file)
    return folder


def edited(**changes):
    def change(path):
        path.write_text(json.dumps(json.loads(path.read_text()) | changes))

    return change


def without(key):
    def change(path):
        record = json.loads(path.read_text())
        del record[key]
        path.write_text(json.dumps(record))

    return change


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda path: path.unlink(), "scene.json: expected the scene of a bundle, got No such file"),
        (lambda path: path.write_text("{"), "scene.json: file: expected what sss-ref bundle writes, got something"),
        (without("source"), "scene.json: source: expected what sss-ref bundle writes, got something else; write the"),
        (edited(rules_version=0), "scene.json: expected rules version 2, got 0; write the bundle again"),
        (edited(own_stages=["blend"]), "scene.json: expected our stages, got others for blend; use sss_ref.validate"),
        (edited(settings={"mesh": {"path": "none"}}), "mesh.path: expected a mesh file or a shipped mesh's name"),
    ],
)
def test_a_scene_that_cannot_be_rendered_again(bundle, tmp_path, change, message):
    folder = spoiled(bundle, tmp_path / "b", "scene.json", change)
    with pytest.raises(SceneError) as error:
        sss_ref.load_scene(folder)
    assert message in str(error.value)


def test_stages_of_ones_own_are_recorded(tmp_path):
    from sss_ref.passes.phong import phong_shading

    scene = sss_ref.with_stage(sss_ref.load_scene("sphere", **SMALL), "phong_shading", phong_shading)
    write_bundle(scene, tmp_path / "b")
    with pytest.raises(SceneError, match=r"expected our stages, got others for phong_shading; use sss_ref\.validate"):
        sss_ref.load_scene(tmp_path / "b")


def test_a_preset_for_a_bundle_is_refused(bundle, tmp_path):
    with pytest.raises(SceneError, match=r"^override: preset: expected robust, which filled this bundle, got paper; "):
        sss_ref.load_scene(bundle, preset="paper")
    assert sss_ref.load_scene(bundle, preset="robust").settings.preset == "robust"


def test_a_material_for_a_bundle_is_refused(bundle):
    with pytest.raises(SceneError, match=r"^override: material: expected None, which filled this bundle, got wax; "):
        sss_ref.load_scene(bundle, material="wax")


def test_a_layer_of_a_bundle_keeps_its_material_as_well(tmp_path):
    small = {**SMALL, "lights.0.position": [0.0, 0.0, 60.0]}
    folder = write_bundle(sss_ref.load_scene("teeth_layers", **small), tmp_path / "bundle")
    with pytest.raises(SceneError, match=r"^override: layers\[0\].material: expected dentine, which filled "):
        sss_ref.load_scene(folder, **{"layers.0.material": "wax"})


def test_a_mesh_that_is_not_whole_is_refused_by_name(bundle, tmp_path):
    folder = spoiled(bundle, tmp_path / "b", "mesh/uv.npy", lambda path: path.unlink())
    with pytest.raises(
        MeshError, match=r"uv\.npy: expected an NPY file, got No such file or directory; check the path"
    ):
        sss_ref.load_scene(folder)
