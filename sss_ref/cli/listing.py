"""`sss-ref scenes` and `info`: what there is to render."""

from dataclasses import asdict
from typing import Annotated

from cyclopts import Parameter
from rich.markup import escape
from rich.table import Table

from sss_ref.cli.console import out


def scenes() -> int:
    """List the shipped scenes."""
    from sss_ref.scene_file.shipped import scene_names, scene_path

    table = _plain_table()
    for name in scene_names():
        first, *_ = [*scene_path(name).read_text(encoding="utf-8").splitlines(), ""]
        table.add_row(name, escape(first.removeprefix("#").strip()) if first.startswith("#") else "")
    out.print(table)
    return 0


def info(
    mesh: Annotated[str, Parameter(help="A mesh file, or the name of a shipped mesh.")],
    /,
    *,
    as_json: Annotated[bool, Parameter(name="--json", negative="", help="Print JSON instead of a table.")] = False,
) -> int:
    """Say what is in a mesh: its size, whether it is closed, and whether its UVs can hold an irradiance map."""
    from sss_ref.cli.mesh_facts import mesh_facts
    from sss_ref.mesh.mesh_file import load_mesh
    from sss_ref.scene_file.shipped import given_mesh

    facts = mesh_facts(load_mesh(given_mesh(mesh)))
    if as_json:
        out.print_json(data=asdict(facts))
        return 0
    table = _plain_table()
    for label, told in facts.rows():
        table.add_row(label, escape(told))
    out.print(table)
    return 0


def _plain_table() -> Table:
    """Two columns without lines."""
    return Table(box=None, show_header=False, padding=(0, 2, 0, 0))
