"""What a pass hands on and when a stage need not run again, on passes put together by hand."""

from types import SimpleNamespace

import numpy as np
import pytest
from scenes import around, sphere, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language.pipeline import PIXEL
from sss_ref.rendering.result import Result
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.drawn_pass import DrawnPass, _same_bits
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.known import KnownBuffer
from sss_ref.validation.accept.rasterizer.interpolation import interpolation_slack

LIT = np.float32([[1, 2], [3, 4]])


def stage_of(reads=(), writes=()):
    names = {name: name for name in reads}, {name: name for name in writes}
    kinds = dict.fromkeys(writes, float)
    return SimpleNamespace(reads=names[0], writes=names[1], outputs=kinds, run=lambda inputs: "run again")


@pytest.mark.parametrize(
    ("shared", "dumped", "profile", "hands_on"),
    [
        (("a",), ("a",), "vulkan", False),
        (("a",), (), "vulkan", True),
        (("a", "b"), ("a",), "vulkan", True),
        (("a", "b"), ("a", "b", "c"), "vulkan", False),
        (("a",), ("a",), "wgsl", True),
        ((), (), "vulkan", False),
        ((), (), "wgsl", False),
    ],
)
def test_a_stage_hands_bounds_on_that_nobody_dumped(shared, dumped, profile, hands_on):
    drawn = DrawnPass(None, {}, None, Drawing(dict.fromkeys(dumped)), PROFILES[profile], {})
    assert drawn.hands_bounds_on(stage_of(writes=(*shared, "d")), stage_of(reads=(*shared, "e"))) is hands_on


def rectangle(where=None, vertex_stages=(), fed_back=(), draw_reads=(), dumped=None, read=None):
    """A rectangle whose stages read `lit`, and whose oracle has that, `seen` and `coverage`."""
    draw = SimpleNamespace(vertex_stages=vertex_stages, reads=dict.fromkeys(draw_reads))
    this_pass = SimpleNamespace(draw=draw, fed_back=fed_back)
    fragments = SimpleNamespace(where=np.ones((2, 2), bool) if where is None else np.array(where))
    work = SimpleNamespace(this_pass=this_pass, fragments=fragments, uniforms={"count": 1, "lit": 2})
    known = {"lit": KnownBuffer.exactly(LIT.copy() if read is None else read)}
    oracle = {"lit": LIT, "seen": LIT + 10, "coverage": np.ones((2, 2), np.uint8)}
    return DrawnPass(work, known, None, Drawing(dumped or {}), PROFILES["vulkan"], oracle)


AT = np.array([0, 1]), np.array([1, 1])
STAGE = stage_of(reads=("lit", "count", PIXEL), writes=("seen",))


def result(drawn, stage=STAGE, at=AT):
    found = drawn.results(stage, [], at)
    return found if isinstance(found, str) else {name: value.tolist() for name, value in found.items()}


def test_what_read_the_same_as_the_oracle_gave_the_same():
    assert result(rectangle()) == {"seen": [12, 14]}
    same = {"coverage": np.ones((2, 2), np.uint8)}
    assert result(rectangle(draw_reads=("coverage",), dumped=same)) == {"seen": [12, 14]}
    assert result(rectangle(where=[[False, True], [False, True]])) == {"seen": [12, 14]}


@pytest.mark.parametrize(
    "changed",
    [
        {"vertex_stages": ("vertex",)},
        {"fed_back": ("lit",)},
        {"draw_reads": ("coverage",)},
        {"draw_reads": ("coverage",), "dumped": {"coverage": np.zeros((2, 2), np.uint8)}},
        {"read": LIT + 1},
        {"dumped": {"lit": LIT + 1}},
        {"where": [[True, True], [True, False]]},
    ],
)
def test_anything_else_runs_again(changed):
    assert result(rectangle(**changed)) == "run again"


def test_a_stage_that_reads_or_writes_what_the_oracle_has_not_runs_again():
    assert result(rectangle(), stage_of(reads=("lit", "other"), writes=("seen",))) == "run again"
    assert result(rectangle(), stage_of(reads=("lit",), writes=("seen", "other"))) == "run again"
    assert result(rectangle(), stage_of(reads=("lit",), writes=("seen",))) == {"seen": [12, 14]}


def test_bits_are_the_same_or_not():
    zero = np.float32([0.0])
    assert _same_bits(zero, zero.copy()) and not _same_bits(zero, -zero) and not _same_bits(zero, zero.astype(float))
    assert _same_bits(np.float32([np.nan]), np.float32([np.nan])) and not _same_bits(zero, zero + 1)


def test_fragments_may_be_where_a_stencil_may_be_set():
    drawn = rectangle(where=[[True, False], [False, False]])
    drawn.work.this_pass.draw.stencil = "coverage"
    assert drawn.possible.tolist() == [[True, False], [False, False]]
    high = np.uint8([[1, 1], [0, 0]])
    known = KnownBuffer(np.uint8([[1, 0], [0, 0]]), np.zeros((2, 2)), high, high != 1)
    assert drawn.reading({"coverage": known}).possible.tolist() == [[True, True], [False, False]]


def test_a_varying_may_be_as_far_off_as_its_interpolation_at_that_pixel(tmp_path):
    """At row 9 and column 5, and at row 5 and column 9: a slack is of its own row and column."""
    path = written(tmp_path / "sphere.obj", *sphere(6))
    scene = load_scene(around(path, 16))
    (this_pass,) = (each for each in scene.method.passes if each.name == "shadow_map")
    drawn = Case(Result(scene, {}, {}), Drawing({}), PROFILES["vulkan"]).drawn(this_pass)
    rows, columns = np.array([9, 5]), np.array([5, 9])
    known = drawn.given((rows, columns))["fragment_position"]
    boxes, piece = drawn.visible.boxes, drawn.work.fragments.piece[rows, columns]
    own, first = known.columns, drawn.work.fragments.varyings["fragment_position"]
    slack = interpolation_slack(boxes, piece, columns, rows, own, slice(first, first + 3))
    rounding = 2.0**-21 * np.abs(own.astype(np.float64)).max(axis=1)
    assert np.allclose(known.reach, slack + rounding[:, None], rtol=1e-9, atol=0) and (known.reach < 0.1).all()
    turned = interpolation_slack(boxes, piece, rows, columns, own, slice(first, first + 3))
    assert (turned != slack).any(axis=1).all()
