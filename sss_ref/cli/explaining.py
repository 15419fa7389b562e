"""`sss-ref explain`."""

import re
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter
from rich.text import Text

from sss_ref.cli.console import announce_compilation, out, progress
from sss_ref.cli.options import KERNELS, NO_CHANGES, Changes, Execution
from sss_ref.errors import SceneError

if TYPE_CHECKING:
    from sss_ref.explanation.rows import Row, Section

SOURCE_WIDTH, VALUE_WIDTH, BITS_WIDTH = 76, 42, 28  # characters
STYLES = {"read": "dim", "line": "", "call": "dim", "turn": "bold"}


def explain(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    pixel: Annotated[str, Parameter(help="Column and row, such as 256,300; row 0 is at the bottom.")],
    stage: Annotated[str | None, Parameter(help="Show this stage only.", show_default=False)] = None,
    depth: Annotated[int, Parameter(help="How many calls inside each other are opened.")] = 1,
    glsl: Annotated[bool, Parameter(negative="", help="Show every line as the GLSL shader has it, too.")] = False,
    changes: Changes = NO_CHANGES,
    execution: Execution = KERNELS,
) -> int:
    """Show for one pixel every line of every stage that made it, with its value and bit pattern."""
    from sss_ref.explanation.explain import explain as explain_scene
    from sss_ref.explanation.rows import sections
    from sss_ref.scene.load import load_scene

    at = _pixel(pixel)
    announce_compilation(execution)
    with progress("rendering"):
        explanation = explain_scene(
            load_scene(scene, **changes.overrides()), at, execution.interpreter, execution.threads
        )
    for section in sections(explanation.passes, stage, depth, glsl):
        _print(section)
    return 0


def _pixel(text: str) -> tuple[int, int]:
    place = re.fullmatch(r"\s*(\d{1,9})\s*,\s*(\d{1,9})\s*", text)
    if not place:
        raise SceneError(f"--pixel: expected COLUMN,ROW, got {text[:60]!r}; write it as 256,300")
    return int(place[1]), int(place[2])


def _print(section: "Section") -> None:
    if section.level == 1:
        out.print(Text.assemble("\n", (section.title, "bold yellow"), "  ", (section.note, "dim")))
        return
    out.print(Text.assemble("\n  ", (section.title, "bold cyan"), "  ", (section.note, "dim")))
    for row in section.rows:
        out.print(_line(row))
        if row.glsl:
            out.print(Text("    " + "  " * row.depth + row.glsl, "green"))


def _line(row: "Row") -> Text:
    """A row in columns; a source line that does not fit has its values below it."""
    style = STYLES[row.kind]
    source = "    " + "  " * row.depth + row.text
    line = Text(source.ljust(SOURCE_WIDTH), style)
    if row.value and len(source) >= SOURCE_WIDTH:
        line.append("\n" + " " * SOURCE_WIDTH)
    line.append(row.value.ljust(VALUE_WIDTH) + "  ", style or "bold")
    line.append(row.bits.ljust(BITS_WIDTH), "dim")
    line.append(row.unit, "dim italic")
    line.rstrip()
    return line
