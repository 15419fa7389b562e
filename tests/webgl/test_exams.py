"""Exams without a browser: the reference's own inputs give its own outputs, and these are right."""

import numpy as np
import pytest
from judging import small

from sss_ref.interpret.work import store
from sss_ref.rendering.fold import render
from sss_ref.webgl import planting
from sss_ref.webgl.allowed import BACKGROUND, NOT_COMPARED
from sss_ref.webgl.exam_of_draw import exam_of_draw
from sss_ref.webgl.exams import every_value, exams
from sss_ref.webgl.planting import wrong_lines, wrong_vertex_lines
from sss_ref.webgl.reference_draw import reference_draw
from sss_ref.webgl.varyings_shader import DEPTH, TRIANGLE, varyings_draws


@pytest.fixture(scope="module", params=["teaching", "lesson_seam"])
def oracle(request):
    scene = small(request.param, 24)
    return render(scene, "arrays", threads=1, keep=every_value(scene))


def passes(oracle):
    return [each for each in oracle.scene.method.passes if not each.on_demand]


def drawing_meshes(oracle):
    return [each for each in passes(oracle) if each.draw.vertex_stages]


def test_every_stage_that_runs_has_an_exam(oracle):
    found = [(each.of.name, each.stage.name) for one in passes(oracle) for each in exams(oracle, one)]
    expected = [(one.name, stage.name) for one in passes(oracle) if one.rounds for stage in one.stages]
    assert found == expected and len(found) > 10


def test_a_stage_gives_the_reference_from_its_inputs_and_that_is_right(oracle):
    for exam in (each for one in passes(oracle) if one.rounds == 1 for each in exams(oracle, one)):
        results = exam.stage.run(exam.inputs(oracle.scene.uniforms))
        for name, right in exam.right.items():
            again = right.middle.copy()
            store(again, *np.nonzero(exam.where), results[name])
            assert np.array_equal(again, oracle[name], equal_nan=True), name
            assert ((right.low <= right.middle) & (right.middle <= right.high))[exam.where].all()
            assert np.array_equal(right.low[~exam.where], right.high[~exam.where], equal_nan=True)
            beside = right.state[~exam.where]
            assert np.isin(beside, [BACKGROUND if exam.alone.draw.stencil else NOT_COMPARED]).all()


def test_a_draw_shows_what_the_reference_does_within_its_bounds(oracle):
    """The reference snaps to 8 bits and the bounds are for 4: it is one of those that they allow."""
    for one in drawing_meshes(oracle):
        exam, drawn = exam_of_draw(oracle, one), reference_draw(oracle, one)
        triangle = drawn.written[TRIANGLE].reshape(-1)
        assert np.array_equal(drawn.written[TRIANGLE] != -1, drawn.where) and triangle.min() == -1
        assert len(exam.first) == len(triangle) + 1 and exam.first[-1] == len(exam.triangle)
        for pixel in np.flatnonzero(triangle >= 0):
            of_pixel = slice(exam.first[pixel], exam.first[pixel + 1])
            same = np.flatnonzero(exam.triangle[of_pixel] == triangle[pixel]) + of_pixel.start
            values = np.concatenate([np.atleast_1d(each.reshape(len(triangle), -1)[pixel]) for each in columns(drawn)])
            skipped = exam.low.shape[1] - len(values)  # a layout has no depth
            low, high = exam.low[same, skipped:], exam.high[same, skipped:]
            assert ((low <= values) & (values <= high)).all(axis=1).any()


def columns(drawn):
    return [*([drawn.written[DEPTH]] if DEPTH in drawn.written else []), *drawn.varyings.values()]


def test_no_draw_of_varyings_has_more_outputs_than_every_device(oracle):
    for one in drawing_meshes(oracle):
        names = list(exam_of_draw(oracle, one).varyings)
        draws = varyings_draws(one, names)
        outputs = [name for each in draws for name in each["outputs"]]
        assert all(len(each["outputs"]) <= 4 for each in draws) and set(names) <= set(outputs)
        assert (DEPTH in outputs) is not one.draw.layout
        assert all(next(iter(each["outputs"])).startswith(TRIANGLE) for each in draws)


def test_planted_lines_are_one_line_each_and_seen(oracle):
    (exam,) = (each for one in passes(oracle) for each in exams(oracle, one) if each.stage.name == "phong_shading")
    shader = {"right": "a\nb\nc", "wrong": "a\nB\nc"}
    found = wrong_lines(exam, oracle.scene.uniforms, lambda stage: shader["right" if stage is exam.stage else "wrong"])
    assert [(each.line, each.text) for each in found] == [(2, "B")]
    shader["wrong"] = "A\nB\nc"
    assert (
        wrong_lines(exam, oracle.scene.uniforms, lambda stage: shader["right" if stage is exam.stage else "wrong"])
        == []
    )


def test_planted_lines_of_a_vertex_stage_are_of_mutants(oracle):
    for one in drawing_meshes(oracle):
        (stage,), exam = one.draw.vertex_stages, exam_of_draw(oracle, one)
        bodies = []

        def shader(each, bodies=bodies, stage=stage):
            bodies.append(each.body)
            return "right" if each is stage else "wrong"

        found = wrong_vertex_lines(stage, exam.inputs(oracle), list(exam.varyings), shader)
        assert [(each.line, each.text) for each in found] == [(1, "wrong")]
        assert bodies[0] is stage.body and bodies[1] is not stage.body


def test_a_vertex_stage_that_moves_few_vertices_is_not_planted():
    """One of four that moves far is not enough, nor all by a little; numbers they must be."""
    right = [np.array([[0, 0], [1, 0], [0, 1], [1, 1]], float)]
    one, all_of_them = right[0].copy(), right[0] + 0.06
    one[0] += 1
    assert not planting._moves(right, [one]) and planting._moves(right, [all_of_them])
    assert not planting._moves(right, [right[0] + 0.04]) and not planting._moves(right, [right[0] * np.nan])
