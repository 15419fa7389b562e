"""`sss-ref witness`."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sss_ref.cli.console import BAD_INPUT, DIFFERS, out

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sss_ref.gl.stand_alone_run import ShaderVerdict
    from sss_ref.validation.witness.witness import Witness


def witness(
    file: Annotated[Path, Parameter(help="The file that `validate --witness` wrote.")],
    /,
    *,
    glsl: Annotated[
        Path | None,
        Parameter(
            help="Write a shader that runs the stage on these bits and shows green or red; NAME.shader_test: a "
            "test for Piglit.",
            show_default=False,
        ),
    ] = None,
    run_glsl: Annotated[bool, Parameter(negative="", help="Run that shader on this machine's OpenGL.")] = False,
    wgsl: Annotated[
        Path | None,
        Parameter(help="The same as WGSL; its first comment says how to run it.", show_default=False),
    ] = None,
    run_wgsl: Annotated[bool, Parameter(negative="", help="Run that on this machine's WebGPU.")] = False,
) -> int:
    """Judge a single wrong pixel by its own file, without scene or dump.

    Exit code 1 if it is wrong, 2 if this version computes the stage otherwise than the one that wrote the file.
    """
    from sss_ref.validation.verdict.outcomes import FAIL, OUTCOMES
    from sss_ref.validation.witness.recalling import Standing, recalled
    from sss_ref.validation.witness.witness_record import read_record

    record = read_record(file)
    found = recalled(record, str(file))
    standing = Standing.of(record, found.situation.stage)
    _print(found, record.why)
    for path in _written(found, glsl, wgsl):
        out.print(f"{path}: green where the stage is right", markup=False)
    if run_glsl:
        _run(found)
    if run_wgsl:
        _run_wgsl(found)
    wrong = found.outcome == OUTCOMES[FAIL]
    if standing.other:
        out.print(f"other: {standing.other}; by the stage here it is {'wrong' if wrong else 'right'}", markup=False)
        return BAD_INPUT
    out.print(f"wrong: {found.drawn.buffer} is out of reach" if wrong else f"right: {found.drawn.buffer} is in reach")
    return DIFFERS if wrong else 0


def _print(found: "Witness", why: tuple[str, ...]) -> None:
    from sss_ref.explanation.values import between, shown
    from sss_ref.validation.witness.witness import as_value

    drawn, kind = found.drawn, found.kind
    got, expected, low, high = (as_value(kind, each) for each in (found.got, found.expected, *found.allowed))
    right, (column, row) = between((low, high)), drawn.at
    exact = (found.reach == 0).all()
    for line in (
        f"stage {found.situation.stage.name} of pass {drawn.pass_name}, pixel {column},{row} of {drawn.buffer}",
        f"drawn by {drawn.device or 'a device that is not given'}: {shown(got)}",
        f"the reference has {shown(expected)}; {'nothing else is right' if exact else f'right is {right}'}",
        *(f"  {each}" for each in why),
    ):
        out.print(line, markup=False)


def _written(found: "Witness", glsl: Path | None, wgsl: Path | None) -> "Iterator[Path]":
    """Write the shaders that are asked for; their paths."""
    from sss_ref.validation.witness.stand_alone import write_stand_alone
    from sss_ref.validation.witness.stand_alone_wgsl import write_stand_alone_wgsl

    if glsl:
        yield write_stand_alone(found, glsl)
    if wgsl:
        yield write_stand_alone_wgsl(found, wgsl)


def _run_wgsl(found: "Witness") -> None:
    """Run the WGSL here, and say what came of it."""
    from sss_ref.validation.witness.stand_alone_wgsl import stand_alone_wgsl
    from sss_ref.webgpu.witness_run import run_wgsl_alone

    _tell(run_wgsl_alone(stand_alone_wgsl(found)))


def _run(found: "Witness") -> None:
    """Run the shader here, and say what came of it."""
    from sss_ref.gl.stand_alone_run import run_alone
    from sss_ref.validation.witness.stand_alone import stand_alone

    _tell(run_alone(stand_alone(found)))


def _tell(done: "ShaderVerdict") -> None:
    out.print(f"{done.device}: the stage is {'right' if done.right else 'wrong'} here", markup=False)
