"""Fragment shaders that write what the rasterizer gives them: their triangle, its depth, and its varyings."""

from typing import Any

from sss_ref.interpret.shader import ESSL
from sss_ref.interpret.shader.dialect import Parts
from sss_ref.language.pipeline import Pass

TRIANGLE, DEPTH = "triangle", "depth"  # outputs; of a second draw "triangle_2", and so on


def varyings_draws(this_pass: Pass, read: list[str]) -> list[dict[str, Any]]:
    """The draws that fill what a mesh's draw gives: of each its outputs, name -> type, and its fragment shader.

    In a layout no depth decides. Each writes its own triangle, so that what is interpolated is judged on the triangle
    that it was interpolated on.
    read: the varyings that the stages of the pass read.
    """
    kinds = {name: this_pass.draw.varyings[name] for name in read}
    first = {TRIANGLE: int} if this_pass.draw.layout else {TRIANGLE: int, DEPTH: float}
    room = ESSL.most_outputs - len(first)
    parts = [first | dict(list(kinds.items())[:room])]
    rest = list(kinds.items())[room:]
    step = ESSL.most_outputs - 1
    for number, start in enumerate(range(0, len(rest), step), start=2):
        parts.append({f"{TRIANGLE}_{number}": int, **dict(rest[start : start + step])})
    return [{"outputs": part, "fragment": _fragment(this_pass, part)} for part in parts]


def _fragment(this_pass: Pass, outputs: dict[str, Any]) -> str:
    """The shader that writes these outputs."""
    value = {name: ESSL.name(name) for name in outputs if name in this_pass.draw.varyings}
    value |= {DEPTH: ESSL.given["depth"]}
    lines = [f"{ESSL.out(name)} = {value.get(name, ESSL.given['triangle'])};" for name in outputs]
    parts = Parts(
        about=f"Fragment shader of pass {this_pass.name}: what the rasterizer gives each fragment.",
        textures={},
        uniforms={},
        lengths={},
        varyings=this_pass.draw.varyings,
        definitions="",
        lines=lines,
        mesh=True,
        outputs=outputs,
        read=list(outputs),
    )
    return ESSL.fragment(parts, ESSL)
