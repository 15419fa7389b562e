import numpy as np
import pytest
from filled_scenes import LAYERS, are_filled_as_ever
from pydantic import ValidationError

from sss_ref.scene_file import settings
from sss_ref.scene_file.key_texts import key_texts
from sss_ref.scene_file.layers import filled
from sss_ref.scene_file.settings import MeshSettings, SceneFile

COMMON = {
    "diffusion": {
        "profile": "skin",
        "reach_mm": 8.0,
        "taps": 25,
        "albedo": (0.63, 0.44, 0.34),
        "mean_free_path_mm": (0.907, 0.602, 0.517),
        "samples": 64,
        "sharpest_curvature": 0.5,
    },
    "layers": (),
    "method": "screen_space",
    "material": None,
    "mm_per_unit": 1.0,
    "mesh": {
        "path": "tetrahedron",
        "scale": (1.0, 1.0, 1.0),
        "rotate_degrees": (0.0, 0.0, 0.0),
        "translate": (0.0, 0.0, 0.0),
        "color": (0.7, 0.4, 0.4),
        "texture": None,
        "normal_map": None,
        "normal_map_green": "up",
        "normal_strength": 1.0,
        "specular_map": None,
        "unwrap": False,
    },
    "camera": {
        "type": "orbit",
        "target": (0.0, 0.0, 0.0),
        "azimuth": 0.0,
        "elevation": 0.0,
        "distance": 5.0,
        "fov_y": 45.0,
        "near": 0.1,
        "far": 100.0,
        "width": 1024,
        "height": 1024,
    },
    "lights": (
        {
            **dict.fromkeys(("azimuth", "elevation", "distance")),
            "position": (0.0, 0.0, 9.0),
            "type": "point",
            "target": None,
            "up": (0.0, 1.0, 0.0),
            "color": (1.0, 1.0, 1.0),
            "intensity": 1.0,
            "fov_y": None,
            "near": None,
            "far": None,
            "falloff": "none",
        },
    ),
    "shadow_map": {
        "width": 2048,
        "height": 2048,
        "filter": "nearest",
        "lookup_inset": 1.0,
        "test": "slope",
        "bias_abs": 0.0,
        "bias_slope": 1.5,
        "kernel_scale": 6.0,
        "lookup_depth": 6.0,
        "encoding": "float32",
        "lookup_stage": "fragment",
    },
    "phong": {"ambient": 0.1, "diffuse": 1.0, "specular": 0.5, "shininess": 32.0},
    "output": {"background": (0.0, 0.0, 0.0), "exposure": 0.0},
}

IN_PIXELS = {"unit": "pixel", "mm_per_offset": 1.2, "follow_surface": False, "normalize": False}
BY_PRESET = {
    "paper": {
        "translucency": {
            "form": "ratio",
            "combine": "multiply",
            "x": 2.0,
            "y": -1.0,
            "exponent": 0.6,
            "scale": 1.0,
            "d_min": 0.1,
            "gaussians": "skin",
            "wrap": 0.3,
        },
        "blur": {"kernel": "table1", "mask": "output", "pixel_scale": 1.0, **IN_PIXELS},
        "irradiance_map": {
            "width": 1024,
            "height": 1024,
            "mode": "paper",
            "image": "sqrt",
            "overlap": "first",
            "dilate": 4,
        },
    },
    "robust": {
        "shadow_map": {**COMMON["shadow_map"], "test": "kernel"},
        "translucency": {
            "form": "ratio",
            "combine": "transmit_wrapped",
            "x": 2.0,
            "y": 0.5,
            "exponent": 0.75,
            "scale": 0.05,
            "d_min": 0.03,
            "gaussians": "skin",
            "wrap": 0.5,
        },
        "blur": {"kernel": "hbh09", "mask": "taps", "pixel_scale": 2.0, **IN_PIXELS},
        "irradiance_map": {
            "width": 1024,
            "height": 1024,
            "mode": "lambert",
            "image": "product",
            "overlap": "first",
            "dilate": 8,
        },
    },
    "published": {
        "camera": {**COMMON["camera"], "near": 0.001, "far": 1000.0, "width": 1600, "height": 900},
        "lights": ({**COMMON["lights"][0], "target": (0.0, 0.0, 0.0), "fov_y": 90.0, "near": 0.001, "far": 1000.0},),
        "shadow_map": {
            "width": 1600,
            "height": 900,
            "filter": "bilinear",
            "lookup_inset": 0.99,
            "test": "exact",
            "bias_abs": 0.0,
            "bias_slope": 1.5,
            "kernel_scale": 6.0,
            "lookup_depth": 6.0,
            "encoding": "unorm8",
            "lookup_stage": "vertex",
        },
        "translucency": {
            "form": "exponent",
            "combine": "add",
            "x": 0.5,
            "y": 1.0,
            "exponent": 0.6,
            "scale": 1.0,
            "d_min": 0.0,
            "gaussians": "skin",
            "wrap": 0.3,
        },
        "blur": {"kernel": "schoenberger", "mask": "none", "pixel_scale": 1.0, **IN_PIXELS},
        "irradiance_map": {
            "width": 1600,
            "height": 900,
            "mode": "distance",
            "image": "sqrt_add",
            "overlap": "first",
            "dilate": 0,
        },
    },
}


