"""`sss-ref verify` and `diff`."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter
from rich.box import SIMPLE
from rich.markup import escape
from rich.table import Table

from sss_ref.cli.console import BAD_INPUT, DIFFERS, announce_compilation, err, out, progress
from sss_ref.cli.options import KERNELS, Execution

if TYPE_CHECKING:
    from sss_ref.results.diff import FolderDiff


def verify(
    folder: Annotated[Path, Parameter(help="A folder written by `sss-ref render`.")],
    *,
    execution: Execution = KERNELS,
) -> int:
    """Render the scene recorded in a result folder again, and compare every bit.

    Exit code 1 if anything differs: the rules, a file of the folder, the mesh, or the computation.
    """
    from sss_ref.results.verify import verify as verify_folder

    announce_compilation(execution)
    with progress("loading the scene") as show:
        verdict = verify_folder(folder, execution.interpreter, execution.threads, lambda name: show(f"pass {name}"))
    out.print(escape(verdict.message))
    return 0 if verdict.equal else DIFFERS


def diff(
    a: Annotated[Path, Parameter(help="A result folder, or a folder of buffers as NPY files.")],
    b: Annotated[Path, Parameter(help="The folder to compare it with.")],
    /,
    *,
    output: Annotated[Path | None, Parameter(alias="-o", help="A PNG of the first differing buffer.")] = None,
) -> int:
    """Compare the buffers of two folders bit by bit: which differs first, where, and by how much.

    Exit code 1 if a buffer differs; 2 if the folders cannot be compared, or if all is equal that both have, but one has
    more buffers than the other.
    """
    from sss_ref.results.diff import diff as diff_folders
    from sss_ref.results.diff_picture import checked_picture_file, write_diff_picture

    if output:
        checked_picture_file(output)
    found = diff_folders(a, b)
    if found.first:
        out.print(_table_of_differences(found))
        out.print(escape(f"first difference: buffer {found.first.name}, {found.first.first}"))
        if output:
            write_diff_picture(output, found.first.name, a, b)
            out.print(f"{escape(str(output))}: both versions of {found.first.name} and where they differ")
    else:
        out.print(f"equal in every bit: {', '.join(one.name for one in found.buffers)}")
    for folder, names in ((a, found.only_in_a), (b, found.only_in_b)):
        if names:
            err.print(f"[yellow]only in {escape(str(folder))}: {', '.join(names)}[/]")
    return DIFFERS if found.first else BAD_INPUT if found.only_in_a or found.only_in_b else 0


def _table_of_differences(found: "FolderDiff") -> Table:
    """One row a buffer: how many pixels differ, by how much, and how many values are how many ULP apart."""
    from sss_ref.results.diff import ULP_CLASSES

    table = Table(
        "buffer",
        "pixels",
        "largest",
        *ULP_CLASSES,
        box=SIMPLE,
        title="pixels that differ, and values by their distance in ULP",
    )
    for column in table.columns[1:]:
        column.justify = "right"
    for one in found.buffers:
        counts = (str(count) if count else "" for count in one.ulps)
        share = f"{one.differing} of {one.pixels}" if one.differing else "equal"
        table.add_row(one.name, share, f"{one.largest:.4g}", *counts, style="" if one.differing else "dim")
    return table
