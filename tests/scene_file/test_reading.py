import os

import pytest

from sss_ref.errors import SceneError
from sss_ref.scene import load_scene
from sss_ref.scene.catalogue import METHODS, TECHNIQUES
from sss_ref.scene_file.kernels import TABLE1
from sss_ref.scene_file.layers import filled
from sss_ref.scene_file.reading import Document, validated


def problems(scene, **overrides):
    with pytest.raises(SceneError) as error:
        load_scene(scene, **overrides)
    return str(error.value).split("\n")


SCENE = "a scene file, a bundle or a shipped scene (small)"
ANOTHER = "choose another value"
NUMBER = "write it without quotes, such as 1.5"
ONLY_PUBLISHED, OR_THE_PRESET = 'expected another value without preset "published"', "choose one, or the preset"
METHOD_NAMES = [f'"{name}"' for name in (*METHODS, *TECHNIQUES)]
WRONG = [
    (
        "method",
        "ray_tracing",
        f'expected {", ".join(METHOD_NAMES[:-1])} or {METHOD_NAMES[-1]}, got "ray_tracing"; choose one of these',
    ),
    ("preset", "printed", 'expected "paper", "robust" or "published", got "printed"; choose one of these'),
    ("mm_per_unit", True, f"expected a number, got true; {NUMBER}"),
    ("mm_per_unit", "1", f'expected a number, got "1"; {NUMBER}'),
    ("mm_per_unit", 0, f"expected a number > 0 (in float32), got 0; {ANOTHER}"),
    ("mm_per_unit", float("nan"), "expected a finite number, got NaN; nan and inf are not accepted"),
    ("mm_per_unit", 1e39, f"expected a number that fits float32, got 1e+39; {ANOTHER}"),
    ("mesh", 3, "expected a table, got 3; give its keys, each with a value"),
    ("mesh.path", 3, "expected a text, got 3; put it in double quotes"),
    (
        "mesh.path",
        "none.obj",
        'expected a mesh file or a shipped mesh\'s name, got "none.obj"; check the path (shipped: tetrahedron)',
    ),
    (
        "mesh.texture",
        "a.png",
        'expected a PNG or JPEG file, got "a.png"; check the path, which starts at the scene file',
    ),
    ("mesh.unwrap", 1, "expected true or false, got 1; write it without quotes"),
    ("mesh.color", "red", 'expected "material", got "red"; choose one of these'),
    ("mesh.colour", 1, "expected a known key, got this one; did you mean color?"),
    ("mesh.scale", 0, f"expected factors that are not zero, got 0; {ANOTHER}"),
    ("mesh.translate", 1, "expected an array, got 1; put the values in brackets, separated by commas"),
    ("mesh.translate", [1, 2, 3, 4], "expected 3 values, got [1, 2, 3, 4]; remove the others"),
    ("mesh.color", [1, -1, 1], f"[1]: expected a number >= 0, got -1; {ANOTHER}"),
    ("mesh.color", [1, 1], "[2]: expected a value, got nothing; add it"),
    ("translucency.x", "1", f'expected a number, got "1"; {NUMBER}'),
    ("translucency.x", [1, 2], "[2]: expected a value, got nothing; add it"),
    ("translucency.x", [1, 2, 0], f"[2]: expected a number > 0 (in float32), got 0; {ANOTHER}"),
    ("translucency.gaussians", [], f"expected 1 to 64 rows, got []; {ANOTHER}"),
    ("translucency.gaussians", [[0, 1, 1, 1]], f"[0][0]: expected a number > 0 (in float32), got 0; {ANOTHER}"),
    ("camera.fov_y", 180, f"expected an angle between 0 and 180 degrees, got 180; {ANOTHER}"),
    ("camera.width", 1.0, "expected a whole number, got 1.0; write it without quotes or decimal point, such as 1024"),
    ("camera.width", 16385, f"expected a whole number from 1 to 16384, got 16385; {ANOTHER}"),
    ("camera.far", 0.1, "expected a distance beyond near = 0.1, got 0.1; make it larger or near smaller"),
    ("lights", [], "expected 1 to 64 lights, got 0; add or remove [[lights]]"),
    (
        "lights.0.target",
        [0, 0, 9],
        "expected a point other than where it is looked from, got [0, 0, 9]; move one of the two",
    ),
    ("lights.0.up", [0, 0, 0], f"expected a vector that is not zero, got [0, 0, 0]; {ANOTHER}"),
    ("shadow_map.encoding", "float16", 'expected "float32" or "unorm8", got "float16"; choose one of these'),
    ("shadow_map.encoding", "unorm8", f'{ONLY_PUBLISHED}, got "unorm8"; {OR_THE_PRESET}'),
    ("shadow_map.lookup_stage", "vertex", f'{ONLY_PUBLISHED}, got "vertex"; {OR_THE_PRESET}'),
    ("shadow_map.test", "exact", f'{ONLY_PUBLISHED}, got "exact"; {OR_THE_PRESET}'),
    ("irradiance_map.image", "sqrt_add", f'{ONLY_PUBLISHED}, got "sqrt_add"; {OR_THE_PRESET}'),
    ("shadow_map.lookup_inset", 1.5, f"expected a number > 0 and <= 1, got 1.5; {ANOTHER}"),
    ("phong.shininess", 0, f"expected a number > 0 (in float32), got 0; {ANOTHER}"),
    ("translucency.x", -1, f"expected a number > 0 (in float32), got -1; {ANOTHER}"),
    ("translucency.d_min", 0, f"{ONLY_PUBLISHED}, got 0; {OR_THE_PRESET}"),
    ("translucency.d_min", [0.1, 0, 0.1], f"{ONLY_PUBLISHED}, got [0.1, 0, 0.1]; {OR_THE_PRESET}"),
    ("translucency.d_min", 1e-46, f"expected a number >= 0, got 1e-46; {ANOTHER}"),
    ("blur.kernel", "gauss", 'expected "table1", "hbh09" or "schoenberger", got "gauss"; choose one of these'),
    ("blur.kernel", [], f"expected at least one row, got []; {ANOTHER}"),
    ("blur.kernel", [[0, 0, 1, 1]], "[0][4]: expected a value, got nothing; add it"),
    (
        "blur.pixel_scale",
        5000,
        "expected taps within 16384 pixels (the farthest is at 6.2976), got 5000; choose a smaller scale",
    ),
    ("blur.normalize", 1, "expected true or false, got 1; write it without quotes"),
    ("irradiance_map.dilate", -1, f"expected a whole number from 0 to 16384, got -1; {ANOTHER}"),
    ("output.alpha", 1, "expected a known key, got this one; remove it (known here: background, exposure)"),
]


