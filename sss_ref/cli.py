"""The command line: `sss-ref render`, `verify`, `scenes` and `warmup`. Nothing is computed here."""

import sys
import time
import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from threading import Timer
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import App, CycloptsError, Parameter
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from sss_ref.errors import SceneError, SssRefError

if TYPE_CHECKING:
    from sss_ref.result import Result

DIFFERS, BAD_INPUT = 1, 2  # exit codes other than 0
PATIENCE = 1.0  # seconds of work before its progress is shown
HASH_DIGITS = 12
CUTTING_FAR = 4.2  # scene units: a far plane through the middle of the default scene's mesh

PURPOSE = "The CPU reference for real-time subsurface scattering."


def _version() -> str:
    from sss_ref.io.manifest import package_version

    return package_version()


app = App(name="sss-ref", help=PURPOSE, version=_version, result_action="return_value")
out, err = Console(highlight=False, soft_wrap=True), Console(stderr=True, highlight=False, soft_wrap=True)


@Parameter(name="*")
@dataclass(frozen=True)
class Changes:
    """What is put on top of the scene file."""

    set: Annotated[tuple[str, ...], Parameter(negative="", consume_multiple=False, show_default=False)] = ()
    """Override one value, such as `camera.width=512` or `lights.0.intensity=2`; may be given several times."""
    preset: str | None = None
    """The preset that fills what the scene leaves out."""
    method: str | None = None
    """Where light is diffused: screen_space or texture_space."""
    size: str | None = None
    """Size of the image, such as 512x512."""

    def overrides(self) -> dict[str, Any]:
        """The overrides that `load_scene` takes, by dotted key."""
        chosen = {key: value for key in ("preset", "method") if (value := getattr(self, key)) is not None}
        return {**chosen, **_size(self.size), **dict(map(_assignment, self.set))}


@Parameter(name="*")
@dataclass(frozen=True)
class Execution:
    """How the stages are run; the bits are the same."""

    interpreter: Literal["kernel", "arrays"] = "kernel"
    """Compiled kernels, or plain NumPy."""
    threads: Annotated[int | None, Parameter(show_default=False)] = None
    """How many share the work; one per processor if not given."""

    def __post_init__(self) -> None:
        if self.threads is not None and self.threads < 1:
            raise SceneError(f"--threads: expected at least 1, got {self.threads}; leave it out for one per processor")


NO_CHANGES, KERNELS = Changes(), Execution()


@app.command
def render(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    output: Annotated[Path, Parameter(alias="-o", help="The result folder; replaces an earlier result.")] = Path("out"),
    changes: Changes = NO_CHANGES,
    keep: Annotated[Literal["all", "final"], Parameter(help="Write all buffers, or the final image alone.")] = "all",
    until: Annotated[str | None, Parameter(help="Stop after a pass, a stage or a buffer.")] = None,
    execution: Execution = KERNELS,
) -> int:
    """Render a scene into a folder of pictures, buffers and hashes."""
    from sss_ref.io.folder import checked_target, save
    from sss_ref.methods.catalogue import method_of
    from sss_ref.methods.until import buffers_until
    from sss_ref.rendering import render as render_scene
    from sss_ref.scene.load import load_scene

    if until and keep == "final":
        raise SceneError("--until: expected without --keep final, got both; the final image needs every stage")
    checked_target(output)
    _announce_compilation(execution)
    with _progress("loading the scene") as show:
        loaded = load_scene(scene, **changes.overrides())
        wanted = buffers_until(method_of(loaded.settings), until) if until else keep
        result = render_scene(
            loaded, execution.interpreter, execution.threads, wanted, lambda name: show(f"pass {name}")
        )
        show("writing files")
        folder = save(result, output, execution.interpreter, execution.threads)
    for warning in loaded.warnings:
        err.print(f"[yellow]warning: {escape(warning)}[/]")
    out.print(_table_of_passes(result))
    out.print(f"{escape(str(folder))}: open overview.png first")
    return 0


@app.command
def verify(
    folder: Annotated[Path, Parameter(help="A folder written by `sss-ref render`.")],
    *,
    execution: Execution = KERNELS,
) -> int:
    """Render the scene recorded in a result folder again, and compare every bit.

    Exit code 1 if anything differs: the rules, a file of the folder, the mesh, or the computation.
    """
    from sss_ref.io.verify import verify as verify_folder

    _announce_compilation(execution)
    with _progress("loading the scene") as show:
        verdict = verify_folder(folder, execution.interpreter, execution.threads, lambda name: show(f"pass {name}"))
    out.print(escape(verdict.message))
    return 0 if verdict.equal else DIFFERS


