"""Where wrong pixels lie: put there on purpose, they are found there."""

import numpy as np
import pytest
from scenes import around, sphere, two_slabs, written

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate
from sss_ref.validation.verdict.clusters import Whereabouts, Zone, _sentence, _varies


def rendered(path, method="screen_space"):
    return render(load_scene(around(path, 64, method=method, irradiance_map={"width": 64, "height": 64})), "arrays")


@pytest.fixture(scope="module")
def slabs(tmp_path_factory):
    return rendered(written(tmp_path_factory.mktemp("slabs") / "slabs.obj", *two_slabs()))


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    return rendered(written(tmp_path_factory.mktemp("ball") / "ball.obj", *sphere(6)), "texture_space")


def naive_varies(values):
    """Whether one of the 8 neighbours of a pixel is another."""
    rows, columns = values.shape
    found = np.zeros(values.shape, bool)
    for row, column in np.ndindex(values.shape):
        around_it = values[max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2]
        found[row, column] = (around_it != values[row, column]).any()
    assert found.shape == (rows, columns)
    return found


def wrong_where(oracle, chosen, buffer="phong"):
    """What is said of a buffer that is wrong at these pixels."""
    got = oracle[buffer].copy()
    got[chosen] += 1
    return validate(oracle, {buffer: got}, explain=False)


def test_triangles_of_a_pass_and_of_those_that_follow_it(slabs, ball):
    assert np.array_equal(Whereabouts(slabs, {}).triangles("camera"), slabs["triangle"])
    assert np.array_equal(Whereabouts(slabs, {}).triangles("blur"), slabs["triangle"])
    assert np.array_equal(Whereabouts(slabs, {}).triangles("shadow_map"), slabs["light_triangle"])
    layout = Whereabouts(ball, {}).triangles("irradiance_map" if "irradiance_map" in ball.timings else "irradiance")
    assert np.array_equal(layout >= 0, ball["irradiance_mask"] != 0)


def test_zones_are_those_of_a_naive_loop(slabs):
    triangles, lit = slabs["triangle"], slabs["directly_lit"] != 0
    covered = triangles >= 0
    outline, edges = naive_varies(covered), naive_varies(triangles)
    wrong = covered & (np.random.default_rng(4).random(covered.shape) < 0.3)
    expected = {
        "where nothing is drawn": ~covered,
        "at the outline": outline,
        "at triangle edges inside": edges & ~outline,
        "where directly_lit changes": naive_varies(lit) & ~outline,
        "where directly_lit is 0": covered & ~lit,
        "where directly_lit is 1": lit,
    }
    found = Whereabouts(slabs, {}).clusters("camera", covered, wrong)
    counted = {zone.name: (zone.wrong, zone.compared) for zone in found.zones}
    assert counted == {
        name: (int((zone & wrong).sum()), int((zone & covered).sum())) for name, zone in expected.items()
    }
    assert "lie in no particular kind of place" in found.sentence


def test_at_triangle_edges(slabs):
    covered = slabs["triangle"] >= 0
    edges = covered & naive_varies(slabs["triangle"]) & ~naive_varies(covered)
    found = wrong_where(slabs, edges).culprit
    share = edges.sum() / covered.sum()
    assert found.clusters.sentence == (
        f"100% of the wrong pixels lie at triangle edges inside, as {share:.1%} of all do"
    )


def test_at_the_outline(slabs):
    covered = slabs["triangle"] >= 0
    found = wrong_where(slabs, covered & naive_varies(covered)).culprit
    assert found.clusters.sentence.startswith("100% of the wrong pixels lie at the outline, as ")


def test_nothing_is_drawn_in_most_of_the_picture_and_wrong_is_just_that():
    """It would not stand out as the place of twice as many; with one pixel more it does not."""
    where, wrong = np.ones((10, 10), bool), np.zeros((10, 10), bool)
    wrong[:8] = True
    for right, told in ((80, "lie where nothing is drawn, as 80.0% of all do"), (81, "in no particular kind of place")):
        zones = (Zone("where nothing is drawn", 80, right), Zone("at the outline", 0, 20))
        assert told in _sentence(zones, np.arange(100).reshape(10, 10), where, wrong)


def test_on_one_triangle(slabs):
    ids, counts = np.unique(slabs["triangle"][slabs["triangle"] >= 0], return_counts=True)
    one = ids[counts.argmin()]
    found = wrong_where(slabs, slabs["triangle"] == one)
    assert found.culprit.clusters.sentence == f"100% of the wrong pixels lie on triangle {one}"
    assert found.culprit.first.triangles == (one,) and found.culprit.worst.triangles == (one,)


def test_of_two_zones_that_stand_out_alike_the_first_is_named():
    zones = (Zone("at the outline", 5, 10), Zone("in shadow", 5, 10))
    where, wrong = np.ones((10, 10), bool), np.zeros((10, 10), bool)
    wrong[0, :5] = True
    told = _sentence(zones, np.arange(100).reshape(10, 10), where, wrong)
    assert told == "100% of the wrong pixels lie at the outline, as 10.0% of all do"


def test_everywhere(slabs):
    found = wrong_where(slabs, slabs["triangle"] >= 0)
    assert found.culprit.clusters.sentence == "wrong everywhere: 100% of the pixels compared"


