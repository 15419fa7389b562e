"""An explanation as HTML, for notebooks."""

from html import escape

from sss_ref.explanation.rows import Row, Section

# Notebooks align the cells of every table to the right; only `tr[class] td` is specific enough to outdo them.
STYLE = """
<style>
.sss-explanation { font: 13px/1.45 system-ui, sans-serif; max-width: 100%; overflow-x: auto; }
.sss-explanation h3 { margin: 1.2em 0 0.2em; font-size: 1.15em; }
.sss-explanation summary { cursor: pointer; margin: 0.5em 0 0.1em; }
.sss-explanation summary b { font-family: ui-monospace, monospace; }
.sss-explanation .note { opacity: 0.65; }
.sss-explanation table { border-collapse: collapse; margin: 0 0 0.6em 1em; }
.sss-explanation tr[class] td { font-family: ui-monospace, monospace; text-align: left; vertical-align: top;
  white-space: pre; padding: 1px 14px 1px 0; border: 0; }
.sss-explanation tr[class] td:first-child { white-space: pre-wrap; min-width: min(20em, 50vw);
  max-width: 32em; }
.sss-explanation .read td, .sss-explanation .call td, .sss-explanation .turn td { opacity: 0.65; }
.sss-explanation tr[class] td.bits { opacity: 0.5; }
.sss-explanation tr[class] td.glsl { color: #2a7f4f; }
.sss-explanation tr[class] td.unit { font-family: inherit; opacity: 0.65; }
</style>
"""
HEADING = "<thead><tr><th></th><th>value</th><th>may be</th><th>bits</th><th></th><th></th></tr></thead>"


def html(sections: list[Section]) -> str:
    """Sections as HTML with its own style; each stage can be folded."""
    return f'{STYLE}<div class="sss-explanation">{"".join(map(_section, sections))}</div>'


def _section(section: Section) -> str:
    note = f'<span class="note">{escape(section.note)}</span>'
    if section.level == 1:
        return f"<h3>{escape(section.title)}</h3>{note}"
    heading = HEADING if section.has_bounds else ""
    rows = "".join(_row(row, section.has_bounds) for row in section.rows)
    head = f"<summary><b>{escape(section.title)}</b> {note}</summary>"
    return f"<details open>{head}<table>{heading}{rows}</table></details>"


def _row(row: Row, has_bounds: bool) -> str:
    text = "    " * row.depth + row.text
    may_be = [("may-be", row.may_be)] if has_bounds else []
    cells = ("", text), ("", row.value), *may_be, ("bits", row.bits), ("unit", row.unit), ("glsl", row.glsl)
    return f'<tr class="{row.kind}">{"".join(f"<td class={name!r}>{escape(cell)}</td>" for name, cell in cells)}</tr>'
