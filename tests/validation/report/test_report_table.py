"""The tables of the page, one row each, as HTML."""

import pytest

from sss_ref.results.diff import ULP_CLASSES
from sss_ref.validation.cause.power import Power, Sensitivity
from sss_ref.validation.report import report_table
from sss_ref.validation.report.report_table import buffer_table
from sss_ref.validation.verdict.background import Background
from sss_ref.validation.verdict.verdict import Verdict
from sss_ref.validation.verdict.widths import Widths


def verdict(**changed):
    """A verdict on 2,000 pixels with the pass and the stage that are told."""
    given = dict.fromkeys(("compared", "equal", "within", "bounded"), 2000)
    given |= dict.fromkeys(("ambiguous", "unbounded", "undefined"), 0)
    widths, ulps = Widths((1500, 0, 500, 0, 0, 0, 0, 0), 1234.0), (1999, 1, *[0] * (len(ULP_CLASSES) - 2))
    return Verdict("camera", "phong<", "lit", **(given | {"widths": widths, "ulps": ulps} | changed))


def row(**changed):
    """The cells of a row, and its class."""
    text = report_table._row(verdict(**changed))
    start, _, cells = text.partition("><td>")
    return cells.removesuffix("</td></tr>").split("</td><td>"), start.removeprefix("<tr").strip()


def test_a_row_has_a_cell_for_each_head():
    cells, kind = row(equal=1000, ambiguous=200, chained=1500)
    assert len(cells) == len(report_table.HEADS) and kind == 'class="inherits"'
    assert cells[0] == "lit<small>phong&lt;</small>" and cells[2:4] == ["2,000", "50.00%"]
    assert cells[4:9] == ["1,800", "200", "·", "·", "·"] and cells[9:11] == ["·", "75.00%"] and cells[12] == "1.23k"


@pytest.mark.parametrize(
    ("changed", "kind"),
    [
        ({}, ""),
        ({"within": 1999}, 'class="fail"'),
        ({"unbounded": 2000}, 'class="empty"'),
        ({"background": Background(30, 12, "0", "1", (0, 0), True)}, 'class="fail"'),
    ],
)
def test_a_row_is_of_a_kind(changed, kind):
    cells, found = row(**changed)
    assert found == kind and cells[10] == "·" and cells[9] == ("12" if "background" in changed else "·")


def test_estimates_have_a_mark():
    assert row(bounded=100, ambiguous=40)[0][4:9] == ["~1,960", "~40", "·", "·", "·"]


def test_a_share_of_nothing_is_none():
    assert report_table._share(1, 3) == "33.33%" and report_table._share(0, 3) == "0.00%"
    assert report_table._share(None, 3) == report_table._share(0, 0) == "·"


def test_a_bar_has_a_part_for_each_outcome_that_is_there():
    assert report_table._outcome_bar(verdict(within=1990)) == (
        '<span class="bar" style="width:110px"><i title="certain 1990" style="flex:1990 0 2px;background:#2f8f5b"></i>'
        '<i title="fail 10" style="flex:10 0 2px;background:#e24634"></i></span>'
    )


def test_a_histogram_has_a_column_for_each_class():
    assert report_table._histogram((8, 0, 1, 4), ("0", "1", "<2", "3")) == (
        '<svg class="histogram" width="36" height="17" role="img"><title>0: 8, &lt;2: 1, 3: 4</title>'
        '<rect x="0" y="0.0" width="8" height="16.0"/><rect class="base" x="0" y="16" width="8" height="1"/>'
        '<rect x="9" y="16.0" width="8" height="0.0"/><rect class="base" x="9" y="16" width="8" height="1"/>'
        '<rect x="18" y="14.0" width="8" height="2.0"/><rect class="base" x="18" y="16" width="8" height="1"/>'
        '<rect x="27" y="8.0" width="8" height="8.0"/><rect class="base" x="27" y="16" width="8" height="1"/></svg>'
    )
    assert 'height="0.0"' in report_table._histogram((0, 0), ("0", "1"))
    assert 'y="0.0" width="8" height="16.0"' in report_table._histogram((1, 0), ("0", "1"))


def test_rows_are_grouped_by_passes():
    table = buffer_table([verdict(), verdict()])
    assert table.count('<tr class="pass"><th colspan="14">pass camera</th></tr>') == 1 and table.count("<tbody>") == 1


def test_what_would_be_seen_of_a_stage():
    numbers = (Sensitivity("x", 0.01, True), Sensitivity("y", None, True))
    assert report_table._power_row(Power("a<b", numbers, 3, 2, ("c<d",), ("e",))) == (
        '<tr><td>a&lt;b</td><td><span class="number">x 0.01</span><span class="number blind">y not even doubled</span>'
        "</td><td>2 of 3<div>not: <code>c&lt;d</code></div><div>no difference here: e</div></td></tr>"
    )
    assert report_table._power_row(Power("a", (), 0, 0, ())) == "<tr><td>a</td><td></td><td>·</td></tr>"
