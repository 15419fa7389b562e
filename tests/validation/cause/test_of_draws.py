"""Kinds of explanations of a draw, from tries that are made up: which are tried, and how well they fit."""

from types import SimpleNamespace

import numpy as np
import pytest
from checked import check_of

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.validation.accept.rebased import RASTERIZER
from sss_ref.validation.cause import of_draws as module
from sss_ref.validation.cause.hypothesis import INPUT, MUTANT, NUMBER, SETTING, SOURCE, STATE, Charge
from sss_ref.validation.cause.lying_off import LyingOff
from sss_ref.validation.cause.puzzle import Puzzle
from sss_ref.validation.clock import Limit

WRONG = [True, True, True, True, False, False, False, False, False]  # of nine pixels in a row, the last is not compared
WHERE = np.array([[True] * 8 + [False]])


def puzzle(buffer="light_distance", stage="distance_to_light", visible=None, numbers=None, vertex=()):
    """What was got is 1 to 9, and 9 more than it should be where it is wrong."""
    got = np.arange(1.0, 10)[None] if numbers is None else np.array([numbers])
    check = check_of(got - 9 * np.array([WRONG]), got, buffer=buffer, stage=stage, where=WHERE)
    draw = SimpleNamespace(depth="light_depth", vertex_stages=vertex)
    drawn = SimpleNamespace(this_pass=SimpleNamespace(draw=draw), visible=visible)
    return Puzzle(SimpleNamespace(profile=PROFILES["vulkan"]), check, drawn, {}, Limit(60))


def right_at(todo, *pixels, off=0.0):
    """A picture that is as it was got at these pixels, or off by so much, and another elsewhere."""
    drawn = todo.check.got + 5
    drawn[0, list(pixels)] = todo.check.got[0, list(pixels)] + off
    return drawn.astype(np.float32)


@pytest.fixture
def nothing_tried(monkeypatch):
    """All kinds of tries, of which there are none."""
    for name in ("lying_off", "redrawings", "mishaps", "cropped", "vertex_stages", "undrawn"):
        monkeypatch.setattr(module, name, lambda *_: iter(()))
    return monkeypatch


def fits(found):
    return [(each.text, each.share, each.kept, each.rank, each.blames) for each in found]


def test_draws_done_otherwise(nothing_tried):
    todo = puzzle()
    tried = [
        (Charge("zoomed", INPUT), NUMBER, lambda: right_at(todo, 0, 1, 2, 4, 5, 8)),
        (Charge("culled", SETTING), STATE, lambda: right_at(todo, 3, 8)),
    ]
    nothing_tried.setattr(module, "redrawings", lambda redrawing: iter(tried))
    assert fits(module.of_draws(todo)) == [
        ("zoomed", 0.75, 0.5, NUMBER, INPUT),
        ("culled", 0.25, 0, STATE, SETTING),
    ]


@pytest.mark.parametrize(
    ("buffer", "off", "share"),
    [
        ("light_depth", 2.0**-14, 1),
        ("light_depth", -(2.0**-14), 1),
        ("light_depth", 2.0**-13, 0),
        ("other", 2.0**-14, 0),
    ],
)
def test_depths_may_be_a_little_off(nothing_tried, buffer, off, share):
    todo = puzzle(buffer, numbers=np.arange(1, 10) / 16)
    tried = [(Charge("zoomed", INPUT), NUMBER, lambda: right_at(todo, *range(8), off=off))]
    nothing_tried.setattr(module, "redrawings", lambda redrawing: iter(tried))
    (found,) = module.of_draws(todo)
    assert (found.share, found.kept) == (share, share)


@pytest.mark.parametrize(
    ("stage", "visible", "told"), [(RASTERIZER, "seen", True), (RASTERIZER, None, False), ("shade", "seen", False)]
)
def test_mishaps_befall_what_the_rasterizer_wrote(nothing_tried, stage, visible, told):
    same = np.array([[True, True, False, False, True, False, False, False, False]])
    nothing_tried.setattr(module, "mishaps", lambda visible, buffer, got: iter([(f"{visible} {buffer}", same)]))
    found = fits(module.of_draws(puzzle("triangle", stage, visible)))
    assert found == ([("seen triangle", 0.5, 0.25, STATE, SETTING)] if told else [])


