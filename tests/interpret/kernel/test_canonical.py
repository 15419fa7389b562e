"""Passes that differ in a light's number alone are one module; the bits of several lights are in methods/."""

import pytest
from scenes import LIGHT, around, sphere, written

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel.canonical import canonical_names, canonical_work, renamed
from sss_ref.interpret.kernel.source import fragment_source, vertex_source
from sss_ref.language.pipeline import Pass, ScreenDraw
from sss_ref.passes.light_sum import plus
from sss_ref.passes.shadow_map import distance_to_light
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

LIGHTS = [{"position": LIGHT}, {"position": [-3.0, 0.5, 1.0]}, {"position": [0.0, 3.5, -1.0], "intensity": 0.5}]
OF_A_LIGHT = {"shadow_map", "irradiance_fill", "irradiance_blur"}


@pytest.fixture
def works(tmp_path, monkeypatch):
    """The works of a small rendering in texture space, for a number of lights."""
    path = written(tmp_path / "sphere.obj", *sphere(6))
    run, seen = arrays.run_fragments, []
    monkeypatch.setattr(arrays, "run_fragments", lambda work, pool: seen.append(work) or run(work, pool))
    tables = {"method": "texture_space", "preset": "robust", "irradiance_map": {"width": 32, "height": 32, "dilate": 1}}

    def rendered(count):
        seen.clear()
        render(load_scene(around(path, size=16, lights=LIGHTS[:count], **tables)), interpreter="arrays")
        return list(seen)

    return rendered


def modules(works):
    """Pass -> the source of its fragments, without numbers."""
    canonical = [canonical_work(work) for work in works]
    written = {
        (w.this_pass.name, fragment_source(w.this_pass, w.buffers, w.outputs, w.fragments.varyings)) for w in canonical
    }
    assert len(dict(written)) == len(written)
    return dict(written)


def numbered(one, suffix):
    return renamed(one, lambda name: name + suffix)


def test_further_lights_add_no_module_but_to_what_sums_them(works):
    one, three = works(1), works(3)
    assert (len(one), len(three)) == (5, 11)
    assert set(modules(three)) == set(modules(one)) == OF_A_LIGHT | {"irradiance_map", "camera"}
    assert {name for name, source in modules(three).items() if source == modules(one)[name]} == OF_A_LIGHT


def test_the_vertex_stage_of_every_light_is_one_module(works):
    shadow_maps = [work.this_pass for work in works(3) if work.this_pass.name.startswith("shadow_map")]
    varyings = {"fragment_position": 0}
    assert len({vertex_source(one, varyings) for one in shadow_maps}) == 3
    assert len({vertex_source(renamed(one, canonical_names(one)), varyings) for one in shadow_maps}) == 1


def test_each_canonical_name_stands_for_the_array_of_its_own_light(works):
    by_pass = {work.this_pass.name: work for work in works(3)}
    work = by_pass["shadow_map_2"]
    canonical = canonical_work(work)
    assert canonical.uniforms["light_position"] is work.uniforms["light_position_2"]
    assert canonical.outputs["light_distance"] is work.outputs["light_distance_2"]
    assert canonical.backgrounds["light_distance"] is work.backgrounds["light_distance_2"]
    work = by_pass["irradiance_blur_3"]
    assert canonical_work(work).buffers["irradiance_filled"] is work.buffers["irradiance_filled_3"]


def test_one_light_keeps_its_names(works):
    for work in works(1):
        assert canonical_work(work).this_pass == work.this_pass


@pytest.mark.parametrize(
    "stage",
    [
        plus.bound(first="lit_1", second="lit_2", total="lit_3"),
        plus.bound(first="lit", second="lit_1", total="sum_1"),
    ],
)
def test_names_that_would_not_stay_distinct_are_kept(stage):
    one = Pass("sum", "camera", ScreenDraw(), (stage,))
    assert renamed(one, canonical_names(one)) == one


def test_a_longer_number_that_ends_alike_is_another():
    one = Pass("shadow_map", "shadow_map", ScreenDraw(), (distance_to_light,))
    ends = [canonical_names(numbered(one, suffix))("light_distance_11") for suffix in ("_1", "_11")]
    assert ends == ["light_distance_11", "light_distance"]
