"""Exercises whose answer is a function of GLSL: compiled by this machine's OpenGL and run beside the right numbers."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotChecked, NotYet
from sss_ref.course.checks.kinds import described
from sss_ref.errors import ShaderError

WIDTH = {"float": 1, "bool": 1, "vec2": 2, "vec3": 3, "vec4": 4}
SIGNATURE = re.compile(r"(\w+) (\w+)\((.*)\)")
COMPLAINT = re.compile(r"(?:ERROR: )?\d+[:(](\d+)\)?(?:\(\d+\))?:? *(.*)")  # of Mesa, NVIDIA and ANGLE


@dataclass(frozen=True)
class Signature:
    """The first line of a function in GLSL, such as `float lambert(vec3 normal, vec3 to_light)`."""

    text: str
    result: str
    name: str
    parameters: Mapping[str, str]  # name -> type

    @classmethod
    def of(cls, text: str) -> "Signature":
        """Read the line."""
        result, name, listed = SIGNATURE.fullmatch(text).groups()  # type: ignore[union-attr]
        pairs = [parameter.split() for parameter in listed.split(", ")]
        return cls(text, result, name, {each: kind for kind, each in pairs})


def compared_glsl(
    answer: Any, signature: str, given: Mapping[str, np.ndarray], expected: np.ndarray, hint: str, within: float = 1e-4
) -> None:
    """Raise NotYet unless a function in GLSL gives the expected numbers, within a part of them.

    given: parameter -> (N,) or (N, C). expected: (N,) or (N, C). hint: where to look.
    Raises NotChecked where there is no OpenGL.
    """
    wanted = Signature.of(signature)
    got = run_glsl(answer, wanted, given)
    right = np.asarray(expected, np.float64).reshape(got.shape)
    if not np.isfinite(got).all():
        raise NotYet("your function gives nan or infinity: a division by 0, or a power of a negative number?")
    wrong = (np.abs(got - right) > within * np.maximum(np.abs(right), 1e-3)).any(axis=1)
    if wrong.any():
        raise NotYet(f"`{wanted.name}` is wrong for {np.count_nonzero(wrong)} of {len(got)} inputs. {hint}")


def run_glsl(source: Any, signature: Signature, given: Mapping[str, np.ndarray]) -> np.ndarray:
    """What a function in GLSL gives: float64 (N, components), computed for each input by OpenGL.

    Raises NotYet where it does not compile, NotChecked where there is no OpenGL.
    """
    if not isinstance(source, str):
        raise NotYet(
            f"what is checked is {described(source)}: write the function in GLSL, as a text between three quotes."
        )
    if not re.search(rf"\b{signature.name}\s*\(", source):
        raise NotYet(f"there is no function `{signature.name}` in it: keep its first line, `{signature.text}`.")
    from sss_ref.gl.context import open_context

    try:
        context = open_context()
    except ShaderError as error:
        raise NotChecked(str(error)) from None
    try:
        return _fed_back(context, source, signature, given)
    finally:
        context.release()


def _fed_back(context: Any, source: str, signature: Signature, given: Mapping[str, np.ndarray]) -> np.ndarray:
    """Run the function for each vertex of a draw whose outputs are written back."""
    import moderngl

    try:
        program = context.program(vertex_shader=_vertex_shader(source, signature), varyings=["result"])
    except moderngl.Error as error:
        raise NotYet(f"that does not compile: {_complaint(str(error))}") from None
    columns = {name: np.asarray(given[name], np.float32) for name in signature.parameters}
    count = len(next(iter(columns.values())))
    buffers = [
        (context.buffer(np.ascontiguousarray(values)), f"{WIDTH[signature.parameters[name]]}f", f"given_{name}")
        for name, values in columns.items()
        if f"given_{name}" in program  # a driver drops what the function does not read
    ]
    width = WIDTH[signature.result]
    target = context.buffer(reserve=4 * width * count)
    context.simple_framebuffer((1, 1)).use()  # without a window there is none, and OpenGL would refuse to draw
    context.vertex_array(program, buffers).transform(target, moderngl.POINTS, vertices=count)
    return np.frombuffer(target.read(), np.float32).reshape(count, width).astype(np.float64)


def _vertex_shader(source: str, signature: Signature) -> str:
    """A shader that hands its attributes to the function; truths travel as numbers. #line: as the reader counts."""
    carried = {name: "float" if kind == "bool" else kind for name, kind in signature.parameters.items()}
    result = "float" if signature.result == "bool" else signature.result
    inputs = "".join(f"in {kind} given_{name};\n" for name, kind in carried.items())
    passed = ", ".join(
        f"given_{name} != 0.0" if kind == "bool" else f"given_{name}" for name, kind in signature.parameters.items()
    )
    return (
        f"#version 400\n{inputs}out {result} result;\n#line 1\n{source}\n"
        f"void main() {{ result = {result}({signature.name}({passed})); }}\n"
    )


def _complaint(text: str) -> str:
    """The first thing that a compiler says, with the line of the reader's text."""
    for line in text.splitlines():
        if found := COMPLAINT.match(line.strip()):
            return f"line {found[1]}: {found[2].removeprefix('error: ').strip()}."
    return "is its first line as it was, and does each statement end with a semicolon?"
