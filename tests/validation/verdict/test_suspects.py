"""Who may be wrong where results are missing: the stages that nobody has seen, and no others."""

import pytest
from scenes import LIGHT, around, settings_with, sphere, written

from sss_ref.rendering.fold import render
from sss_ref.scene.catalogue import method_of
from sss_ref.scene.load import load_scene
from sss_ref.validation.report.report_data import as_json
from sss_ref.validation.stage_by_stage import validate
from sss_ref.validation.verdict.suspects import suspects

TWO_LIGHTS = [{"position": LIGHT}, {"position": [-3.0, 0.5, 1.0]}]
VERTEX, RASTERIZER = "camera/mesh_vertex", "camera/rasterizer"
HARD = {"shadow_map": {"test": "slope"}}  # preset robust has soft shadows
WHERE_UNLIT = {"translucency.combine": "transmit"}  # T depends on whether a point is lit


def suspects_of(place, dumped, **tables):
    pass_name, buffer = place.split("/")
    method = method_of(settings_with({"preset": "robust", **HARD, **tables}))
    return list(suspects(method, pass_name, buffer, {buffer, *dumped}))


def test_a_stage_that_was_given_all_it_reads_is_the_only_one():
    given = ["thickness", "directly_lit", "shadow_uv"]
    assert suspects_of("camera/translucency", given, **WHERE_UNLIT) == ["camera/translucency_ratio"]
    below = ["thickness", "inside_shadow_uv"]
    assert suspects_of("camera/translucency", below) == ["camera/translucency_ratio_throughout"]
    assert suspects_of("composite/image", ["scattered", "coverage"]) == ["composite/over_background"]


def test_a_stage_before_it_whose_result_is_missing_is_another():
    given = ["thickness", "shadow_uv", "stored_distance", "position_world", "normal_world"]
    found = ["camera/directly_lit_slope", "camera/translucency_ratio"]
    assert suspects_of("camera/translucency", given, **WHERE_UNLIT) == found
    given.remove("stored_distance")  # which also needs the shadow map
    further = ["shadow_map/mesh_vertex", "shadow_map/rasterizer", "shadow_map/distance_to_light"]
    lookup = "camera/shadow_lookup_nearest"
    assert suspects_of("camera/translucency", given, **WHERE_UNLIT) == [*further, lookup, *found]
    mapped = [*given, "light_distance", "light_triangle"]
    assert suspects_of("camera/translucency", mapped, **WHERE_UNLIT) == [lookup, *found]


def test_varyings_are_the_vertex_stages_where_the_rasterizer_puts_them():
    assert suspects_of("camera/position_world", []) == [VERTEX, RASTERIZER, "camera/surface"]
    assert suspects_of("camera/position_world", ["triangle"]) == [VERTEX, "camera/surface"]
    assert suspects_of("camera/triangle", ["depth", "coverage"]) == [VERTEX, RASTERIZER]


def test_a_stencil_says_where_a_stage_runs():
    assert suspects_of("blur/scattered", ["lit"], **{"blur.mask": "output"}) == [VERTEX, RASTERIZER, "blur/scatter"]
    assert suspects_of("blur/scattered", ["lit"], **{"blur.mask": "none"}) == ["blur/scatter"]


def test_a_stage_that_runs_for_every_light_is_named_once_and_last():
    assert suspects_of("camera/phong", ["phong_1", "phong_2"], lights=TWO_LIGHTS) == ["camera/plus"]
    three = [*TWO_LIGHTS, {"position": [0.0, 3.0, 1.0]}]
    given = ["partial_lit_1", "partial_lit_2", "partial_lit_3"]
    assert suspects_of("camera/lit", given, lights=three) == ["camera/plus"]
    assert suspects_of("camera/lit", given[1:], lights=three)[-2:] == ["camera/lit_transmit_wrapped", "camera/plus"]


def test_the_image_alone_leaves_all_in_doubt():
    found = suspects_of("composite/image", [])
    stages = [
        f"{one.name}/{stage.name}"
        for one in method_of(settings_with({"preset": "robust", **HARD})).passes
        for stage in one.stages
        if not one.on_demand
    ]
    once_and_last = list(dict.fromkeys(reversed(stages)))[::-1]  # the shadow map is looked up twice
    assert [name for name in found if name in stages] == once_and_last
    assert set(found) - set(stages) == {VERTEX, RASTERIZER, "shadow_map/mesh_vertex", "shadow_map/rasterizer"}


FAULTS = {  # what no buffer shows: (tables, what is changed, where)
    "bias on the map": (
        {"method": "texture_space"},
        {"shadow_map.bias_slope": 0.0},
        "irradiance_map/directly_lit_slope",
    ),
    "inset on the map": (
        {"method": "texture_space"},
        {"shadow_map.lookup_inset": 0.9},
        "irradiance_map/shadow_lookup_nearest",
    ),
    "light on the map": ({"method": "texture_space"}, {"lights.0.intensity": 1.1}, "irradiance_map/light_constant"),
    "one of two lights": ({"lights": TWO_LIGHTS}, {"translucency.scale": 0.0525}, "camera/lit_transmit_wrapped"),
    "before a byte": ({"preset": "published", "shadow_map": {}}, {"translucency.scale": 0.5}, "camera/lit_add"),
    "before a byte of the image": (
        {"preset": "published", "method": "texture_space", "shadow_map": {}},
        {"translucency.scale": 0.5},
        "camera/image_sqrt_add",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_registers_make_a_candidate_certain(fault, tmp_path):
    tables, changes, place = FAULTS[fault]
    path = written(tmp_path / "sphere.obj", *sphere(12))
    data = {
        "preset": "robust",
        "shadow_map": {"width": 64, "height": 64, **HARD["shadow_map"]},
        "irradiance_map": {"width": 64, "height": 64},
        **tables,
    }
    right, wrong = (load_scene(around(path, 64, **data), **each) for each in ({}, changes))
    dumped = render(wrong, interpreter="arrays", keep=["all", "registers"]).buffers
    oracle = render(right, interpreter="arrays")
    certain = validate(oracle, dumped, explain=False)
    assert certain.culprit.suspects == (place,)
    assert certain.summary.startswith("fail: stage {1} of pass {0} is the first".format(*place.split("/")))
    buffers = {name: dumped[name] for name in oracle.buffers}
    doubtful = validate(oracle, buffers, explain=False)
    blamed = doubtful.culprit
    *before, last = blamed.suspects
    assert place in before and last == f"{blamed.pass_name}/{blamed.stage}"
    assert f"of pass {blamed.pass_name}, or one before it whose output was not given (" in doubtful.summary
    assert place in doubtful.summary and doubtful.summary.count("/") <= 6
    assert place in {name for one in as_json(doubtful)["buffers"] for name in one["suspects"]}
    assert not [one for one in doubtful.verdicts if one.passed and one.suspects]
    alone = validate(oracle, {"image": dumped["image"]}, explain=False)
    assert f"was not given ({len(alone.culprit.suspects) - 7} more, " in alone.summary
    assert {place, *before} < set(alone.culprit.suspects)
