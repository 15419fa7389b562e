"""`sss-ref measure`: how far each technique is from the truth."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter
from rich.box import SIMPLE
from rich.markup import escape
from rich.table import Table

from sss_ref.cli.console import announce_compilation, err, out, progress
from sss_ref.cli.fit_command import check_walks
from sss_ref.cli.options import KERNELS, NO_CHANGES, Changes, Medium, Threads, TimeLimit
from sss_ref.cli.truth_commands import check_tracing, traced

if TYPE_CHECKING:
    from sss_ref.yardstick.ladder import Ladder


def measure(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    output: Annotated[
        Path, Parameter(alias=("-o", "--out"), help="The folder; the truth of an earlier measurement there goes on.")
    ] = Path("measure"),
    methods: Annotated[
        tuple[str, ...],
        Parameter(negative="", consume_multiple=True, show_default=False, help="Some techniques; all if not given."),
    ] = (),
    dump: Annotated[
        Path | None,
        Parameter(show_default=False, help="What a GPU drew of the scene as it is: held against the oracle."),
    ] = None,
    medium: Medium = None,
    border: Annotated[
        Literal["entered", "diffuse", "matched"],
        Parameter(
            help="Of the truth: the light that has entered; diffuse: also less what Fresnel's border throws off."
        ),
    ] = "entered",
    fit: Annotated[
        bool,
        Parameter(negative="--no-fit", help="Measure the techniques also with keys that are fitted to the medium."),
    ] = True,
    samples: Annotated[int, Parameter(help="Of the truth, until each pixel has so many, 2 or more.")] = 256,
    time_limit: TimeLimit = None,
    photons: Annotated[int, Parameter(help="Of each walk that is fitted to.")] = 100_000,
    threads: Threads = None,
    changes: Changes = NO_CHANGES,
) -> int:
    """Measure how far each technique is from the truth: errors of radiance and colour, where, and the cost.

    Writes a page, a record and a table. Ambient light, gloss and textures are left out of all pictures.
    """
    from sss_ref.scene.load import load_scene
    from sss_ref.truth.material_fit import fitted_material
    from sss_ref.truth.truth_folder import begun
    from sss_ref.yardstick.ladder import climbed, drawn_image
    from sss_ref.yardstick.ladder_folder import TRUTH, checked_folder, write_ladder
    from sss_ref.yardstick.rungs import check_rungs, checked_methods
    from sss_ref.yardstick.yardstick import Yardstick, medium_of

    check_tracing(samples, 0, threads, least=2)
    check_walks(photons)
    chosen, overrides = checked_methods(methods), changes.overrides()
    of = Yardstick(scene, overrides, medium_of(load_scene(scene, **overrides), medium), border)
    tracing = of.tracing
    check_rungs(of, chosen, fit)
    drawn = drawn_image(of, dump) if dump else None
    folder = checked_folder(output)
    announce_compilation(KERNELS)
    with progress("tracing") as show:
        before = begun(folder / TRUTH, tracing)
        radiance = traced(before, folder / TRUTH, samples, time_limit, threads, show)
        fitted = fitted_material(of.volumes, photons, threads, True, show) if fit else None
        ladder = climbed(of, radiance, chosen, fitted, drawn, show)
        page = write_ladder(ladder, folder)
    _tell(ladder)
    out.print(f"{escape(str(page))}: open it first")
    return 0


def _tell(ladder: "Ladder") -> None:
    """What was left out, how well the truth is known, and the table without its regions."""
    from sss_ref.yardstick.color_difference import MISSING, has_color_difference
    from sss_ref.yardstick.ladder_table import OVERALL, rows

    if ladder.of.left_out:
        err.print(f"[yellow]left out, as the truth has none: {escape(', '.join(ladder.of.left_out))}[/]")
    if not has_color_difference():
        err.print(f"[yellow]{escape(MISSING)}[/]")
    count = ladder.radiance
    out.print(
        f"truth: {ladder.of.medium}, border {ladder.of.border}, {count.samples} samples a pixel, {count.lost} lost"
    )
    table = Table("technique", *OVERALL, "ms", box=SIMPLE)
    for column in table.columns[1:]:
        column.justify = "right"
    for cells in rows(ladder):
        table.add_row(*cells[: len(OVERALL) + 1], cells[-1])
    out.print(table)
