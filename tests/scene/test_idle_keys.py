"""Keys without effect: told just where no bit of a rendering depends on them."""

import numpy as np
import pytest
from PIL import Image
from scenes import around, sphere, written

from sss_ref.rendering.fold import render
from sss_ref.scene.idle_keys import NEEDS
from sss_ref.scene.load import load_scene

ROBUST = {"preset": "robust", "mm_per_unit": 40.0, "mesh.normal_map": "bumps.png"}
PLAIN = {"preset": "paper", "mesh.normal_map": None}
TEXTURE = {"method": "texture_space", "irradiance_map.width": 32, "irradiance_map.height": 32}
CASES = {  # key -> another value, a scene where it counts, and one where it does not
    "mesh.normal_strength": (0.5, ROBUST, PLAIN),
    "mesh.normal_map_green": ("down", ROBUST, PLAIN),
    "shadow_map.kernel_scale": (1.5, ROBUST | {"shadow_map.bias_slope": 0.0}, PLAIN),
    "shadow_map.bias_slope": (0.1, PLAIN, {"shadow_map.test": "literal"}),
    "shadow_map.lookup_depth": (2.0, ROBUST, PLAIN),
    "translucency.wrap": (0.25, ROBUST, PLAIN),
    "translucency.scale": (0.5, ROBUST, PLAIN),
    "translucency.gaussians": ("wax", {"translucency.form": "gaussians", "mm_per_unit": 4.0}, ROBUST),
    "translucency.x": (1.5, ROBUST, {"translucency.form": "gaussians"}),
    "translucency.y": (1.5, ROBUST, {"translucency.form": "beer"}),
    "translucency.exponent": (1.5, ROBUST, {"translucency.form": "beer"}),
    "translucency.d_min": (0.5, ROBUST, {"translucency.form": "beer"}),
    "blur.pixel_scale": (3.0, PLAIN, {"blur.unit": "mm"}),
    "blur.mm_per_offset": (3.0, ROBUST, PLAIN),
    "diffusion.profile": ("wax", {"method": "separable", "mm_per_unit": 4.0}, {"method": "burley"}),
    "diffusion.reach_mm": (4.0, {"method": "separable", "mm_per_unit": 4.0}, {"method": "burley"}),
    "diffusion.taps": (9, {"method": "separable", "mm_per_unit": 4.0}, PLAIN),
    "diffusion.albedo": ([0.1, 0.2, 0.9], {"method": "burley", "mm_per_unit": 4.0}, {"method": "separable"}),
    "diffusion.mean_free_path_mm": ([2.0, 1.0, 0.5], {"method": "burley", "mm_per_unit": 4.0}, PLAIN),
    "diffusion.samples": (9, {"method": "burley", "mm_per_unit": 4.0}, {"method": "separable"}),
    "diffusion.sharpest_curvature": (0.3, {"method": "preintegrated", "mm_per_unit": 4.0}, {"method": "burley"}),
}


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    """A document of a sphere, and a normal map beside it."""
    folder = tmp_path_factory.mktemp("ball")
    noise = np.random.default_rng(3).integers(64, 192, (16, 16, 3), np.uint8)
    Image.fromarray(noise).save(folder / "bumps.png")
    return around(written(folder / "ball.obj", *sphere(12)), 32), folder


def loaded(ball, given):
    document, folder = ball
    paths = {"mesh.normal_map": str(folder / "bumps.png")} if given.get("mesh.normal_map") else {}
    return load_scene(document, **{**{key: each for key, each in given.items() if each is not None}, **paths})


def idle(scene):
    return [line.partition(":")[0] for line in scene.warnings if "it changes nothing without" in line]


def test_every_key_has_its_case():
    assert {".".join(key) for key in NEEDS} == set(CASES)


@pytest.mark.parametrize("key", CASES)
def test_it_is_told_just_where_no_bit_depends_on_it(ball, key):
    other, counts, idles = CASES[key]
    for given, is_idle in ((counts, False), (idles, True)):
        usual, changed = loaded(ball, given), loaded(ball, {**given, key: other})
        assert idle(usual) == [] and idle(changed) == ([key] if is_idle else [])
        same = render(usual, "arrays").hashes == render(changed, "arrays").hashes
        assert same == is_idle


@pytest.mark.parametrize(
    ("key", "image", "told"),
    [("scale", "product", False), ("scale", "sqrt", True), ("wrap", "product", False), ("wrap", "sqrt", True)],
)
def test_in_texture_space_the_image_decides(ball, key, image, told):
    given = {**TEXTURE, "preset": "robust", "irradiance_map.image": image, f"translucency.{key}": 0.25}
    assert idle(loaded(ball, given)) == ([f"translucency.{key}"] if told else [])


def test_what_a_layer_takes_over_counts(ball):
    """The layer's translucency lies on that of the scene, which itself has another form."""
    layers = [
        {"path": ball[0]["mesh"]["path"], "extinction_per_mm": [1.0, 1.0, 1.0], "translucency": {"form": "ratio"}}
    ]
    given = {"preset": "robust", "mm_per_unit": 4.0, "translucency.form": "gaussians", "translucency.x": 1.5}
    assert idle(loaded(ball, given)) == ["translucency.x"]
    assert idle(loaded(ball, {**given, "layers": layers})) == []
