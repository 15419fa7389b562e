"""What a pass computes on the way: there on demand, the same from both interpreters, and what the buffers come from."""

import numpy as np
import pytest
from scenes import LIGHT, around, sphere, written

from sss_ref.dump.read import read_dump
from sss_ref.errors import SceneError
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

LIGHTS = [{"position": LIGHT}, {"position": [-3.0, 0.5, 1.0], "color": [1.0, 0.5, 0.25]}]
MAP = [
    *("position_world", "normal_world", "uv"),
    *("shadow_uv", "shadow_valid", "stored_distance", "entry_point", "thickness", "directly_lit", "incident_light"),
]
SOFT_MAP = [*MAP[:-1], "light_visible", MAP[-1]]
CASES = {  # tables of the scene, and the registers it has
    "paper": ({"preset": "paper"}, []),
    "two lights": ({"preset": "robust", "lights": LIGHTS}, ["partial_lit_1", "partial_lit_2"]),
    "published": ({"preset": "published"}, ["exact_light_distance", "exact_lit", "exact_image"]),
    "texture space": (
        {"preset": "robust", "method": "texture_space"},
        [*(f"texel_{name}" for name in SOFT_MAP), "gloss"],
    ),
    "two lights in texture space": (
        {"method": "texture_space", "lights": LIGHTS},
        [
            *(f"texel_{name}" for name in MAP[:3]),
            *(f"texel_{name}_{number}" for number in (1, 2) for name in MAP[3:]),
            *("partial_irradiance_used_1", "partial_irradiance_used_2"),
        ],
    ),
    "published texture space": (
        {"preset": "published", "method": "texture_space"},
        [
            "exact_light_distance",
            *("texel_position_world", "texel_normal_world", "texel_uv", "texel_incident_light"),
            *("texel_exact_irradiance", "exact_image"),
        ],
    ),
}


@pytest.fixture(scope="module")
def with_registers(tmp_path_factory):
    """A scene of CASES, rendered with all buffers and registers."""
    path = written(tmp_path_factory.mktemp("bodies") / "sphere.obj", *sphere(10))
    kept = {}

    def rendered(case):
        if case not in kept:
            tables = {"irradiance_map": {"width": 32, "height": 32}, **CASES[case][0]}
            kept[case] = render(load_scene(around(path, 32, **tables)), "arrays", keep=["all", "registers"])
        return kept[case]

    return rendered


@pytest.mark.parametrize("case", CASES)
def test_registers_are_there_on_demand_and_change_nothing_else(with_registers, case):
    result = with_registers(case)
    buffers = list(result.scene.method.outputs)
    assert [name for name in result.buffers if name not in buffers] == CASES[case][1]
    alone = render(result.scene, "arrays")
    assert list(alone.buffers) == buffers
    assert alone.hashes == {name: result.hashes[name] for name in buffers}


@pytest.mark.parametrize("case", ["two lights in texture space", "published texture space"])
def test_kernels_give_the_same_registers(with_registers, case):
    result = with_registers(case)
    kernel = render(result.scene, keep="registers")
    assert kernel.hashes == {name: result.hashes[name] for name in CASES[case][1]}


def test_one_register_alone_needs_no_others(with_registers):
    result = with_registers("texture space")
    thickness = render(result.scene, "arrays", keep=["texel_thickness"])
    assert list(thickness.timings) == ["shadow_map", "irradiance_map"]
    assert thickness.hashes == {"texel_thickness": result.hashes["texel_thickness"]}


def test_the_buffers_are_made_of_them(with_registers):
    lights = with_registers("two lights")
    assert (lights["partial_lit_1"] + lights["partial_lit_2"]).tobytes() == lights["lit"].tobytes()
    assert not np.array_equal(lights["partial_lit_1"], lights["partial_lit_2"])
    published = with_registers("published")
    for name in ("light_distance", "lit", "image"):
        exact, one = published[f"exact_{name}"], np.float32(1)
        in_bytes = np.floor(np.clip(exact, 0, one) * np.float32(255) + np.float32(0.5)) / np.float32(255)
        assert in_bytes.tobytes() == published[name].tobytes()
        assert not np.array_equal(exact, published[name])


def test_where_nothing_is_drawn_they_hold_what_their_buffer_would(with_registers):
    result = with_registers("texture space")
    gutter = result["irradiance_mask"] == 0
    assert gutter.any() and not gutter.all()
    assert (result["texel_shadow_uv"][gutter] == -1).all() and (result["texel_thickness"][gutter] == 0).all()
    away = result["texel_position_world"] - np.array(LIGHT, np.float32)
    far = np.sqrt((away.astype(np.float64) ** 2).sum(axis=-1))[~gutter]
    known = result["texel_shadow_valid"][~gutter] != 0
    beyond = far - result["texel_stored_distance"][~gutter]
    assert np.allclose(np.abs(beyond[known]), result["texel_thickness"][~gutter][known], atol=1e-5) and known.any()


def test_names_that_are_neither_are_refused(with_registers):
    scene = with_registers("paper").scene
    assert not render(scene, "arrays", keep="registers").buffers  # it has none
    message = r'keep: expected "all", "final" or names of buffers \(.*image, taps, registers\), got \'texel_uv\''
    with pytest.raises(SceneError, match=message):
        render(scene, keep=["all", "texel_uv"])


def test_a_saved_result_with_registers_can_be_read_as_a_dump(with_registers, tmp_path):
    result = with_registers("published texture space")
    dump = read_dump(result.save(tmp_path / "out"), result.scene)
    assert list(dump.buffers) == list(result.buffers) and not dump.notes
    assert all(one.data.tobytes() == result[name].tobytes() for name, one in dump.buffers.items())
