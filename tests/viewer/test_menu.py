"""Every key of the scene file has a control that suits it, and a new key would have one too."""

from typing import Annotated

import pytest

from sss_ref.scene_file import quantities
from sss_ref.scene_file.kernels import KERNELS
from sss_ref.scene_file.reading import TABLES
from sss_ref.scene_file.shipped import mesh_names
from sss_ref.viewer import menu
from sss_ref.viewer.menu import control

CONTROLS = {(tuple(table["path"]), each["key"]): each for table in menu.menu() for each in table["controls"]}


def test_every_key_has_a_control_and_an_explanation():
    tables = {path[: number + 1] for path in TABLES for number in range(len(path))}
    for path, model in TABLES.items():
        for key in model.model_fields:
            assert ((path, key) in CONTROLS) != ((*path, key) in tables), (path, key)
    assert all(each["help"] or each["key"] == "type" for each in CONTROLS.values())


@pytest.mark.parametrize(
    ("path", "key", "expected"),
    [
        (("shadow_map",), "filter", {"kind": "choice", "choices": ["nearest", "bilinear"]}),
        ((), "material", {"kind": "choice", "optional": True}),
        (("mesh",), "path", {"kind": "mesh", "choices": mesh_names()}),
        (("mesh",), "color", {"kind": "color", "names": ["material"]}),
        (("lights", "point"), "position", {"kind": "vector", "optional": True}),
        (("lights", "point"), "intensity", {"kind": "number", "range": (0, None), "whole": False}),
        (("lights", "point"), "type", {"kind": "choice", "choices": ["point", "directional"]}),
        (("camera", "free"), "type", {"choices": ["orbit", "look_at", "free", "orthographic"]}),
        (("translucency",), "x", {"kind": "channels", "range": (0, None)}),
        (("translucency",), "wrap", {"kind": "number", "range": (0, 1)}),
        (("shadow_map",), "bias_slope", {"kind": "number", "range": (0, None)}),
        (("blur",), "kernel", {"kind": "choice", "choices": [*KERNELS]}),
        (("output",), "exposure", {"kind": "number", "range": (-20, 20)}),
        (("camera", "orbit"), "width", {"kind": "number", "range": (1, 16384), "whole": True}),
    ],
)
def test_a_key_has_the_control_of_its_type(path, key, expected):
    found = CONTROLS[path, key]
    assert {name: found.get(name) for name in expected} == expected


def test_a_new_type_of_key_is_typed_as_it_is():
    free = {"kind": "number", "range": (None, None)}
    assert control(("mesh",), "new", Annotated[float, "of a kind unknown here"]) == free | {"whole": False}
    assert control(("mesh",), "new", Annotated[Annotated[int, 1], 2]) == free | {"whole": True}
    assert control(("mesh",), "new", dict[str, float]) == {"kind": "value"}
    assert control(("mesh",), "new", quantities.Share | None) == {
        "kind": "number",
        "range": (0, 1),
        "whole": False,
        "optional": True,
    }


SLIDERS = {  # a key of each type of number -> its range, and whether it is whole
    ("camera", "free", "yaw"): ((None, None), False),
    ("phong", "ambient"): ((0, None), False),
    ("phong", "shininess"): ((0, None), False),
    ("mesh", "normal_strength"): ((0, 1000), False),
    ("shadow_map", "kernel_scale"): ((0, 16384), False),
    ("shadow_map", "lookup_inset"): ((0, 1), False),
    ("camera", "orbit", "fov_y"): ((0, 180), False),
    ("output", "exposure"): ((-20, 20), False),
    ("shadow_map", "width"): ((1, 16384), True),
    ("irradiance_map", "dilate"): ((0, 16384), True),
    ("diffusion", "samples"): ((1, 255), True),
    ("diffusion", "taps"): ((3, 255), True),
}


@pytest.mark.parametrize("place", SLIDERS, ids=".".join)
def test_a_slider_has_the_range_that_a_key_may_have(place):
    found = CONTROLS[place[:-1], place[-1]]
    assert (found["kind"], (found["range"], found["whole"])) == ("number", SLIDERS[place])


def test_keys_of_several_numbers_have_a_control_for_all_of_them():
    kinds = {
        ("mesh", "scale"): "vector",
        ("lights", "point", "up"): "vector",
        ("diffusion", "albedo"): "vector",
        ("diffusion", "mean_free_path_mm"): "vector",
        ("lights", "point", "color"): "color",
        ("mesh", "unwrap"): "switch",
    }
    assert {place: CONTROLS[place[:-1], place[-1]]["kind"] for place in kinds} == kinds
    assert CONTROLS[("translucency",), "d_min"]["range"] == (0, None)
