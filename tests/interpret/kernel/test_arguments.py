"""One list of arguments for the signature and for the call: every value arrives under its own name."""

import numpy as np
import pytest

from sss_ref.interpret.kernel.arguments import OUT, UNIFORMS, Arguments
from sss_ref.language import Array, mat3, vec3
from sss_ref.language.pipeline import MeshDraw, Pass, ScreenDraw
from sss_ref.passes.vertex import mesh_vertex

READS = {"offset": vec3, "lit": vec3, "count": int, "rotation": mat3, "weights": Array[float], "scale": float}
ARGUMENTS = Arguments(("row0", "width"), READS, {"lit"}, ("out_lit", "background"))
OFFSET, ROTATION = np.array([1, 2, 3], np.float32), np.arange(4, 13, dtype=np.float32).reshape(3, 3)
READ = {
    "offset": OFFSET,
    "lit": "lit's",
    "count": 7,
    "rotation": ROTATION,
    "weights": "weights'",
    "scale": np.float32(13),
}
OWN = {"out_lit": "out's", "background": "background's", "width": 64, "stencil": "of no use here"}


def arrived(arguments, read, own, **missing):
    """What a function of these arguments finds under each name when it is called."""
    scope = {"found": []}
    exec(f"def function({arguments.signature}):\n    found.append(locals())", scope)
    arguments.bound(scope["function"], read, own)(**missing)
    (found,) = scope["found"]
    return found


def test_the_signature_names_what_is_drawn_read_and_filled_in_this_order():
    assert ARGUMENTS.signature == "row0, width, uniforms, lit, count, weights, out_lit, background"


def test_every_value_arrives_under_its_own_name():
    found = arrived(ARGUMENTS, READ, OWN, row0=32)
    uniforms = found.pop(UNIFORMS)
    assert (uniforms.dtype, uniforms.tolist()) == (np.float32, [*range(1, 14)])
    assert found == {
        "row0": 32,
        "width": 64,
        "lit": "lit's",
        "count": 7,
        "weights": "weights'",
        "out_lit": "out's",
        "background": "background's",
    }


def test_a_uniform_is_no_argument_of_the_draw_that_has_its_name():
    """The colour `background` is a uniform of some passes, and `background` the argument of all."""
    arguments = Arguments((), {"background": vec3}, (), ("background",))
    found = arrived(arguments, {"background": OFFSET}, {"background": "the argument"})
    assert found["background"] == "the argument" and found[UNIFORMS].tolist() == [1, 2, 3]


def test_each_float_is_where_its_slot_says():
    uniforms = arrived(ARGUMENTS, READ, OWN, row0=0)[UNIFORMS]
    slots = {
        name + end: eval(element, {UNIFORMS: uniforms})
        for name, ends in ARGUMENTS.slots.items()
        for end, element in ends
    }
    assert slots == {
        **{f"offset_{letter}": OFFSET[k] for k, letter in enumerate("xyz")},
        **{f"rotation_{row}{column}": ROTATION[row, column] for row in range(3) for column in range(3)},
        "scale": 13.0,
    }
    assert len(uniforms) == len(slots)


@pytest.mark.parametrize("missing", ["lit", "scale", "out_lit", "row0"])
def test_a_value_that_is_missing_is_not_passed_over(missing):
    read = {name: value for name, value in READ.items() if name != missing}
    own = {name: value for name, value in {**OWN, "row0": 0}.items() if name != missing}
    with pytest.raises(KeyError, match=missing):
        arrived(ARGUMENTS, read, own)


@pytest.mark.parametrize(
    ("draw", "drawn"),
    [
        (MeshDraw(mesh_vertex, "triangle", "depth"), ["piece", "primitives", "step"]),
        (ScreenDraw("mask"), ["stencil"]),
        (ScreenDraw(), []),
    ],
)
def test_what_a_function_is_told_of_its_draw(draw, drawn):
    arguments = Arguments.of_fragments(Pass("some", "camera", draw, ()), (), ["a", "b"])
    assert arguments.names == ["row0", "row1", "width", *drawn, UNIFORMS, OUT + "a", OUT + "b", "background"]


def test_a_vertex_function_takes_the_attributes_it_reads_as_arrays():
    arguments = Arguments.of_vertices(mesh_vertex)
    assert arguments.names == [UNIFORMS, "position", "normal", "uv", "clip_position", "attributes"]
    assert arguments.packed == ["world_from_model", "normal_from_model", "clip_from_model"]
