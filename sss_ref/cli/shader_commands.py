"""`sss-ref glsl`, `bundle` and `webgl`: the stages as shaders, and scenes for other renderers."""

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from sss_ref.cli.console import out
from sss_ref.cli.options import NO_CHANGES, Changes
from sss_ref.errors import DumpError, SceneError
from sss_ref.errors.text_file import write_texts

SIDE = 48  # pixels: what a page judges in a few seconds

if TYPE_CHECKING:
    from sss_ref.language.pipeline import Pass
    from sss_ref.language.stage import Stage

InDialect = Annotated[
    Literal["glsl", "vulkan", "essl", "hlsl", "wgsl"],
    Parameter(help="Of OpenGL, Vulkan, WebGL 2 and OpenGL ES 3, Direct3D, or WebGPU."),
]


def glsl(
    stage: Annotated[str | None, Parameter(help="A stage, to print it as a function.", show_default=False)] = None,
    /,
    *,
    scene: Annotated[str, Parameter(help="A scene file or shipped scene, which decides on the stages.")] = "default",
    all: Annotated[bool, Parameter(negative="", help="Print the shaders of all passes; -o writes them.")] = False,
    output: Annotated[
        Path | None, Parameter(alias="-o", help="A folder for the shaders of all passes.", show_default=False)
    ] = None,
    dialect: InDialect = "glsl",
    registers: Annotated[
        bool, Parameter(negative="", help="Let the shaders also write what no buffer holds, so that it can be judged.")
    ] = False,
    changes: Changes = NO_CHANGES,
) -> int:
    """Print a stage of a scene as a shader, or complete shaders for all passes, or list passes and stages."""
    from sss_ref.interpret.shader import DIALECTS, array_lengths, shader_files, stage_source
    from sss_ref.scene.load import load_scene

    loaded = load_scene(scene, **changes.overrides())
    method, lengths = loaded.method, array_lengths(loaded.uniforms, DIALECTS[dialect])
    files = shader_files(method, lengths, DIALECTS[dialect], registers) if all or output else {}
    if output is not None:
        write_texts(output, files, DumpError)
        out.print(f"{output}: {', '.join(files)}", markup=False)
    elif all:
        out.print("\n".join(f"// {name}\n{text}" for name, text in files.items()), markup=False)
    if stage is not None:
        out.print(stage_source(_found(stage, method.passes), lengths, DIALECTS[dialect]), markup=False)
    if stage is None and not files:
        for this_pass in method.passes:
            names = dict.fromkeys(each.name for each in _stages(this_pass))
            out.print(f"{this_pass.name}: {', '.join(names)}")
    return 0


def bundle(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    output: Annotated[Path, Parameter(alias="-o", help="The folder for the bundle.")] = Path("bundle"),
    dialect: InDialect = "glsl",
    changes: Changes = NO_CHANGES,
) -> int:
    """Write a scene for another renderer: mesh, uniforms, shaders, passes and a porting guide."""
    from sss_ref.bundle.writing import write_bundle
    from sss_ref.scene.load import load_scene

    folder = write_bundle(load_scene(scene, **changes.overrides()), output, dialect)
    out.print(f"{folder}: read PORTING.md first", markup=False)
    return 0


def webgl(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    output: Annotated[
        Path | None, Parameter(alias="-o", help="The page to write: webgl.html or judge.html.", show_default=False)
    ] = None,
    judge: Annotated[
        bool, Parameter(negative="", help="Let the page judge each stage, and name the first wrong one.")
    ] = False,
    side: Annotated[
        int | None,
        Parameter(help="With --judge, pixels of the longer side of each picture; 48 if not given.", show_default=False),
    ] = None,
    changes: Changes = NO_CHANGES,
) -> int:
    """Write a page that draws a scene in a browser and offers its buffers as files, or that judges its stages."""
    from sss_ref.scene.load import load_scene
    from sss_ref.webgl import judge_page, page, reduced

    if side is not None and not judge:
        raise SceneError("--side: expected with --judge, got it alone; give the size of a scene's own page by --size")
    loaded = load_scene(scene, **changes.overrides())
    if judge:
        loaded = load_scene(scene, **{**changes.overrides(), **reduced(loaded, side or SIDE)})
    path = output or Path("judge.html" if judge else "webgl.html")
    write_texts(path.parent, {path.name: (judge_page if judge else page)(loaded)}, DumpError)
    out.print(f"{path}: open it in a browser", markup=False)
    return 0


def _stages(this_pass: "Pass") -> "list[Stage]":
    """The stages of a pass, the vertex stage first."""
    return [*this_pass.draw.vertex_stages, *this_pass.stages]


def _found(name: str, passes: "Iterable[Pass]") -> "Stage":
    """The stage of this name."""
    stages = {stage.name: stage for each in passes for stage in _stages(each)}
    if name not in stages:
        raise SceneError(f"stage: expected a stage of the scene ({', '.join(stages)}), got {name!r}")
    return stages[name]
