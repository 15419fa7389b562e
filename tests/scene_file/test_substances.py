from typing import get_args

import numpy as np
import pytest
from filled_scenes import MATERIALS, are_filled_as_ever

import sss_ref
from sss_ref.errors import SceneError
from sss_ref.scene_file.kernels import HBH09
from sss_ref.scene_file.layers import filled
from sss_ref.scene_file.profiles import PROFILES, MaterialName
from sss_ref.scene_file.substances import SUBSTANCES, kernel_of, layer_of


def test_every_name_has_a_material_and_its_sum():
    assert set(get_args(MaterialName)) == set(SUBSTANCES) == set(PROFILES)


def test_materials_fill_in_as_ever(tmp_path):
    are_filled_as_ever(MATERIALS, tmp_path)


def test_a_material_lies_between_the_preset_and_the_file():
    data = filled({"preset": "robust", "material": "wax", "mm_per_unit": 30, "translucency": {"scale": 2.0}})
    wax = SUBSTANCES["wax"]
    assert data["mesh"] == {"color": wax.color}
    assert data["phong"] == {"specular": 0.25, "shininess": 20.0}
    wanted = {
        "form": "gaussians",
        "gaussians": "wax",
        "scale": 2.0,
        "combine": filled({"preset": "robust"})["translucency"]["combine"],
    }
    assert {key: data["translucency"][key] for key in wanted} == wanted
    assert (data["blur"]["unit"], data["blur"]["mm_per_offset"], data["blur"]["follow_surface"]) == ("mm", 1.6, True)
    own = filled({"material": "wax", "mesh": {"color": [0, 0, 1]}, "translucency": {"form": "beer"}})
    assert own["mesh"]["color"] == [0, 0, 1] and own["translucency"]["form"] == "beer"


@pytest.mark.parametrize("name", SUBSTANCES)
def test_what_comes_through_has_the_color_once(name):
    """In the sum of a medium it is already; skin's sum lets all light leave, and the mesh colours it."""
    filling = layer_of(name, in_mm=True)
    expected = (1.0, 1.0, 1.0) if name != "skin" else filling["mesh"]["color"]
    colored = np.multiply(filling["mesh"]["color"], filling["translucency"]["scale"])
    assert colored == pytest.approx(expected, rel=1e-3)


def test_a_blur_in_pixels_stays_one():
    assert "unit" not in layer_of("wax", in_mm=False)["blur"]
    assert filled({"material": "wax", "mm_per_unit": 1})["blur"]["unit"] == "mm"
    assert "unit" not in filled({"material": "wax", "mm_per_unit": 1, "blur": {"pixel_scale": 2}})["blur"]


@pytest.mark.parametrize("name", [None, "water", 7, ["wax"]])
def test_what_is_no_material_fills_nothing(name):
    assert layer_of(name, in_mm=True) == {}


def test_kernels_lie_between_red_and_blue():
    red, blue = ([row[column] for row in HBH09] for column in (2, 4))
    rows = kernel_of((1.0, 0.0, 0.5))
    assert [row[:2] for row in rows] == [row[:2] for row in HBH09]
    assert [row[2] for row in rows] == red and [row[3] for row in rows] == blue
    assert [row[4] for row in rows] == [0.5 * r + 0.5 * b for r, b in zip(red, blue, strict=True)]
    assert filled({"material": "skin", "mm_per_unit": 1})["blur"]["kernel"] == "hbh09"


@pytest.mark.parametrize("name", SUBSTANCES)
def test_a_kernel_takes_light_as_far_as_the_material(name):
    """The widest channel has hbh09's red, whose taps are 2.14 offsets away on average."""
    widest = (SUBSTANCES[name].spread or (1.0,)).index(1.0)
    distance = np.average([np.hypot(*row[:2]) for row in HBH09], weights=[row[2] for row in HBH09])
    assert distance == pytest.approx(2.14, abs=0.001)
    measured = {"skin": 2.57, "marble": 3.02, "milk": 2.64, "wax": 3.43, "jade": 2.91, "enamel": 3.49, "dentine": 2.69}
    assert SUBSTANCES[name].mm_per_offset * distance == pytest.approx(measured[name], abs=0.02) and widest in (0, 1)


@pytest.mark.parametrize(
    ("chosen", "message"),
    [
        (
            {"material": "water"},
            'material: expected "skin", "marble", "milk", "wax", "jade", "enamel" or "dentine", got',
        ),
        ({"material": "wax", "preset": "published"}, 'material: expected nothing with preset "published", got "wax";'),
    ],
)
def test_materials_that_cannot_be(small, chosen, message):
    with pytest.raises(SceneError) as error:
        sss_ref.load_scene(small, **{"mm_per_unit": 1.0, **chosen})
    assert str(error.value).startswith(f"override: {message}") and "\n" not in str(error.value)


def test_a_material_needs_a_unit(small):
    with pytest.raises(SceneError, match=r"^override: material: expected mm_per_unit beside it, since light comes "):
        sss_ref.load_scene(small, material="wax")
    assert sss_ref.load_scene(small, material="wax", mm_per_unit=2.0).settings.translucency.gaussians == "wax"


def test_a_layer_has_a_material_of_its_own_above_what_the_scene_has():
    layers = [{"material": "dentine"}, {"material": "dentine", "color": [1, 1, 1]}, {}, "no table"]
    phong = {"ambient": 0.25, "specular": 0.75}
    data = filled({"material": "enamel", "mm_per_unit": 1, "layers": layers, "phong": phong})
    dentine, white, plain, wrong = data["layers"]
    enamel, own = SUBSTANCES["enamel"], SUBSTANCES["dentine"]
    assert dentine["color"] == own.color and white["color"] == [1, 1, 1] and "color" not in plain
    assert dentine["phong"] == {"ambient": 0.25, "specular": own.specular, "shininess": own.shininess}
    assert plain["phong"] == {"ambient": 0.25, "specular": 0.75, "shininess": enamel.shininess}
    assert [each["translucency"]["gaussians"] for each in (dentine, white, plain)] == ["dentine", "dentine", "enamel"]
    assert data["blur"]["mm_per_offset"] == enamel.mm_per_offset and wrong == "no table"


def test_a_layer_of_a_material_needs_a_unit(small):
    layer = {"path": "tetrahedron", "extinction_per_mm": [1, 1, 1], "material": "dentine"}
    with pytest.raises(SceneError, match=r"layers\[0\].material: expected mm_per_unit beside it"):
        sss_ref.load_scene({**small, "layers": [layer]})
