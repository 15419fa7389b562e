"""A verdict says of how much of the picture it is one."""

from dataclasses import replace

import numpy as np
import pytest
from scenes import around, two_slabs, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.numerics.bounded import Bounded
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.accept.sparing import NEEDED, SAMPLED
from sss_ref.validation.stage_by_stage import validate
from sss_ref.validation.verdict.background import Background
from sss_ref.validation.verdict.verdict import Verdict, WrongPixel, judged


@pytest.fixture(scope="module")
def oracle(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("mesh") / "slabs.obj", *two_slabs())
    return render(load_scene(around(path, 32)), interpreter="arrays")


def test_fragments_that_show_another_triangle_are_not_compared_and_count_as_such(oracle):
    triangle = oracle["triangle"].copy()
    drawn = triangle >= 0
    drawn[:, :16] = False
    triangle[drawn] += 1
    report = validate(oracle, {**oracle.buffers, "triangle": triangle}, profile="ieee", explain=False)
    (thickness,) = (verdict for verdict in report.verdicts if verdict.buffer == "thickness")
    whole = int((oracle["triangle"] >= 0).sum())
    assert (thickness.comparable, thickness.compared) == (whole, whole - int(drawn.sum()))
    assert thickness.decided == thickness.compared / whole < 0.9


def test_a_pass_over_part_of_the_pixels_does_not_read_like_a_whole_one(oracle):
    report = validate(oracle, oracle.buffers, explain=False)
    assert report.summary == f"pass: {len(report.verdicts)} buffers, every stage gives what it should"
    first, second, *others = report.verdicts
    part = replace(second, comparable=4 * second.compared)
    told = replace(report, verdicts=(first, part, *others)).summary
    assert told.startswith(f"pass as far as was judged, 25% of the pixels of {second.buffer}: ")


