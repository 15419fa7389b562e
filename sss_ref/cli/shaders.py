"""`sss-ref glsl` and `bundle`: the stages as shaders, and a scene for another renderer."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sss_ref.cli.console import out
from sss_ref.cli.options import NO_CHANGES, Changes
from sss_ref.errors import DumpError, SceneError

if TYPE_CHECKING:
    from sss_ref.language.pipeline import Pass
    from sss_ref.language.stage import Stage


def glsl(
    stage: Annotated[str | None, Parameter(help="A stage, to print it as a function.", show_default=False)] = None,
    /,
    *,
    scene: Annotated[str, Parameter(help="A scene file or shipped scene, which decides on the stages.")] = "default",
    output: Annotated[
        Path | None, Parameter(alias="-o", help="A folder for the shaders of all passes.", show_default=False)
    ] = None,
    changes: Changes = NO_CHANGES,
) -> int:
    """Print a stage of a scene as GLSL, or write complete shaders for all passes, or list passes and stages."""
    from sss_ref.interpret.shader import array_lengths, shader_files, stage_source
    from sss_ref.methods.catalogue import method_of
    from sss_ref.scene.load import load_scene
    from sss_ref.scene.uniforms import uniforms

    loaded = load_scene(scene, **changes.overrides())
    method, lengths = method_of(loaded.settings), array_lengths(uniforms(loaded))
    if output is not None:
        files = shader_files(method, lengths)
        _write(output, files)
        out.print(f"{output}: {', '.join(files)}", markup=False)
    if stage is not None:
        out.print(stage_source(_found(stage, method.passes), lengths), markup=False)
    if stage is None and output is None:
        for one in method.passes:
            out.print(f"{one.name}: {', '.join(dict.fromkeys(each.name for each in _stages(one)))}")
    return 0


def bundle(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    output: Annotated[Path, Parameter(alias="-o", help="The folder for the bundle.")] = Path("bundle"),
    changes: Changes = NO_CHANGES,
) -> int:
    """Write a scene for another renderer: mesh, uniforms, shaders, passes and a porting guide."""
    from sss_ref.io.bundle import write_bundle
    from sss_ref.scene.load import load_scene

    folder = write_bundle(load_scene(scene, **changes.overrides()), output)
    out.print(f"{folder}: read PORTING.md first", markup=False)
    return 0


def _stages(one: "Pass") -> "list[Stage]":
    """The stages of a pass, the vertex stage first."""
    from sss_ref.language.pipeline import MeshDraw

    return [*([one.draw.vertex] if isinstance(one.draw, MeshDraw) else []), *one.stages]


def _found(name: str, passes: "Iterable[Pass]") -> "Stage":
    """The stage of this name."""
    stages = {stage.name: stage for one in passes for stage in _stages(one)}
    if name not in stages:
        raise SceneError(f"stage: expected a stage of the scene ({', '.join(stages)}), got {name!r}")
    return stages[name]


def _write(folder: Path, files: Mapping[str, str]) -> None:
    """Write files into a folder, which is made if need be."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            (folder / name).write_text(text, encoding="utf-8")
    except OSError as error:
        raise DumpError(f"{folder}: expected a folder to write shaders into, got {error}; choose another") from None
