"""The stage at the worst pixel: what each line may be, and what was drawn, on the page, the terminal and as data."""

import numpy as np
import pytest
from scenes import around, sphere, written

import sss_ref
from sss_ref.cli.verdicts import print_report
from sss_ref.language.types import components
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.report.report_data import as_json
from sss_ref.validation.report.report_page import as_html
from sss_ref.validation.scope import QUICK

F = np.float32
MISTAKES = {
    "phong": {"phong.shininess": 20.0},
    "translucency": {"translucency.exponent": 0.751},
    "thickness": {"lights": [{"position": [2.0, 1.5, 2.6]}]},
    "scattered": {"blur.pixel_scale": 1.5},
}


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    body = written(tmp_path_factory.mktemp("bodies") / "sphere.obj", *sphere(12))
    sizes = {"width": 32, "height": 32}
    return around(body, 32, preset="robust", method="screen_space", shadow_map={**sizes, "test": "slope"})


@pytest.fixture(scope="module")
def oracle(scene):
    return render(load_scene(scene), "arrays")


def mistaken(oracle, scene, name):
    """The oracle's buffers but for one, which a wrong stage wrote."""
    return dict(oracle.buffers) | {name: render(load_scene(scene, **MISTAKES[name]), "arrays")[name]}


def rows_of(report):
    return {row.text: row for row in report.finding.section.rows}


@pytest.mark.parametrize("name", MISTAKES)
def test_what_was_drawn_stands_below_beside_where_it_may_lie(oracle, scene, name):
    buffers = mistaken(oracle, scene, name)
    report = sss_ref.validate(oracle, buffers, explain=QUICK)
    assert report.culprit.buffer == name
    column, row = report.culprit.worst.at
    drawn = report.finding.section.rows[-1]
    assert (drawn.kind, drawn.text, drawn.value) == ("got", f"{name}, as drawn", report.culprit.worst.got)
    got, expected = (np.atleast_1d(held[name][row, column]) for held in (buffers, oracle))
    low, high = (np.array(components(end)) for end in drawn.bounds)
    reach = np.atleast_1d(report.finding.check.reach[row, column])
    assert (low == (expected - reach).astype(F)).all() and (high == (expected + reach).astype(F)).all()
    assert not ((low <= got) & (got <= high)).all()


def test_inputs_have_the_intervals_that_their_storage_leaves(oracle, scene):
    """Half precision leaves 11 bits of what the stage got; a texture is what it holds, and uniforms are exact."""
    buffers = mistaken(oracle, scene, "phong")
    buffers["normal_world"] = buffers["normal_world"].astype(np.float16).astype(F)
    report = sss_ref.validate(oracle, buffers, {"normal_world": "float16"}, explain=QUICK)
    rows, (column, row) = rows_of(report), report.culprit.worst.at
    assert rows["position_world"].may_be == rows["shininess"].may_be == "exact"
    low, high = (np.array(components(end)) for end in rows["normal_world"].bounds)
    exact = oracle["normal_world"][row, column]
    assert (low <= exact).all() and (exact <= high).all()
    assert 2.0**-12 <= (high - low).max() <= 2.0**-9  # of numbers below 1


def test_varyings_have_the_intervals_of_their_interpolation(oracle, scene):
    buffers = {"normal_world": -oracle["normal_world"], "triangle": oracle["triangle"]}
    rows = rows_of(sss_ref.validate(oracle, buffers, explain=QUICK))
    assert {rows[name].may_be[:2] for name in ("fragment_position", "fragment_normal")} == {"(["}


def test_on_the_page_in_the_terminal_and_as_data(oracle, scene, capsys):
    report = sss_ref.validate(oracle, mistaken(oracle, scene, "translucency"), explain=QUICK)
    term = "term = pow(x, y) / pow(max(thickness, d_min), exponent)"
    shown = rows_of(report)[term].may_be
    assert shown.startswith("[")
    page = as_html(report, "title")
    assert "<th>may be</th>" in page and f"<td class='may-be'>{shown}</td>" in page
    print_report(report)
    printed = capsys.readouterr().out
    assert "stage translucency_ratio_throughout at the worst pixel" in printed and shown in printed
    assert f"translucency, as drawn {report.culprit.worst.got}" in " ".join(printed.split())
    (line,) = (line for line in as_json(report)["worst_lines"] if line["text"] == term)
    assert f"[{line['low']}, {line['high']}]" == shown
    assert float(line["low"]) < float(line["value"]) < float(line["high"])


def test_what_has_no_interval_and_a_run_that_passes(oracle, scene):
    lines = as_json(sss_ref.validate(oracle, mistaken(oracle, scene, "scattered"), explain=QUICK))["worst_lines"]
    assert {"text": "lit", "value": "32 x 32 texels", "low": None, "high": None} in lines
    assert as_json(sss_ref.validate(oracle, oracle.buffers, explain=QUICK))["worst_lines"] == []
