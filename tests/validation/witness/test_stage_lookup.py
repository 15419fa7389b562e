"""The stage of a witness is found again however its scene made it; its hash is of what it computes."""

from dataclasses import replace

import pytest
from scenes import settings_with

from sss_ref.methods.parallel_views import with_parallel_rays
from sss_ref.passes.phong import phong_shading
from sss_ref.passes.translucency import translucency_ratio
from sss_ref.scene.catalogue import method_of
from sss_ref.validation.witness.situation import unbound
from sss_ref.validation.witness.stage_lookup import StageTold, source_hash

ORTHOGRAPHIC = {"type": "orthographic", "eye": [0.0, 0.0, 5.0], "target": [0.0, 0.0, 0.0], "view_height": 3.0}
CHANGES = (
    {},
    {"lights.0.type": "directional", "camera": ORTHOGRAPHIC},
    {"translucency.x": [2.0, 1.5, 1.0], "translucency.scale": [0.2, 0.3, 0.4]},
    {"method": "burley"},
)


def test_stages_are_found_again():
    """Those for parallel rays, and those by channel, too."""
    methods = [with_parallel_rays(method_of(one), one) for one in map(settings_with, CHANGES)]
    stages = {key_of(stage): stage for method in methods for one in method.passes for stage in one.stages}
    told = [StageTold.of(stage) for stage in stages.values()]
    assert {rays for each in told for rays in each.rays} == {"_directional", "_orthographic"}
    assert any(each.kinds for each in told)
    for each in told:
        found = each.found({})
        assert found and source_hash(found) == each.source, each


def key_of(stage):
    """What two bindings of one stage have in common."""
    return stage.name, str(stage.outputs), str(stage.parameters)


def test_a_name_that_is_not_there():
    assert replace(StageTold.of(phong_shading), name="nobody").found({}) is None
    assert replace(StageTold.of(phong_shading), kinds={"no_input": "vec3"}).found({}) is None
    assert StageTold.of(phong_shading).found({"phong_shading": translucency_ratio}) is not None


def test_the_hash_is_of_what_is_computed():
    other = replace(phong_shading, body=translucency_ratio.body, outputs=translucency_ratio.outputs)
    assert source_hash(phong_shading) != source_hash(replace(other, writes=translucency_ratio.writes))
    assert source_hash(phong_shading) == source_hash(unbound(phong_shading.bound(albedo="other_albedo")))
    assert source_hash(phong_shading) == source_hash(replace(phong_shading, source="another book"))
    assert len(source_hash(phong_shading)) == 16 and source_hash(phong_shading) != source_hash(translucency_ratio)


@pytest.mark.parametrize("kinds", [{"albedo": "mat3"}, {"albedo": "mat9"}])
def test_types_that_it_cannot_have(kinds):
    assert replace(StageTold.of(phong_shading), kinds=kinds).found({}) is None
