"""Unwrapping adds UVs to a mesh and changes nothing else; what goes wrong in xatlas stays in its process."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scenes import around, cube, sphere, written

from sss_ref.cache.root import cache_below
from sss_ref.errors import MeshError
from sss_ref.mesh import unwrap
from sss_ref.mesh.unwrap import unwrapped
from sss_ref.mesh.uv_facts import uv_facts
from sss_ref.rendering.fold import render
from sss_ref.scene import Mesh, load_mesh, load_scene

MESHES = Path(__file__).parents[2] / "data" / "meshes"
SHIPPED = [
    "bust.glb",
    "seam_cube.obj",
    "sphere.glb",
    "stretched_plane.glb",
    "teaching.glb",
    "torus.glb",
    "two_slabs.obj",
]
MAP = 256  # texels across and down, on which the charts of small bodies do not overlap


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    """An empty folder in which atlases will be kept; compiled kernels stay where they are."""
    folder = tmp_path / "cache"

    def cache_of_the_test(name):
        assert name == "unwrapped"
        folder.mkdir(exist_ok=True)
        return folder

    monkeypatch.setattr(unwrap, "cache_below", cache_of_the_test)
    return folder


@pytest.fixture
def xatlas():
    """For tests that unwrap."""
    return pytest.importorskip("xatlas")


@pytest.fixture
def ball(tmp_path):
    """A sphere without UVs."""
    return written(tmp_path / "ball.obj", *sphere(12)[:2])


def pretending(monkeypatch, tmp_path, code):
    """Let a process that runs `code` take the place of xatlas', whether that is installed or not."""
    (tmp_path / "process.py").write_text(f"import os, sys, time\nimport numpy as np\n{code}\n")
    monkeypatch.setattr(unwrap, "PROCESS", tmp_path / "process.py")
    monkeypatch.setattr(unwrap, "version", lambda name: "0")


def refusal(path):
    with pytest.raises(MeshError) as error:
        unwrapped(load_mesh(Path(path)))
    return str(error.value)


@pytest.mark.parametrize("name", SHIPPED)
def test_triangles_keep_their_order_positions_normals_and_materials(xatlas, name):
    mesh = replace(load_mesh(MESHES / name), uvs=None)
    result = unwrapped(mesh)
    for array in ("positions", "normals"):
        before, after = getattr(mesh, array)[mesh.triangles], getattr(result, array)[result.triangles]
        assert before.tobytes() == after.tobytes()
    assert result.material is mesh.material and result.normals_source == mesh.normals_source
    facts = uv_facts(result)
    assert facts.out_of_range == 0 and facts.zero_area == 0
    assert result.notes[-1] == f"UVs were made by xatlas {xatlas.__version__} ({result.charts} charts)"


def test_a_mesh_with_uvs_keeps_them(tmp_path):
    path = written(tmp_path / "ball.obj", *sphere(12))
    mesh, result = load_mesh(Path(path)), unwrapped(load_mesh(Path(path)))
    assert result.hashes() == mesh.hashes() and result.charts == 0
    assert result.notes == ("mesh.unwrap has no effect: the file has UVs, and they are kept",)
    assert load_scene(around(path), **{"mesh.unwrap": True}).warnings == (f"mesh: {result.notes[0]}",)


def test_a_vertex_that_no_triangle_uses_stays(xatlas, ball):
    """Lights are fitted to all vertices."""
    mesh = load_mesh(Path(ball))
    more = (np.append(array, np.float32([[3, 0, 0]]), axis=0) for array in (mesh.positions, mesh.normals))
    result = unwrapped(replace(mesh, **dict(zip(("positions", "normals"), more, strict=True))))
    assert result.positions[-1].tolist() == [3, 0, 0] and result.uvs[-1].tolist() == [0, 0]


def test_in_screen_space_only_uv_changes(xatlas, ball):
    before = render(load_scene(around(ball, size=48)), interpreter="arrays")
    after = render(load_scene(around(ball, size=48), **{"mesh.unwrap": True}), interpreter="arrays")
    assert [name for name in before.buffers if before.hashes[name] != after.hashes[name]] == ["uv"]


@pytest.mark.parametrize("preset", ["paper", "robust"])
def test_both_interpreters_agree_on_an_unwrapped_mesh(xatlas, ball, preset):
    tables = {"method": "texture_space", "irradiance_map.width": 64, "irradiance_map.height": 64}
    scene = load_scene(around(ball, size=48, preset=preset), **{"mesh.unwrap": True}, **tables)
    compiled, expected = render(scene), render(scene, interpreter="arrays")
    assert compiled.hashes == expected.hashes
    assert compiled["image"][compiled["coverage"] == 1].any()


def test_every_triangle_of_the_sphere_is_on_the_map_and_none_on_another(xatlas, ball):
    """The middle of each triangle lies on a texel that is drawn and that no other has; nothing is drawn twice."""
    tables = {"method": "texture_space", "irradiance_map.width": MAP, "irradiance_map.height": MAP}
    scene = load_scene(around(ball, size=48), **{"mesh.unwrap": True}, **tables)
    result = render(scene, keep=["irradiance_mask"], interpreter="arrays")
    assert result.notes == ()
    u, v = np.moveaxis(scene.mesh.uvs[scene.mesh.triangles].astype(np.float64), 2, 0)
    column, row = (u.mean(axis=1) * MAP).astype(int), (v.mean(axis=1) * MAP).astype(int)
    assert (result["irradiance_mask"][row, column] == 1).all()
    assert len(set(zip(row.tolist(), column.tolist(), strict=True))) == len(scene.mesh.triangles)