def test_pixels_of_which_nothing_can_be_said_are_not_judged(oracle):
    report = validate(oracle, oracle.buffers, explain=False)
    verdict = report.verdicts[-1]
    assert verdict.decided == 1
    assert replace(verdict, unbounded=verdict.compared // 2).decided == pytest.approx(0.5, abs=0.01)


@pytest.mark.parametrize(
    ("relative", "told"),
    [
        (0.003, "pass as far as was judged, 82% of the pixels of scattered: "),
        (0.02, "empty: no pixel that can be judged"),
    ],
)
def test_a_picture_alone_of_which_any_number_may_be_right_does_not_pass(oracle, relative, told):
    """A fragment shader so coarse that at some pixels, or all, the whole way to the picture bounds nothing."""
    coarse = replace(PROFILES["vulkan"], arithmetic=Bounded(relative=relative), vertex_arithmetic=Bounded())
    alone = {"scattered": oracle["scattered"]}
    found = validate(oracle, alone, profile=coarse, explain=False)
    assert found.summary.startswith(told) and found.passed is (relative < 0.01)
    assert validate(oracle, alone, explain=False).passed


def test_a_pass_that_lets_much_of_the_range_pass_says_so_and_what_would_narrow_it(oracle):
    """Numbers of 11 bits bound little on the way from mesh to picture; those of 24 much, with all buffers or not."""
    alone = {"image": oracle["image"]}
    found = validate(oracle, alone, profile="mediump", explain=False)
    (verdict,) = found.verdicts
    assert found.passed and verdict.loose and 0.1 <= verdict.passing < 1
    assert verdict.narrowing == ("coverage", "scattered")
    told = f"; image: bounds so wide that {verdict.passing:.0%} of its range passes; dump coverage, scattered to narrow"
    assert found.summary.endswith(told)
    for narrow in (alone, oracle.buffers):
        report = validate(oracle, narrow, explain=False)
        assert report.summary == f"pass: {len(narrow)} buffers, every stage gives what it should"


def verdict_of(**changed):
    """A verdict on 100 pixels, all of which are right beyond doubt, but for what is changed."""
    given = dict.fromkeys(("compared", "equal", "within", "bounded"), 100)
    given |= dict.fromkeys(("ambiguous", "unbounded", "undefined"), 0)
    return Verdict("pass", "stage", "lit", ulps=(), widths=None, **(given | changed))


def test_pixels_are_counted_once_each():
    verdict = verdict_of(within=70, ambiguous=20, unbounded=10, undefined=5)
    assert verdict.outcomes == (40, 20, 25, 5, 10) and verdict.failed and not verdict.passed and not verdict.empty
    assert verdict.decided == 0.85
    assert replace(verdict, comparable=200).decided == 85 / 200 and verdict_of(compared=0, within=0).decided == 0


@pytest.mark.parametrize(
    ("changed", "empty", "passed"),
    [
        ({}, False, True),
        ({"unbounded": 99}, False, True),
        ({"unbounded": 100}, True, False),
        ({"unbounded": 60, "undefined": 40, "within": 60}, True, False),
        ({"unbounded": 60, "undefined": 39, "within": 60}, False, False),
        ({"compared": 0, "within": 0}, True, False),
        ({"within": 99}, False, False),
        ({"background": Background(1, 1, "0", "1", (0, 0), True)}, False, False),
        ({"unbounded": 100, "background": Background(1, 1, "0", "1", (0, 0), True)}, False, False),
    ],
)
def test_what_passes_and_what_is_empty(changed, empty, passed):
    verdict = verdict_of(**changed)
    assert (verdict.empty, verdict.passed) == (empty, passed)


@pytest.mark.parametrize(("passing", "loose"), [(0.1, True), (0.0999, False)])
def test_a_tenth_of_the_range_is_loose(passing, loose):
    assert verdict_of(passing=passing).loose is loose


@pytest.mark.parametrize(
    ("changed", "inherits"),
    [({}, False), ({"chained": 100}, False), ({"chained": 99}, True), ({"chained": 99, "within": 99}, False)],
)
def test_a_right_stage_may_inherit_what_is_wrong(changed, inherits):
    assert verdict_of(**changed).inherits is inherits


def test_outcomes_are_estimates_where_some_were_not_bounded():
    none = (False,) * 5
    assert verdict_of(ambiguous=1).estimated == none and verdict_of(bounded=99).estimated == none
    some = (True, True, False, False, True)
    assert verdict_of(bounded=99, ambiguous=1).estimated == some == verdict_of(bounded=99, unbounded=1).estimated


def test_a_wrong_pixel_in_words():
    pixel = WrongPixel((3, 5), "1.5", "1.0", (-1, 0, 7), 2.0, 1.0)
    assert str(pixel) == "at pixel 3,5 (no triangle or triangle 0 or triangle 7): 1.5, expected 1.0"


class Anywhere:
    """Says which pixels it was asked for; stands for `Whereabouts`."""

    def at(self, pass_name, pixel):
        return (*pixel, 7)

    def clusters(self, pass_name, where, wrong):
        return pass_name, where.tolist(), wrong.tolist()


ULP = 2.0**-23  # of 1
WHERE = np.array([[False, True, True, True], [True, True, True, False]])
EXPECTED = np.float32([[[9, 9], [1, 0.5], [1, 0.5], [1, 0.5]], [[1, 0.5], [1, 0.5], [np.inf, 1], [9, 9]]])
REACH = np.array([[[0, 0], [0, 0], [0, 0], [ULP, 0]], [[0, 0], [4 * ULP, ULP], [0, 0], [0, 0]]])


def check_of(**changed):
    """Six compared pixels of eight: one is right, and so is one an ULP off; three are wrong, one is undefined."""
    got = EXPECTED.copy()
    got[0, 2] += np.float32([2 * ULP, 0])
    got[0, 3] += np.float32([ULP, 0])
    got[1, 0] += np.float32([0, 3 * ULP])  # 6 of its own
    got[1, 1] += np.float32([-12 * ULP, 2 * ULP])
    got[~WHERE] = 0
    return Check(
        "camera", "shading", "lit", **({"where": WHERE, "expected": EXPECTED, "got": got, "reach": REACH} | changed)
    )


def test_a_verdict_counts_pixels_and_values():
    found = judged(check_of(fragments=np.ones((2, 4), bool)), Anywhere())
    assert (found.pass_name, found.stage, found.buffer) == ("camera", "shading", "lit")
    assert (found.compared, found.comparable, found.bounded) == (6, 8, 6)
    assert (found.equal, found.within, found.undefined, found.failing) == (2, 2, 1, 3)
    assert (found.ambiguous, found.unbounded, found.certain) == (0, 0, 2)
    # 12 values: 7 as they should be, then of those off by 1; 2; 4 and 6; 12 (24 of those below 1)
    assert found.ulps == (7, 1, 1, 2, 1, 0, 0) and sum(found.ulps) == 12


def test_the_first_wrong_pixel_goes_by_rows_and_the_worst_by_its_distance():
    found = judged(check_of(), Anywhere())
    assert found.first.at == (2, 0) and found.worst.at == (1, 1)
    assert (found.first.triangles, found.worst.triangles) == ((2, 0, 7), (1, 1, 7))
    assert found.first.got == "(1.0000002, 0.5)" and found.first.expected == "(1.0, 0.5)"
    assert (found.first.ulps, found.first.widths) == (2, np.inf)
    assert (found.worst.ulps, found.worst.widths) == (8, 1)  # 12 less 4, of an interval of 8; 2 less 1 beside it


def test_a_pixel_beyond_its_reach_in_one_channel_is_as_wide_of_it_as_that_channel():
    reach = REACH.copy()
    reach[1, 0] = (0, 2 * ULP)
    found = judged(check_of(reach=reach, where=np.array([[False] * 4, [True, False, False, False]])), Anywhere())
    assert (found.compared, found.first.at, found.first.ulps, found.first.widths) == (1, (0, 1), 1, 0.25)


def test_its_clusters_are_of_the_compared_pixels_and_the_wrong_ones():
    wrong = [[False, False, True, False], [True, True, False, False]]
    assert judged(check_of(), Anywhere()).clusters == ("camera", WHERE.tolist(), wrong)
    right = judged(check_of(got=EXPECTED), Anywhere())
    assert right.clusters is right.first is right.worst is None


def test_what_is_no_number_is_infinitely_far_off():
    got = EXPECTED.copy()
    got[1, 0, 1] = np.nan
    found = judged(check_of(got=got), Anywhere())
    assert found.worst.at == (0, 1) and (found.worst.ulps, found.worst.widths) == (np.inf, np.inf)


def test_what_is_let_pass_is_told_of_the_sample():
    """Of two sampled pixels one lets 2 of 4 pass; that of the spared ones is not known."""
    expected = np.float32([[4, 2, 4, 4]])
    check = Check("camera", "shading", "lit", np.ones((1, 4), bool), expected, expected, np.array([[0, 1.0, 9, 9]]))
    found = judged(replace(check, bounded=np.uint8([[SAMPLED, SAMPLED, 0, NEEDED]])), Anywhere())
    assert found.passing == 0.25 and sum(found.widths.counts) == 2 and found.bounded == 3
    whole = judged(replace(check, reach=np.zeros((1, 4))), Anywhere())
    assert whole.passing == 0 and whole.widths.counts == (4, 0, 0, 0, 0, 0, 0, 0) and whole.bounded == 4


def test_without_any_doubt_nothing_of_a_verdict_is_let_pass():
    plain = verdict_of()
    assert (plain.comparable, plain.passing, plain.loose, plain.failed) == (0, 0, False, False)
    assert Verdict("pass", "stage", "lit", *[100] * 3, *[0] * 3, (), None).bounded == 0


def test_of_a_single_pixel_all_is_decided():
    assert verdict_of(compared=1, within=1).decided == 1