@pytest.mark.parametrize("preset", BY_PRESET)
def test_every_key_of_a_preset(small, preset):
    resolved = SceneFile.model_validate(filled({**small, "preset": preset}))
    assert resolved.model_dump() == {**COMMON, "preset": preset, **BY_PRESET[preset]}


def test_layers_are_filled_as_ever(tmp_path):
    are_filled_as_ever(LAYERS, tmp_path)


def test_whole_numbers_become_float(small):
    resolved = SceneFile.model_validate(filled({**small, "mm_per_unit": 2}))
    assert type(resolved.mm_per_unit) is float and type(resolved.mesh.scale[0]) is float
    assert MeshSettings(path="x", scale=3).scale == (3.0, 3.0, 3.0)
    assert MeshSettings(path="x", scale=np.float64(0.5)).scale == (0.5, 0.5, 0.5)


def test_every_parameter_is_explained():
    from sss_ref.scene_file.reading import TABLES

    for table in list(TABLES.values())[1:]:
        assert {name for name, text in key_texts(table).items() if not text} <= {"type"}


@pytest.mark.parametrize("key", ["shadow_map", "phong", "diffusion", "output"])
def test_tables_left_out_are_what_empty_ones_become(key):
    default = SceneFile.model_fields[key].default
    assert type(default).model_validate({}) == default
    assert type(default).model_validate(default.model_dump()) == default


def test_a_table_that_was_read_does_not_change():
    """What several scenes share stays as the file says."""
    table = MeshSettings(**COMMON["mesh"])
    with pytest.raises(ValidationError, match="frozen"):
        table.unwrap = True


def test_the_body_inside_is_seen_as_if_it_were_the_mesh(small):
    """At the same place, with its own colour, highlight and translucency, and without the mesh's pictures."""
    mesh = {"path": "outer", "scale": 2.0, "unwrap": True, "texture": "a", "normal_map": "b", "specular_map": "c"}
    layer = {"path": "inner", "color": [0.1, 0.2, 0.3], "extinction_per_mm": [1, 2, 3], "phong": {"ambient": 0.5}}
    given = {**small, "mm_per_unit": 4.0, "mesh": mesh, "layers": [{**layer, "translucency": {"scale": 0.25}}]}
    scene = SceneFile.model_validate(filled(given))
    inner = scene.inner
    bare = {"texture": None, "normal_map": None, "specular_map": None, "unwrap": False}
    own = {"path": "inner", "color": (0.1, 0.2, 0.3), **bare}
    assert inner.mesh.model_dump() == {**scene.mesh.model_dump(), **own}
    assert (inner.phong.ambient, inner.translucency.scale, inner.layers) == (0.5, 0.25, ())
    assert (inner.camera, inner.mm_per_unit) == (scene.camera, 4) and inner.inner is None


@pytest.mark.parametrize("method", ["screen_space", "texture_space", "separable"])
@pytest.mark.parametrize("mask", ["none", "output", "taps"])
def test_light_leaves_the_model_where_the_blur_of_the_picture_has_no_mask(small, method, mask):
    scene = SceneFile.model_validate(filled({**small, "method": method, "blur": {"mask": mask}}))
    assert scene.glows == ((method, mask) == ("screen_space", "none"))


@pytest.mark.parametrize(("height", "fits"), [(5461, True), (5462, False)])
def test_pictures_take_no_more_than_four_gibibytes(small, monkeypatch, tmp_path, height, fits):
    """12 bytes a texel: 16384 x 16384 take 3 GiB; 16384 x 5461.33 the fourth."""
    sizes = {tmp_path / "a.png": (16384, height), tmp_path / "b.png": (16384, 16384)}
    for path in sizes:
        path.write_bytes(b"")
    monkeypatch.setattr(settings, "texture_size", sizes.__getitem__)
    mesh = {**small["mesh"], "texture": "a.png", "normal_map": "b.png"}
    data, context = filled({**small, "mesh": mesh}), {"folder": tmp_path}
    if fits:
        assert SceneFile.model_validate(data, context=context).mesh.texture == "a.png"
        return
    with pytest.raises(ValidationError) as caught:
        SceneFile.model_validate(data, context=context)
    ((where, said),) = [(each["loc"], each["msg"]) for each in caught.value.errors()]
    assert "normal_map" in f"{where} {said} {caught.value.errors()[0]}" and "at most 4 GiB of pictures" in said