def test_a_texture_on_made_uvs_is_told_of(xatlas, ball, tmp_path):
    from PIL import Image

    Image.new("RGB", (1, 1)).save(tmp_path / "a.png")
    scene = load_scene(around(ball), **{"mesh.unwrap": True, "mesh.texture": str(tmp_path / "a.png")})
    assert "mesh: the texture follows UVs that mesh.unwrap made, not those it was painted for" in scene.warnings


# What is kept


def test_an_atlas_is_kept_and_used_again(xatlas, ball, cache, monkeypatch):
    first = unwrapped(load_mesh(Path(ball)))
    (kept,) = cache.iterdir()  # and nothing temporary
    monkeypatch.setattr(unwrap, "_made", None)
    assert unwrapped(load_mesh(Path(ball))).hashes() == first.hashes()
    monkeypatch.setattr(unwrap, "version", lambda name: "another")
    with pytest.raises(TypeError):
        unwrapped(load_mesh(Path(ball)))
    assert list(cache.iterdir()) == [kept]


@pytest.mark.parametrize("damage", [b"", b"text", "cut", "other"], ids=str)
def test_a_damaged_atlas_is_made_anew(xatlas, ball, cache, tmp_path, damage):
    first = unwrapped(load_mesh(Path(ball)))
    (kept,) = cache.iterdir()
    whole = kept.read_bytes()
    unwrapped(load_mesh(Path(written(tmp_path / "cube.obj", *cube()))))
    (other,) = set(cache.iterdir()) - {kept}
    kept.write_bytes({"cut": whole[: len(whole) // 2], "other": other.read_bytes()}.get(damage, damage))
    assert unwrapped(load_mesh(Path(ball))).hashes() == first.hashes()
    assert unwrap._read(kept, load_mesh(Path(ball))) is not None


def test_without_a_cache_it_works_all_the_same(xatlas, ball, tmp_path, monkeypatch):
    (tmp_path / "file").write_text("a file where the folder would be")
    monkeypatch.setattr(unwrap, "cache_below", cache_below)
    monkeypatch.setenv("SSS_REF_CACHE_DIR", str(tmp_path / "file"))
    assert isinstance(unwrapped(load_mesh(Path(ball))), Mesh)


# What goes wrong


def test_without_the_extra(ball, monkeypatch):
    def missing(name):
        raise unwrap.PackageNotFoundError(name)

    monkeypatch.setattr(unwrap, "version", missing)
    assert refusal(ball) == (
        'ball.obj: expected the package xatlas, which mesh.unwrap needs, got none; run pip install "sss_ref[unwrap]"'
    )


ELSEWHERE = "; unwrap it in a modelling program"
OTHERS = "ball.obj: expected all triangles within 0 to 1 from xatlas, got others" + ELSEWHERE
WRITE = (
    "P = np.load(sys.argv[1]); t = P['triangles']; v = np.arange(len(P['positions'])); uvs = np.zeros((len(v), 2))\n"
)
SAVE = "\nnp.savez(sys.argv[2], vertices=v, triangles=t, uvs=uvs, charts=1)"
FAILURES = {
    "crash": ("os._exit(7)", "ball.obj: expected UVs from xatlas, got none (it crashed with exit code 7)" + ELSEWHERE),
    "exception": (
        "1 / 0",
        "ball.obj: expected UVs from xatlas, got none (ZeroDivisionError: division by zero)" + ELSEWHERE,
    ),
    "no file": ("", OTHERS),
    "not a number": (WRITE + "uvs[5] = np.nan" + SAVE, OTHERS),
    "outside": (WRITE + "uvs[5] = 1.01" + SAVE, OTHERS),
    "another order": (WRITE + "t = t[::-1]" + SAVE, OTHERS),
    "a triangle less": (WRITE + "t = t[1:]" + SAVE, OTHERS),
}


@pytest.mark.parametrize("case", FAILURES)
def test_failures_are_told(ball, cache, tmp_path, monkeypatch, case):
    code, message = FAILURES[case]
    pretending(monkeypatch, tmp_path, code)
    assert refusal(ball) == message
    assert not list(cache.iterdir())


def test_what_these_failures_start_from_is_accepted(ball, tmp_path, monkeypatch):
    pretending(monkeypatch, tmp_path, WRITE + SAVE)
    assert unwrapped(load_mesh(Path(ball))).charts == 1


def test_a_process_that_never_ends(ball, tmp_path, monkeypatch):
    pretending(monkeypatch, tmp_path, "time.sleep(60)")
    monkeypatch.setattr(unwrap, "TIME_LIMIT", 0.5)
    assert refusal(ball) == (
        "ball.obj: expected UVs from xatlas, got none after 0.5 seconds; "
        "simplify the mesh or unwrap it in a modelling program"
    )


def test_a_surface_without_area(xatlas, tmp_path):
    path = tmp_path / "line.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
    assert refusal(path) == "line.obj: expected UVs from xatlas, got none (no triangle has an area)" + ELSEWHERE


def test_the_process_needs_nothing_of_the_package(tmp_path):
    """So it starts at once, and wherever the package was imported from."""
    code = f"import runpy, sys; runpy.run_path({str(unwrap.PROCESS)!r}); print('sss_ref' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"
