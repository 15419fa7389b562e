"""A stage of one's own: every interpreter runs it, in its place and under its names."""

import importlib.util
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from scenes import LIGHT, around, sphere, written

import sss_ref
from sss_ref.dump.read import read_dump
from sss_ref.errors import DumpError, SceneError
from sss_ref.interpret.shader import array_lengths, stage_source
from sss_ref.language import dot, ivec2, max, normalize, stage, vec3
from sss_ref.language.types import components
from sss_ref.results.verify import verify

EXAMPLE = Path(__file__).parents[2] / "examples" / "beer_lambert.py"
LIGHTS = [{"position": LIGHT}, {"position": [-3.0, 0.5, 1.0], "color": [1.0, 0.5, 0.25]}]

TRANSMIT = {"preset": "robust", "translucency": {"combine": "transmit"}, "shadow_map": {"test": "slope"}}


@pytest.fixture(scope="module")
def example():
    spec = importlib.util.spec_from_file_location("beer_lambert", EXAMPLE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def body(tmp_path_factory):
    return written(tmp_path_factory.mktemp("bodies") / "sphere.obj", *sphere(10))


def own_scene(example, path, **tables):
    scene = sss_ref.load_scene(around(path, 40, **TRANSMIT, **tables))
    return sss_ref.with_stage(scene, "lit_transmit", example.lit_absorbed, extinction=(0.5, 1.0, 4.0))


def test_the_example_is_short():
    assert len(EXAMPLE.read_text().splitlines()) < 40


def test_the_example_computes_what_it_says(example, body):
    result = sss_ref.render(own_scene(example, body), interpreter="arrays")
    covered = result["coverage"] != 0
    expected = np.exp(-np.array([0.5, 1.0, 4.0]) * result["thickness"][covered][:, None].astype(np.float64))
    assert np.allclose(result["transmittance"][covered], expected, rtol=1e-6)
    assert not result["transmittance"][~covered].any()
    shaded = covered & (result["directly_lit"] == 0) & (result["thickness"] > 0.5)
    red, _, blue = (result["lit"][shaded] / result["albedo"][shaded]).T
    assert (red > blue).all() and shaded.any()


@pytest.mark.parametrize("tables", [{}, {"lights": LIGHTS}], ids=["one light", "two lights"])
def test_array_code_kernel_and_trace_give_one_result(example, body, tables):
    scene = own_scene(example, body, **tables)
    result = sss_ref.render(scene)
    assert result.hashes == sss_ref.render(scene, interpreter="arrays").hashes
    names = ["transmittance"] if not tables else ["transmittance_1", "transmittance_2"]
    assert set(names) < set(result.buffers)
    told = sss_ref.explain(result, (20, 20))
    writes = {name: value for one in told.passes for traced in one.stages for name, value in traced.writes.items()}
    for name in [*names, "lit", "image"]:
        assert np.array(components(writes[name])).tobytes() == result[name][20, 20].tobytes()


def test_glsl_comes_from_the_same_source(example, body):
    scene = own_scene(example, body)
    text = stage_source(example.lit_absorbed, array_lengths({}))
    assert "vec3 transmittance = exp(-extinction * thickness);" in text
    stages = [each.name for one in scene.method.passes for each in one.stages]
    assert "lit_absorbed" in stages and "lit_transmit" not in stages


class Irradiance(NamedTuple):
    """Light that arrives."""

    irradiance: vec3


@stage(source="wrapped diffuse")
def irradiance_wrapped(
    position_world: vec3, normal_world: vec3, light_position: vec3, incident_light: vec3, wrap: float
) -> Irradiance:
    """e * max((N.L + wrap) / (1 + wrap), 0)."""
    facing = dot(normal_world, normalize(light_position - position_world))
    return Irradiance(incident_light * max((facing + wrap) / (wrap + 1.0), 0.0))


def test_in_the_irradiance_map_it_reads_the_texels_own_values(tmp_path):
    positions, triangles, uvs = sphere(10)
    path = written(tmp_path / "sphere.obj", positions, triangles, uvs)
    tables = {"method": "texture_space", "irradiance_map": {"width": 40, "height": 40}, "lights": LIGHTS}
    scene = sss_ref.load_scene(around(path, 40, preset="robust", **tables))
    scene = sss_ref.with_stage(scene, "irradiance_lambert_soft", irradiance_wrapped, wrap=0.5)
    result = sss_ref.render(scene)
    assert result.hashes == sss_ref.render(scene, interpreter="arrays").hashes
    for number, color in ((1, 1.0), (2, 0.25)):
        light = result[f"irradiance_{number}"]
        drawn = result["irradiance_mask"] != 0
        assert 0.9 * color < light[drawn][:, 2].max() <= color and light[drawn].min() == 0


def test_what_it_writes_can_be_dumped_and_judged(example, body, tmp_path):
    scene = own_scene(example, body)
    result = sss_ref.render(scene, interpreter="arrays")
    dump = read_dump(result.save(tmp_path / "out"), scene)
    assert list(dump.buffers) == list(result.buffers) and not dump.notes
    buffers = {name: one.data for name, one in dump.buffers.items()}
    assert sss_ref.validate(result, buffers).passed
    other = sss_ref.with_stage(
        sss_ref.load_scene(around(body, 40, **TRANSMIT)),
        "lit_transmit",
        example.lit_absorbed,
        extinction=(0.5, 1.0, 4.1),
    )
    wrong = sss_ref.render(other, interpreter="arrays")
    found = sss_ref.validate(result, dict(wrong.buffers), explain=False)
    assert found.culprit.suspects == ("camera/lit_absorbed",) and found.culprit.buffer in ("lit", "transmittance")


class LitAndPlace(NamedTuple):
    """What no buffer holds."""

    lit: vec3
    place: ivec2


@stage(source="test")
def no_lit(phong: vec3) -> Irradiance:
    """Writes something else."""
    return Irradiance(phong)


@stage(source="test")
def place_too(phong: vec3, pixel: ivec2) -> LitAndPlace:
    """Writes its place too."""
    return LitAndPlace(phong, pixel)


def test_what_does_not_fit_is_told(example, body):
    scene = sss_ref.load_scene(around(body, 40, **TRANSMIT))
    for name, own, message in (
        (
            "lit",
            example.lit_absorbed,
            r"with_stage: expected a stage of the scene \(distance_to_light, .*\), got 'lit'",
        ),
        ("lit_transmit", no_lit, "expected no_lit to write lit as vec3, as lit_transmit does, got none; add it"),
        ("lit_transmit", example.lit_absorbed, "lit_absorbed reads to be there before it, got no extinction; give it"),
        ("lit_transmit", place_too, "expected place_too to write place as float, vec2, vec3, int or bool, got ivec2"),
    ):
        with pytest.raises(SceneError, match=message):
            sss_ref.with_stage(scene, name, own)


def test_a_result_of_own_stages_is_not_verified_as_ours(example, body, tmp_path):
    folder = sss_ref.render(own_scene(example, body), interpreter="arrays").save(tmp_path / "out")
    with pytest.raises(DumpError, match="expected our stages, got others for lit_transmit; render with them again"):
        verify(folder)