@pytest.mark.parametrize("key, value, message", WRONG, ids=str)
def test_one_wrong_value(small, key, value, message):
    where = key.replace("lights.0", "lights[0]")
    element = message.startswith("[")
    assert problems(small, **{key: value}) == [f"override: {where}{'' if element else ': '}{message}"]


FIXED = [
    ("shadow_map.filter", "nearest", '"bilinear"'),
    ("shadow_map.test", "slope", '"exact"'),
    ("shadow_map.encoding", "float32", '"unorm8"'),
    ("shadow_map.lookup_stage", "fragment", '"vertex"'),
    ("translucency.form", "ratio", '"exponent"'),
    ("translucency.combine", "transmit", '"add"'),
    ("translucency.d_min", 0.1, "0.0"),
    ("blur.mask", "taps", '"none"'),
    ("irradiance_map.mode", "paper", '"distance"'),
    ("irradiance_map.image", "sqrt", '"sqrt_add"'),
    ("irradiance_map.dilate", 4, "0"),
    ("lights.0.falloff", "inverse_square", '"none"'),
]


@pytest.mark.parametrize("key, value, fixed", FIXED, ids=str)
def test_the_passes_of_the_figures_are_fixed(small, key, value, fixed):
    where, came = key.replace("lights.0", "lights[0]"), f'"{value}"' if isinstance(value, str) else value
    remedy = "remove it or choose another preset"
    line = f'override: {where}: expected {fixed} with preset "published", got {came}; {remedy}'
    assert problems(small, preset="published", **{key: value}) == [line]
    assert load_scene(small, preset="published").settings.preset == "published"


def test_the_figures_have_one_light(small):
    lights = [{"position": [0, 0, 9]}] * 2
    expected = 'lights: expected one light with preset "published", got 2; remove it or choose another preset'
    assert problems(small, preset="published", lights=lights) == [f"override: {expected}"]


def test_toml_that_cannot_be_parsed(tmp_path):
    path = tmp_path / "a.toml"
    path.write_text('method = "screen_space"\nmesh path = 3\n')
    (line,) = problems(path)
    assert line == f"{path}: expected valid TOML, got none at line 2, column 6; correct that place"
    path.write_text("a = " + "[" * 100_000)
    assert problems(path) == [f"{path}: expected valid TOML, got brackets or keys nested without end; nest less"]
    path.write_bytes(b"\xff")
    expected = f"{path}: expected {SCENE} in UTF-8, got a byte that is no UTF-8 at byte 0; save it as UTF-8"
    assert problems(path) == [expected]


