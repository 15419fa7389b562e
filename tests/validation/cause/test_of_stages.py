"""What may be wrong with a stage's inputs: each is tried with its own arrays, worked out by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.language.types import Array, Texture, mat3, vec3
from sss_ref.passes.blur import scatter
from sss_ref.passes.translucency import translucency_exponent, translucency_ratio
from sss_ref.scene_file.kernels import KERNELS
from sss_ref.validation.cause import of_stages
from sss_ref.validation.cause.hypothesis import INPUT, SOURCE

OFFSET = np.float32([[1, 2], [3, -4], [0, 5]])
WEIGHT = np.float32([[1, 2, 3], [4, 5, 6], [3, 1, 1]])


class Tried:
    """A sample that keeps what it is tried with: its fit is the inputs that were others, and the stage."""

    at = (np.array([0, 1]), np.array([1, 0]))

    def __init__(self, given, stage=None, kinds=None):
        """given: own name -> value. kinds: own name -> type."""
        self.given = given
        reads = {own: f"its_{own}" for own in given}
        self.stage = stage or SimpleNamespace(reads=reads, parameters=kinds or dict.fromkeys(given, float))
        self.own_name = "translucency"

    def with_inputs(self, changed, stage=None):
        return changed, stage

    def fit(self, values):
        return values


def told(tried):
    """In words -> the charge, and the inputs that are others."""
    return {charge.text: (charge, changed) for charge, (changed, _) in tried}


def kernels():
    return told(of_stages._kernels(Tried({"tap_offset": Array(OFFSET), "tap_weight": Array(WEIGHT)})))


TURNED = {
    "x and y of the taps are swapped": {"tap_offset": [[2, 1], [-4, 3], [5, 0]]},
    "the taps are mirrored in x": {"tap_offset": [[-1, 2], [-3, -4], [0, 5]]},
    "the taps are mirrored in y": {"tap_offset": [[1, -2], [3, 4], [0, -5]]},
    "the taps are mirrored in x and y": {"tap_offset": [[-1, -2], [-3, 4], [0, -5]]},
    "the weights' red and blue are swapped": {"tap_weight": [[3, 2, 1], [6, 5, 4], [1, 1, 3]]},
    "the weights belong to the taps in reverse order": {"tap_weight": [[3, 1, 1], [4, 5, 6], [1, 2, 3]]},
    "the weights are divided by their sum": {"tap_weight": WEIGHT / np.float32([8, 8, 10])},
}


@pytest.mark.parametrize("text", TURNED)
def test_a_kernel_is_turned_round(text):
    charge, changed = kernels()[text]
    assert {name: array.data.tolist() for name, array in changed.items()} == {
        name: np.float32(values).tolist() for name, values in TURNED[text].items()
    }
    assert charge.blames == INPUT and charge.names == tuple(f"its_{name}" for name in changed)
    assert all(array.data.flags.c_contiguous and array.data.dtype == np.float32 for array in changed.values())


@pytest.mark.parametrize("name", KERNELS)
def test_a_kernel_is_one_of_ours(name):
    _, changed = kernels()[f"the kernel is {name}"]
    assert changed["tap_offset"].data.shape[1] == 2 and changed["tap_weight"].data.shape[1] == 3
    together = np.hstack([changed["tap_offset"].data, changed["tap_weight"].data])
    assert np.array_equal(together, np.array(KERNELS[name], np.float32))
    assert len(kernels()) == len(TURNED) + len(KERNELS)


def test_a_stage_without_a_kernel_has_none_to_turn():
    assert not kernels_of({"x": np.float32(1)}) and not kernels_of({"tap_offset": np.float32(1)})


def kernels_of(given):
    return [*of_stages._kernels(Tried(given))]


def case(uniforms=None, oracle=None, dumped=None):
    scene = SimpleNamespace(uniforms=uniforms or {})
    return SimpleNamespace(
        oracle=SimpleNamespace(scene=scene, buffers=oracle or {}), drawing=SimpleNamespace(buffers=dumped or {})
    )


def test_the_textures_of_another_light():
    first, second, third = (np.full((2, 2), number, np.float32) for number in (1, 2, 3))
    there = {"light_distance_1": first, "light_distance_2": second, "light_uv_2": third, "triangle": first}
    sample = Tried({"map": Texture(first), "other": Texture(first), "x": np.float32(1)})
    sample.stage.reads.update({"map": "light_distance_1", "other": "light_uv_1"})
    found = told(of_stages.other_buffers(sample, case(oracle=there, dumped={"light_uv_2": second})))
    text = "it reads light_distance_2 for light_distance_1 and light_uv_2 for light_uv_1"
    assert [*found] == [text]
    charge, changed = found[text]
    assert charge.names == ("light_distance_1", "light_uv_1") and charge.blames == INPUT
    assert changed["map"].data is second and changed["other"].data is second


def test_matrices_and_the_positions_of_other_lights():
    uniforms = {
        "normal_matrix": np.float32(np.arange(9).reshape(3, 3)),
        "world_from_model": np.eye(4, dtype=np.float32),
        "light_position_1": np.float32([1, 2, 3]),
        "light_position_2": np.float32([4, 5, 6]),
    }
    given = {"matrix": mat3(uniforms["normal_matrix"]), "at": vec3(*uniforms["light_position_1"]), "x": np.float32(1)}
    sample = Tried(given, kinds={"matrix": mat3, "at": vec3, "x": float})
    sample.stage.reads.update({"matrix": "normal_matrix", "at": "light_position_1"})
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(of_stages, "lengthened", lambda sample, own, name: [(f"longer {own} {name}", None)])
        tried = [*of_stages.other_uniforms(sample, case(uniforms))]
    assert tried[-1] == ("longer at light_position_1", None)
    found = told(tried[:-1])
    assert np.array_equal(found["normal_matrix is transposed"][1]["matrix"].rows, uniforms["normal_matrix"].T)
    assert [*found["light_position_1 is light_position_2"][1]["at"]] == [4, 5, 6]
    assert not any("light_position_1 is light_position_1" in text or text.startswith("its_x") for text in found)


def test_values_of_the_same_type_and_unit():
    """A point for another point; no normal, no number, nothing that was not there, and not itself."""
    points = ("position_world", "entry_point", "seen_nowhere")
    units = {name: SimpleNamespace(unit="world space") for name in points}
    units |= {"normal_world": SimpleNamespace(unit="unit vector"), "thickness": SimpleNamespace(unit="world space")}
    there = {name: np.arange(12, dtype=np.float32).reshape(2, 2, 3) for name in ("normal_world", *points[:2])}
    there["thickness"] = np.zeros((2, 2), np.float32)
    outputs = dict.fromkeys((*points, "normal_world"), vec3) | {"thickness": float}
    drawn = SimpleNamespace(this_pass=SimpleNamespace(outputs=outputs))
    sample = Tried({"p": vec3(*np.float32([1, 2, 3])), "q": np.float32(1)}, kinds={"p": vec3, "q": float})
    sample.stage.reads["p"] = "position_world"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(of_stages, "BUFFERS", units)
        found = told(of_stages._other_values(sample, SimpleNamespace(case=case(oracle=there), drawn=drawn)))
    assert [*found] == ["it reads entry_point for position_world"]
    ((charge, changed),) = found.values()
    assert (charge.blames, charge.names) == (SOURCE, ("position_world",))
    assert [part.tolist() for part in changed["p"]] == [[3, 6], [4, 7], [5, 8]]  # pixels (0, 1) and (1, 0)


def test_other_stages_that_write_the_same_from_what_there_is():
    others = {stage.name: stage for stage in (translucency_ratio, translucency_exponent, scatter)}
    sample = Tried({}, stage=translucency_ratio)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(of_stages, "_own", lambda sample: sample.stage)
        found = [(charge, stage) for charge, (_, stage) in of_stages._other_stages(sample, others)]
    assert [(charge.text, charge.blames) for charge, _ in found] == [("it computes translucency_exponent", SOURCE)]
    assert found[0][1] is translucency_exponent