def test_borders_of_the_layout(ball):
    mask = ball["irradiance_mask"] != 0
    found = wrong_where(ball, mask & naive_varies(mask), "irradiance").culprit
    assert "lie at the borders of the UV layout, as" in found.clusters.sentence


def test_first_and_worst_pixel(slabs):
    """First is the lowest row, then the leftmost column; worst is the one that lies farthest off."""
    covered = np.argwhere(slabs["triangle"] >= 0)
    chosen = covered[[10, 20, 30, 40, 50, 60]]
    got = slabs["phong"].copy()
    got[tuple(chosen.T)] += np.arange(1, 7, dtype=np.float32)[[0, 1, 5, 2, 3, 4], None]
    found = validate(slabs, {"phong": got}, explain=False)
    first, worst = found.culprit.first, found.culprit.worst
    assert first.at == tuple(chosen[0][::-1]) and worst.at == tuple(chosen[2][::-1])
    assert worst.triangles == (slabs["triangle"][tuple(chosen[2])],)
    assert worst.ulps > 2**20 and worst.widths > 2**10 and first.ulps < worst.ulps
    assert found.details[0].startswith(f"first at pixel {first.at[0]},{first.at[1]} (triangle {first.triangles[0]}): ")


def test_both_triangles_where_they_differ(slabs):
    covered = np.argwhere(slabs["triangle"] >= 0)
    row, column = covered[len(covered) // 2]
    other = slabs["triangle"].copy()
    other[row - 1 : row + 2, column - 1 : column + 2] = 99
    found = validate(slabs, {"triangle": other}, explain=False).culprit
    ours = slabs["triangle"][found.first.at[1], found.first.at[0]]
    assert found.first.triangles == (ours, 99)
    assert ("no triangle" if ours < 0 else f"triangle {ours}") + " or triangle 99" in str(found.first)


def sentence(wrong, zones=(), triangles=None):
    """What is said of 100 pixels of which so many are wrong, each of a triangle of its own if none are given."""
    where, are_wrong = np.ones((10, 10), bool), (np.arange(100) < wrong).reshape(10, 10)
    triangles = np.arange(100) if triangles is None else np.array(triangles)
    return _sentence(zones, triangles.reshape(10, 10), where, are_wrong)


def test_wrong_everywhere_begins_at_nine_of_ten():
    assert sentence(90) == "wrong everywhere: 90% of the pixels compared"
    assert sentence(89) == "the wrong pixels, 89.0% of those compared, lie in no particular kind of place"


@pytest.mark.parametrize(
    ("wrong", "on_it", "of_it", "told"),
    [
        (20, 18, 49, "90% of the wrong pixels lie on triangle 7"),
        (20, 17, 49, None),  # fewer than nine of ten of the wrong ones
        (20, 18, 50, None),  # it is half of all
        (20, 20, 20, "100% of the wrong pixels lie on triangle 7"),
    ],
)
def test_one_triangle_holds_nine_of_ten_and_is_less_than_half(wrong, on_it, of_it, told):
    triangles = [*[7] * on_it, *range(1000, 1000 + wrong - on_it), *[7] * (of_it - on_it)]
    triangles += range(2000, 2100 - len(triangles))
    said = sentence(wrong, triangles=triangles)
    assert said == told if told else "in no particular kind of place" in said


def test_what_is_no_triangle_is_none():
    assert "in no particular kind of place" in sentence(20, triangles=[-1] * 20 + [*range(80)])
    assert sentence(20, triangles=[0] * 20 + [*range(1, 81)]) == "100% of the wrong pixels lie on triangle 0"


@pytest.mark.parametrize(
    ("wrong", "zone", "stands_out"),
    [
        (10, Zone("in shadow", 6, 30), True),  # six of ten, and twice as often
        (10, Zone("in shadow", 5, 10), False),
        (10, Zone("in shadow", 6, 31), False),
        (10, Zone("in shadow", 0, 0), False),
        (80, Zone("in shadow", 80, 80), True),
        (80, Zone("in shadow", 79, 79), False),
        (80, Zone("in shadow", 80, 81), False),
    ],
)
def test_a_zone_stands_out_with_most_of_the_wrong_pixels_and_few_of_all(wrong, zone, stands_out):
    share = f"{zone.wrong / wrong:.0%} of the wrong pixels lie in shadow, as {zone.compared}.0% of all do"
    said = sentence(wrong, (zone,))
    assert said == share if stands_out else "in no particular kind of place" in said


def test_of_zones_the_one_that_stands_out_most_is_named():
    zones = Zone("at the outline", 8, 20), Zone("in shadow", 7, 10), Zone("where lit is 1", 9, 30)
    assert sentence(10, zones) == "70% of the wrong pixels lie in shadow, as 10.0% of all do"


def test_a_pixel_varies_with_any_of_its_eight_neighbours():
    for row, column in np.ndindex(3, 3):
        values = np.zeros((3, 3), int)
        values[row, column] = 1
        assert _varies(values)[1, 1] and np.array_equal(_varies(values), naive_varies(values))
    assert not _varies(np.ones((1, 1), int)).any()