def test_what_is_no_file_is_never_waited_for(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for path in ("/dev/zero", tmp_path / "pipe"):
        assert problems(path) == [f"{path}: expected {SCENE}, got no regular file; copy its content to one"]


def test_missing_scene_file():
    assert problems("none.toml") == [f"none.toml: expected {SCENE}, got No such file or directory; check the path"]


def test_all_problems_of_a_file_at_once(tmp_path):
    path = tmp_path / "a.toml"
    path.write_text(
        """
        [mesh]
        path = "none.obj"
        [camera]
        type = "look_at"
        eye = [0, 0, 0]
        near = 5
        far = 4
        widht = 64
        [[lights]]
        [phong]
        shininess = true
        """
    )
    assert problems(path, **{"output.background": [1, 1], "lights.3.near": 1}) == [
        "override: lights.3.near: expected an index below 1, got 3; correct it",
        f'{path}: mesh.path: expected a mesh file or a shipped mesh\'s name, got "none.obj"; '
        "check the path (shipped: tetrahedron)",
        f"{path}: camera.far: expected a distance beyond near = 5, got 4; make it larger or near smaller",
        f"{path}: camera.target: expected a point other than where it is looked from, got [0.0, 0.0, 0.0]; "
        "move one of the two",
        f"{path}: camera.widht: expected a known key, got this one; did you mean width?",
        f"{path}: lights[0].position: expected a value, got nothing; add it, or azimuth, elevation and distance",
        f"{path}: phong.shininess: expected a number, got true; write it without quotes, such as 1.5",
        "override: output.background[2]: expected a value, got nothing; add it",
    ]


def test_too_many_lights(small):
    small["lights"] *= 65
    (line,) = problems(small)
    assert line == "scene: lights: expected 1 to 64 lights, got 65; add or remove [[lights]]"


def test_two_lights(small):
    small["lights"] *= 2
    assert len(load_scene(small).lights) == 2


def test_unknown_camera_type(small):
    assert problems({**small, "camera": {}}) == [
        'scene: camera: expected a type, got {}; add type = "orbit", "look_at", "free" or "orthographic"'
    ]
    assert problems(small, **{"camera.type": "orbital"}) == [
        'override: camera.type: expected "orbit", "look_at", "free" or "orthographic", got "orbital"; '
        "choose one of these"
    ]


def test_unknown_light_type(small):
    """No value of it is taken for another: neither one nor none."""
    for wrong, came in (("spot", '"spot"'), (3, "3"), (None, "null")):
        assert problems(small, **{"lights.0.type": wrong}) == [
            f'override: lights[0].type: expected "point" or "directional", got {came}; choose one of these'
        ]


def test_normalizing_a_kernel_without_weight(small):
    kernel = [[0, 0, 1, 1, 1], [1, 0, -1, 1, 1]]
    assert problems(small, blur={"kernel": kernel, "normalize": True}) == [
        "override: blur.normalize: expected a kernel whose channels have sums other than 0, got true; "
        "set it to false or change the kernel"
    ]
    assert load_scene(small, blur={"kernel": [list(row) for row in TABLE1], "normalize": True}).settings.blur.normalize


def test_a_wrong_angle_of_a_light_is_one_problem(small):
    """Its position is not asked for: who writes an angle means an orbit."""
    small["lights"] = [{"azimuth": "north", "distance": 9}]
    assert problems(small) == [f'scene: lights[0].azimuth: expected a number, got "north"; {NUMBER}']


@pytest.mark.parametrize(
    ("key", "given", "before", "now", "other"),
    [
        ("preset", "robust", "paper", "robust", "preset"),
        ("material", "milk", "wax", "milk", "material"),
        ("layers.0.material", "enamel", "dentine", "enamel", "material"),
    ],
)
def test_a_bundle_stays_with_what_has_filled_it(small, tmp_path, key, given, before, now, other):
    layer = {"path": "tetrahedron", "extinction_per_mm": [1, 1, 1], "material": "dentine"}
    data = filled({**small, "preset": "paper", "material": "wax", "mm_per_unit": 2.0, "layers": [layer]})
    bundle = Document(data, "b", tmp_path, "paper")
    assert validated(bundle, {}).material == "wax"
    assert validated(bundle, {"preset": "paper", "layers.0.material": "dentine"}).preset == "paper"
    with pytest.raises(SceneError) as caught:
        validated(bundle, {key: given})
    remedy = f"bundle the scene with the other {other}"
    where = key.replace(".0", "[0]")
    assert str(caught.value) == f"override: {where}: expected {before}, which filled this bundle, got {now}; {remedy}"
    assert validated(Document(data, "b", tmp_path), {key: given})
