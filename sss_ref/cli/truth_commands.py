"""`sss-ref truth`."""

import math
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter
from rich.markup import escape

from sss_ref.cli.console import err, out, progress
from sss_ref.cli.options import NO_CHANGES, Changes, Medium, Threads, TimeLimit
from sss_ref.errors import SceneError

if TYPE_CHECKING:
    from sss_ref.scene.scene import Scene
    from sss_ref.truth.radiance import Radiance

STEP = 8  # samples between two times that the folder is written


def truth(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    output: Annotated[Path, Parameter(alias="-o", help="The folder; an earlier truth there goes on.")] = Path("truth"),
    medium: Medium = None,
    border: Annotated[
        Literal["matched", "diffuse", "entered"],
        Parameter(
            help="Light does not notice the surface, or enters and leaves as by a diffuser under Fresnel's border; "
            "entered: of that only the light that has entered."
        ),
    ] = "matched",
    samples: Annotated[int, Parameter(help="Until each pixel has so many.")] = 64,
    time_limit: TimeLimit = None,
    seed: int = 0,
    threads: Threads = None,
    changes: Changes = NO_CHANGES,
) -> int:
    """Trace where the light of a scene really goes: mean radiance per pixel, each with its standard error."""
    from sss_ref.scene.load import load_scene
    from sss_ref.truth.media import volumes
    from sss_ref.truth.tracing import Tracing
    from sss_ref.truth.truth_folder import begun, recorded

    check_tracing(samples, seed, threads)
    loaded = load_scene(scene, **changes.overrides())
    tracing = Tracing(loaded, volumes(_medium(loaded, medium), where="--medium"), border, seed=seed)
    if "mm_per_unit" not in loaded.settings.model_fields_set:
        err.print("[yellow]warning: the scene has no mm_per_unit; a unit is taken for 1 mm[/]")
    with progress("tracing") as show:
        found = traced(begun(output, tracing), output, samples, time_limit, threads, show)
    told = recorded(found)
    out.print(
        f"{found.samples} samples a pixel, {found.lost} lost; mean radiance (red, green, blue) and standard error:"
    )
    out.print(f"{_numbers(told['mean'])} +- {_numbers(told['mean_error'])}")
    out.print(f"{escape(str(output))}: open image.png first")
    return 0


def check_tracing(samples: int, seed: int, threads: int | None, least: int = 1) -> None:
    """Raise SceneError for numbers that nothing can be traced with."""
    for option, value, lowest in (("--samples", samples, least), ("--seed", seed, 0), ("--threads", threads, 1)):
        if value is not None and value < lowest:
            raise SceneError(f"{option}: expected at least {lowest}, got {value}; give a larger number")


def _medium(scene: "Scene", given: str | None) -> str:
    """The name of what the body is made of."""
    name = given or scene.settings.material
    if name is None:
        raise SceneError("--medium: expected the name of a medium, got none and a scene without material; try skin1")
    return name


def traced(
    found: "Radiance",
    folder: Path,
    samples: int,
    seconds: float | None,
    threads: int | None,
    show: Callable[[str], None],
) -> "Radiance":
    """Trace until there are enough samples or the time is up, and write the folder every few samples.

    seconds: after which no sample is begun, but for the two without which no error is known; None: no such time.
    """
    from sss_ref.truth.truth_folder import write_truth

    end = math.inf if seconds is None else time.monotonic() + seconds
    while found.samples < samples and (found.samples < 2 or time.monotonic() < end):
        left = end - time.monotonic()
        found = found.more(min(STEP, samples - found.samples), threads, left)
        show(f"tracing: {found.samples} of {samples} samples a pixel")
        write_truth(folder, found)
    return found


def _numbers(values: object) -> str:
    assert isinstance(values, list)
    return " ".join(f"{value:.6f}" for value in values)