def test_what_cuts_a_draw_off_comes_last_and_only_if_nothing_fits(nothing_tried):
    todo = puzzle()
    everywhere, some = np.ones((1, 9), bool), np.array([[True] * 3 + [False] * 6])
    nothing_tried.setattr(module, "cropped", lambda case, check, limit: iter([(Charge("a scissor", SETTING), some)]))
    assert fits(module.of_draws(todo)) == [("a scissor", 0.75, 0, STATE, SETTING)]
    tried = [(Charge("zoomed", INPUT), NUMBER, lambda: todo.check.got)]
    nothing_tried.setattr(module, "redrawings", lambda redrawing: iter(tried))
    assert [each.text for each in module.of_draws(todo)] == ["zoomed"] and everywhere.all()


def off_by(todo, monkeypatch, likely, right, where=WHERE):
    """What is told of an offset that explains some pixels as drawn, and some where it is judged with all its snaps."""
    judged = []

    def judge(uniforms, profile):
        judged.append((uniforms, profile.snap))
        return check_of(right_at(todo, *right), todo.check.got, where=where)

    redrawing = SimpleNamespace(draw=lambda uniforms: right_at(todo, *likely), judged=judge)
    monkeypatch.setattr(module, "_redrawing", lambda _: redrawing)
    found = LyingOff(Charge("it lies off", SETTING), {"matrix": 1}, NUMBER)
    monkeypatch.setattr(module, "lying_off", lambda draw, limit: iter([found]))
    return fits(module.of_draws(todo)), judged


def test_an_offset_that_may_be_it_is_judged_wherever_its_corners_snap(nothing_tried):
    told, judged = off_by(puzzle(), nothing_tried, (0, 1, 4, 5), (0, 1, 2, 4, 5, 6, 8))
    assert told == [("it lies off", 0.75, 0.75, NUMBER, SETTING)] and judged == [({"matrix": 1}, "any")]


@pytest.mark.parametrize(("likely", "told"), [((0, 4), 0), ((0, 1, 4), 0), ((0, 4, 5), 0), ((0, 1, 4, 5), 1)])
def test_one_that_explains_less_than_three_of_ten_of_either_is_not(nothing_tried, likely, told):
    assert len(off_by(puzzle(), nothing_tried, likely, ())[1]) == told


def test_exactly_three_of_ten_are_enough(nothing_tried):
    nothing_tried.setattr(module, "LIKELY", 0.25)  # of four pixels
    assert len(off_by(puzzle(), nothing_tried, (0, 4), ())[1]) == 1 and module.LIKELY == 0.25


def test_an_offset_counts_on_pixels_that_are_compared_with_it_and_without(nothing_tried):
    where = np.array([[True, False, True, False, True, True, False, False, True]])
    told, _ = off_by(puzzle(), nothing_tried, (0, 1, 4, 5), (0, 4), where)
    assert told == [("it lies off", 0.5, 0.5, NUMBER, SETTING)]


def test_mistakes_in_the_vertex_stage_that_draw_the_same_are_one(nothing_tried):
    todo = puzzle(vertex=("mesh_vertex",))
    pictures = {"first": right_at(todo, 0, 1, 4), "second": right_at(todo, 3), "third": right_at(todo, 0, 1, 4)}
    stages = [(Charge(name, SOURCE), name) for name in pictures]
    nothing_tried.setattr(module, "vertex_stages", lambda vertex: iter(stages) if vertex == "mesh_vertex" else None)
    drawing = SimpleNamespace(with_vertex=lambda name: SimpleNamespace(draw=lambda: pictures[name]))
    drawing.this_pass = todo.drawn.this_pass
    nothing_tried.setattr(module, "_redrawing", lambda _: drawing)
    empty = np.array([[False, True, True, True, True, False, False, False, True]])
    nothing_tried.setattr(module, "undrawn", lambda case, check: iter([(Charge("nothing is drawn", SETTING), empty)]))
    assert fits(module.of_vertices(todo)) == [
        ("first, or third", 0.5, 0.25, MUTANT, SOURCE),
        ("second", 0.25, 0, MUTANT, SOURCE),
        ("nothing is drawn", 0.75, 0.25, MUTANT, SETTING),
    ]


def test_wrong_pixels_are_compared_ones_out_of_reach():
    todo = puzzle()
    assert todo.wrong.tolist() == [WRONG]
    holds = np.array([[True, False, False, False, True, True, True, False, True]])
    assert todo.fit(holds) == (0.25, 0.75)
