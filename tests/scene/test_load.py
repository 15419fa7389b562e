import subprocess
import sys

import numpy as np
import pytest

from sss_ref.errors import SceneError
from sss_ref.scene import load_scene

EXPLICIT = {"target": [0, 0, 0], "fov_y": 90, "near": 0.1, "far": 10}


def problems(scene, **overrides):
    with pytest.raises(SceneError) as error:
        load_scene(scene, **overrides)
    return str(error.value).split("\n")


def test_importing_scenes_is_light():
    code = "import sys, sss_ref.scene; print([m for m in ('numba', 'trimesh', 'mpmath', 'scipy') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "[]\n"


def test_scene_from_a_file(tmp_path, data_folder):
    (tmp_path / "own.obj").write_text((data_folder / "meshes" / "tetrahedron.obj").read_text())
    path = tmp_path / "a.toml"
    path.write_text(
        'preset = "robust"\n[mesh]\npath = "own.obj"\nscale = 2\nrotate_degrees = [0, 0, 90]\ntranslate = [1, 0, 0]\n'
        '[camera]\ntype = "free"\nposition = [0, 0, 7]\nwidth = 64\nheight = 32\n[[lights]]\nposition = [0, 0, 9]\n'
    )
    scene = load_scene(path)
    assert (scene.source, scene.mesh.name, scene.warnings) == (str(path), "own.obj", ())
    assert np.array_equal(scene.world_from_model, [[0, -2, 0, 1], [2, 0, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]])
    assert (scene.camera.width, scene.camera.height, tuple(scene.camera.target)) == (64, 32, (0, 0, 6))
    assert scene.settings.blur.kernel == "hbh09"
    # The corners in the world: (1, 0, 0), (1, 2, 0), (-1, 0, 0), (1, 0, 2).
    assert scene.settings.lights[0].target == (0, 1, 1)
    assert np.array_equal(scene.lights[0].view.target, [0, 1, 1])


def test_resolved_settings_load_to_the_same_scene(small):
    scene = load_scene(small, preset="robust")
    again = load_scene(scene.settings.model_dump())
    assert again.settings == scene.settings
    for one, other in ((scene.camera, again.camera), (scene.lights[0].view, again.lights[0].view)):
        assert one.clip_from(np.eye(4)).tobytes() == other.clip_from(np.eye(4)).tobytes()


def test_overrides(small):
    scene = load_scene(small, preset="robust", **{"camera.width": 256, "lights.0.intensity": 2, "translucency.x": 3})
    assert (scene.camera.width, scene.lights[0].intensity, scene.settings.translucency.x) == (256, 2.0, 3.0)
    assert scene.settings.translucency.combine == "transmit_wrapped"


def test_light_inside_and_camera_along_up_are_told_together(small):
    camera = {"type": "look_at", "eye": [0, 0, 5], "up": [0, 0, 1]}
    light = {"position": [0.1, 0.1, 0.1], **EXPLICIT}
    assert problems(small, camera=camera, lights=[light]) == [
        "scene: camera: expected an up across the line of sight, got one along it; give up = [0.0, 1.0, 0.0]",
        "scene: lights[0]: expected a light outside the mesh, got [0.1, 0.1, 0.1] inside; move it out",
    ]


def test_light_in_the_box_but_outside_the_mesh(small):
    scene = load_scene(small, lights=[{"position": [0.9, 0.9, 0.9], **EXPLICIT}])
    assert scene.warnings == ()


def test_light_within_a_mesh_with_holes(small, data_folder):
    path = data_folder / "meshes" / "tetrahedron.obj"
    path.write_text(path.read_text().replace("f 1 2 4\n", ""))
    scene = load_scene(small, lights=[{"position": [0.1, 0.1, 0.1], **EXPLICIT}])
    assert scene.warnings == ("lights[0]: it may be inside the mesh, which has holes",)


def test_light_too_close_for_the_fit(small):
    (line,) = problems(small, lights=[{"position": [0.9, 0.9, 0.9]}])
    assert line.startswith("scene: lights[0]: expected a light farther than 0.9093")
    assert line.endswith("; move it or give fov_y, near and far")


def test_camera_inside(small):
    scene = load_scene(small, camera={"type": "free", "position": [0.1, 0.1, 0.1]})
    assert scene.warnings == ("camera: it is inside the mesh and sees its back faces",)


def test_mesh_far_from_the_origin(small):
    # The radius is sqrt(3) / 2; 100 radii are 86.6.
    near = load_scene(small, **{"mesh.translate": [86, 0, 0]})
    assert not any(line.startswith("mesh:") for line in near.warnings)
    far = load_scene(small, **{"mesh.translate": [87, 0, 0]})
    assert far.warnings[0] == (
        "mesh: it is more than 100 radii from the origin, where float32 positions are coarse; "
        "set mesh.translate = [-0.5, -0.5, -0.5] and move camera and lights along"
    )
    assert load_scene(small, **{"mesh.translate": [-0.5, -0.5, -0.5]}).warnings == ()


def test_notes_of_the_mesh_become_warnings(small, data_folder):
    path = data_folder / "meshes" / "tetrahedron.obj"
    path.write_text("vn 0 0 1\n" + path.read_text())
    assert load_scene(small).warnings == ("mesh: normals computed: the file does not give them for every corner",)


def test_world_beyond_float32(small):
    light = {"position": [0, 0, 9], **EXPLICIT}
    assert problems(small, lights=[light], **{"mesh.scale": 2e38, "mesh.translate": [2e38, 0, 0]})[0] == (
        "scene: mesh: expected world positions that fit float32, got 4e+38; choose a smaller scale"
    )


def test_texture_space_without_uvs_is_told_with_the_rest(small):
    wrong = {"mesh.color": "material", "camera.near": 2e38, "camera.far": 3e38}
    lines = problems(small, method="texture_space", **wrong)
    assert [line.split(": expected")[0] for line in lines] == ["scene: method", "scene: mesh.color", "scene: camera"]
    assert lines[0] == ("scene: method: expected a mesh with UVs, got tetrahedron.obj without; set mesh.unwrap = true")


def test_projection_beyond_float32(small):
    (line,) = problems(small, **{"camera.near": 2e38, "camera.far": 3e38})
    assert line == (
        "scene: camera: expected a projection that fits float32, got larger numbers; bring eye, near and far closer"
    )