@app.command
def scenes() -> int:
    """List the shipped scenes."""
    from sss_ref.scene.shipped import scene_names, scene_path

    table = Table(box=None, show_header=False, padding=(0, 2, 0, 0))
    for name in scene_names():
        first, *_ = [*scene_path(name).read_text(encoding="utf-8").splitlines(), ""]
        table.add_row(name, escape(first.removeprefix("#").strip()) if first.startswith("#") else "")
    out.print(table)
    return 0


@app.command
def warmup() -> int:
    """Compile the kernels of the default scene with every preset, so that later renderings start at once."""
    from sss_ref.compiled import cache_folder
    from sss_ref.rendering import render as render_scene
    from sss_ref.scene.load import load_scene
    from sss_ref.scene.presets import PRESETS

    small = {f"{table}.{side}": 64 for table in ("camera", "shadow_map") for side in ("width", "height")}
    variants: list[dict[str, Any]] = [{"preset": preset} for preset in PRESETS]
    variants.append({"camera.far": CUTTING_FAR})  # so that the clipper is compiled as well
    start = time.perf_counter()
    with _progress("compiling kernels") as show:
        for variant in variants:
            scene = load_scene("default", **small, **variant)
            for keep in ("all", "final"):
                show(f"compiling kernels: {scene.settings.preset}, {keep}")
                render_scene(scene, keep=keep)
    place = cache_folder() or "nowhere: no folder can be written to, see SSS_REF_CACHE_DIR"
    out.print(f"kernels ready after {time.perf_counter() - start:.1f} s, kept in {escape(str(place))}")
    return 0


def main(tokens: list[str] | None = None) -> int:
    """Run the command line; returns the exit code: 0, 1 where `verify` finds a difference, 2 for bad input."""
    try:
        return app(tokens, exit_on_error=False, error_console=err) or 0
    except SssRefError as error:
        err.print(f"[red]error:[/] {escape(str(error))}")
        return BAD_INPUT
    except CycloptsError:
        return BAD_INPUT  # cyclopts has printed it


def _size(text: str | None) -> dict[str, int]:
    """The camera's overrides for WIDTHxHEIGHT."""
    if text is None:
        return {}
    width, cross, height = text.lower().partition("x")
    if not (cross and width.isdecimal() and height.isdecimal()):
        raise SceneError(f"--size: expected WIDTHxHEIGHT, got {text!r}; write it as 512x512")
    return {"camera.width": int(width), "camera.height": int(height)}


def _assignment(text: str) -> tuple[str, Any]:
    """The key and value of `key.path=value`; a value that is not TOML is taken as text."""
    key, equals, value = text.partition("=")
    if not (equals and key):
        raise SceneError(f"--set: expected key.path=value, got {text!r}; write it as camera.width=512")
    try:
        return key, tomllib.loads(f"value = {value}")["value"]
    except tomllib.TOMLDecodeError:
        return key, value


def _announce_compilation(execution: Execution) -> None:
    from sss_ref.compiled import is_cold

    if execution.interpreter == "kernel" and is_cold():
        err.print("compiling kernels (once per version; about 15 s) ...")


@contextmanager
def _progress(first: str) -> Iterator[Callable[[str], None]]:
    """A function that shows what is being done: on a terminal, from the second second on, and nowhere else."""
    if not err.is_terminal:
        yield lambda text: None
        return
    status = err.status(first)
    timer = Timer(PATIENCE, status.start)
    timer.start()
    try:
        yield status.update
    finally:
        timer.cancel()
        timer.join()
        status.stop()


def _table_of_passes(result: "Result") -> Table:
    """One row a pass: its duration, its buffers and the first digits of their hashes."""
    from sss_ref.methods.catalogue import method_of

    table = Table("pass", "ms", "buffer", "sha256")
    table.columns[1].justify = "right"
    for one in method_of(result.scene.settings).passes:
        kept = [name for name in one.outputs if name in result.hashes]
        digests = [result.hashes[name][:HASH_DIGITS] for name in kept]
        if one.name in result.timings:
            table.add_row(one.name, f"{result.timings[one.name] * 1e3:.0f}", "\n".join(kept), "\n".join(digests))
            table.add_section()
    return table


if __name__ == "__main__":
    sys.exit(main())
