"""How far off a draw lies, measured on what was dumped of it."""

from copy import copy
from types import SimpleNamespace

import numpy as np
import pytest
from planted import LIGHT, NUMBERS, Planted, moved_in_clip_space, oracle_of, scene_of, vertex, zoomed

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language.types import mat4, vec3
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.cause.hypothesis import INPUT, NUMBER, SETTING, STATE
from sss_ref.validation.cause.lying_off import Projected, fitted_shift, lying_off, planes_of
from sss_ref.validation.cause.redrawn import Redrawing, lies
from sss_ref.validation.clock import Limit
from sss_ref.validation.verdict.outcomes import FAIL, outcome_map

SIDE = 48
X, Y = 0.31, -0.17  # pixels
JITTER = vertex(LIGHT, moved_in_clip_space(2 * X / SIDE, 2 * Y / SIDE), "shadow_map")


@pytest.fixture(scope="module")
def oracle():
    return oracle_of(scene_of("bust", SIDE))


def draw_of(oracle, buffer, buffers):
    (this_pass,) = (each for each in oracle.scene.method.passes if buffer in each.outputs)
    return Redrawing(Case(oracle, Drawing(buffers), PROFILES["vulkan"]), this_pass, buffer)


def shift_of(oracle, buffer, buffers):
    return fitted_shift(Projected(draw_of(oracle, buffer, buffers), LIGHT), Limit(60))


@pytest.mark.parametrize("lacks", [(), NUMBERS, (*NUMBERS, "light_depth")])
def test_a_jitter_is_measured_to_a_five_hundredth_of_a_pixel(oracle, lacks):
    dumped = Planted("jitter", JITTER, "", lacks=lacks).drawn(oracle.scene)
    assert np.allclose(shift_of(oracle, "light_distance", dumped), (X, Y), rtol=0, atol=1 / 500)


def test_where_only_numbers_of_triangles_are_known_it_is_searched_for(oracle):
    dumped = Planted("jitter", JITTER, "").drawn(oracle.scene)
    dumped = {name: buffer for name, buffer in dumped.items() if name == "light_triangle"}
    assert np.allclose(shift_of(oracle, "light_triangle", dumped), (X, Y), rtol=0, atol=1 / 50)
    (found,) = lying_off(draw_of(oracle, "light_triangle", dumped), Limit(60))
    assert found.charge.text.startswith("the picture lies 0.3") and found.charge.blames == INPUT


@pytest.mark.parametrize("buffer", ["light_depth", "light_triangle"])
def test_a_right_buffer_lies_where_it_should(oracle, buffer):
    alone = {buffer: oracle[buffer]}
    assert shift_of(oracle, buffer, alone) == (0.0, 0.0) and not [*lying_off(draw_of(oracle, buffer, alone), Limit(60))]


def test_the_size_of_a_picture_is_measured(oracle):
    dumped = Planted("zoom", vertex(LIGHT, zoomed(1.013), "shadow_map"), "").drawn(oracle.scene)
    texts = [each.charge.text for each in lying_off(draw_of(oracle, "light_depth", dumped), Limit(60))]
    assert f"{LIGHT} is of another field of view: tan(fov_y/2) is 1.013 times as large" in texts


WIDTH, HEIGHT = 40, 24
NEAR, FAR = 1.0, 5.0
MATRIX = np.array([[2, 0, 1, 3], [0, 4, 1, 5], [0, 0, -1.5, -2.5], [0, 0, -1, 0]])  # of a perspective with these planes
PARALLEL = np.array([[2, 0, 1, 3], [0, 4, 1, 5], [0, 0, -0.5, -0.25], [0, 0, 0, 1.0]])


def smooth(x, y):
    return 0.5 + 0.2 * np.sin(0.3 * x + 0.1) + 0.1 * np.cos(0.25 * y) + 0.1 * np.sin(0.2 * x + 0.15 * y)


def slanted(x, y):
    return np.stack([0.01 * x, 0.02 * y, 0.01 * (x + y)], axis=-1)


def numbered(x, y):
    """Numbers, which have no slope: bands whose edges pass the pixels everywhere between them."""
    return (np.floor(0.37 * x + 0.113) + 100 * np.floor(0.59 * y + 0.231)).astype(np.int32)


class Drawn:
    """A draw of a function of the place, moved and scaled as its matrix says; stands for a `Redrawing`."""

    def __init__(self, picture, buffers=None, matrix=MATRIX):
        """picture: of x and y in pixels. buffers: what was dumped."""
        scene = SimpleNamespace(uniforms={LIGHT: matrix.astype(np.float32)}, size=lambda this_pass: (WIDTH, HEIGHT))
        drawing = SimpleNamespace(buffers=buffers or {})
        self.case = SimpleNamespace(oracle=SimpleNamespace(scene=scene), drawing=drawing)
        draw = SimpleNamespace(reads={LIGHT: mat4, "world_from_model": mat4, "light_position": vec3}, depth="depth")
        self.this_pass = SimpleNamespace(draw=draw, outputs={"depth": float, "seen": float})
        self.picture, self.matrix, self.buffer = picture, matrix, "seen"

    def of(self, buffer):
        other = copy(self)
        other.buffer = buffer
        return other

    def draw(self, uniforms=None):
        change = (uniforms[LIGHT] if uniforms else self.matrix) @ np.linalg.inv(self.matrix)
        return self.at(change[0, 3] * WIDTH / 2, change[1, 3] * HEIGHT / 2, change[0, 0])

    def at(self, x, y, scale=1.0):
        columns, rows = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
        middle_x, middle_y = (WIDTH - 1) / 2, (HEIGHT - 1) / 2
        value = self.picture((columns - x - middle_x) / scale + middle_x, (rows - y - middle_y) / scale + middle_y)
        return value if value.dtype == np.int32 else value.astype(np.float32)


def dumped(picture, x=0.0, y=0.0, scale=1.0, matrix=MATRIX):
    return Drawn(picture, {"seen": Drawn(picture).at(x, y, scale)}, matrix)


def shift(todo):
    return fitted_shift(Projected(todo, LIGHT), Limit(60))


OFFSETS = [(0.0, 0.0), (0.31, -0.17), (-0.5, 0.5), (2.0, -1.5), (-0.012, 0.25)]


@pytest.mark.parametrize(("x", "y"), OFFSETS)
@pytest.mark.parametrize("picture", [smooth, slanted])
def test_an_offset_is_measured_to_a_thousandth(picture, x, y):
    assert np.allclose(shift(dumped(picture, x, y)), (x, y), rtol=0, atol=0.0011)


def test_halves_are_meant_where_they_are_as_good():
    assert shift(dumped(slanted, 0.4951, -2.0049)) == (0.5, -2.0)
    assert shift(dumped(slanted, 0.4939, -2.0061)) == (0.494, -2.006)
    assert shift(dumped(slanted, 0.0049, -0.0049)) == (0.0, 0.0)


def test_no_picture_lies_farther_off_than_eight_pixels():
    assert shift(dumped(slanted, 7.75, -7.75)) == (7.75, -7.75)
    assert shift(dumped(slanted, 9.75, -9.75)) == (8.0, -8.0)


def test_what_is_wrong_besides_is_left_out():
    todo = dumped(smooth, 0.31, -0.17)
    todo.case.drawing.buffers["seen"][:, :12] += 1
    todo.case.drawing.buffers["seen"][3, 20:] = np.nan
    assert np.allclose(shift(todo), (0.31, -0.17), rtol=0, atol=0.0011)


def test_it_is_measured_on_the_buffer_itself_if_that_holds_numbers():
    todo = dumped(smooth, 0.31, -0.17)
    todo.case.drawing.buffers["depth"] = Drawn(smooth).at(2.0, 1.0)
    assert np.allclose(shift(todo), (0.31, -0.17), rtol=0, atol=0.0011)
    todo.case.drawing.buffers["seen"] = np.zeros((HEIGHT, WIDTH), np.int32)
    assert shift(todo) == (2.0, 1.0)


@pytest.mark.parametrize("buffer", ["light_depth", "light_triangle"])
def test_a_draw_is_judged_by_its_own_buffer(oracle, buffer):
    found = draw_of(oracle, buffer, {name: oracle[name] for name in ("light_depth", "light_triangle")})
    check = found.judged({}, PROFILES["vulkan"])
    assert check.buffer == buffer and not (outcome_map(check) == FAIL).any()
    moved = Projected(found, LIGHT).uniforms(3.0, 0.0)
    assert (outcome_map(found.judged(moved, PROFILES["vulkan"])) == FAIL).any()


def test_what_moved_otherwise_is_left_out_where_most_moved_alike():
    todo, other = dumped(smooth, 0.31, -0.17), Drawn(smooth).at(-0.31, 0.17)
    todo.case.drawing.buffers["seen"][:, :15] = other[:, :15]
    assert np.allclose(shift(todo), (0.31, -0.17), rtol=0, atol=0.0011)


@pytest.mark.parametrize(("x", "y"), [(0.0, 0.0), (0.5, -0.25), (-0.375, 0.75), (0.75, 0.875), (-0.9375, -0.25)])
def test_numbers_are_searched_for_in_ever_smaller_steps(x, y):
    assert np.allclose(shift(dumped(numbered, x, y)), (x, y), rtol=0, atol=1 / 40)


def test_a_search_ends_with_its_time():
    assert fitted_shift(Projected(dumped(numbered, 0.5, 0.5), LIGHT), Limit(0)) == (0.0, 0.0)


def told(todo, *words):
    """What is told of a draw with these words in it."""
    return [each for each in lying_off(todo, Limit(60)) if all(word in each.charge.text for word in words)]


def test_an_offset_is_a_setting_where_a_viewport_can_do_it():
    for (x, y), blames in {(0.5, -1.0): SETTING, (0.25, 1.0): INPUT, (1.0, 0.25): INPUT}.items():
        (found,) = told(dumped(slanted, x, y), "a viewport")
        assert found.charge.text == f"{lies(x, y)}: a viewport, or a jitter left in {LIGHT}"
        assert (found.charge.blames, found.charge.names, found.rank) == (blames, (LIGHT,), STATE)
        change = np.array([[1, 0, 0, 2 * x / WIDTH], [0, 1, 0, 2 * y / HEIGHT], [0, 0, 1, 0], [0, 0, 0, 1]])
        assert found.uniforms[LIGHT].dtype == np.float32
        assert np.array_equal(found.uniforms[LIGHT], (change @ MATRIX).astype(np.float32))
    for x, y in ((0.25, 0), (0, 0.25)):
        assert len(told(dumped(slanted, x, y), "a viewport")) == 1


@pytest.mark.parametrize(("scale", "matrix"), [(1.25, MATRIX), (0.8, PARALLEL), (1.0025, MATRIX), (0.9975, MATRIX)])
def test_a_size_is_a_number(scale, matrix):
    (found,) = told(dumped(smooth, scale=scale, matrix=matrix), "times as large")
    assert found.rank == NUMBER
    kind = "of another field of view: tan(fov_y/2)" if matrix is MATRIX else "of another height: view_height"
    start, _, times = found.charge.text.partition(f"{LIGHT} is {kind} is ")
    assert (start, found.charge.blames, found.charge.names) == ("", INPUT, (LIGHT,))
    assert times.endswith(" times as large") and abs(float(times.split()[0]) * scale - 1) < 6e-4
    assert np.allclose(found.uniforms[LIGHT][:2], matrix[:2] * scale, rtol=2e-4, atol=0)
    assert np.array_equal(found.uniforms[LIGHT][2:], matrix[2:])


@pytest.mark.parametrize("along", ["x", "y"])
def test_a_size_is_measured_about_the_middle_along_either_axis(along):
    def waves(x, y):
        return 0.5 + 0.2 * np.sin(0.3 * (x if along == "x" else y) + 0.1)

    (found,) = told(dumped(waves, scale=1.25), "times as large")
    assert found.charge.text.endswith(" is 0.8 times as large")


@pytest.mark.parametrize("scale", [1.0, 1.0015, 0.9985])
def test_a_size_that_is_nearly_right_is_not_told(scale):
    assert not told(dumped(smooth, scale=scale), "times as large")


def test_a_size_is_not_measured_on_numbers_of_triangles():
    assert not told(dumped(numbered, scale=1.25), "times as large")


def with_depths(slope, offset, matrix=MATRIX):
    """A draw whose dumped depths d are slope * d + offset, and 1 where nothing is drawn."""

    def depths(x, y):
        return np.where((x < 30) & (y < 20), smooth(x, y) / 2, 1)

    drawn = Drawn(depths).at(0, 0)
    got = np.where((drawn < 1) & (np.arange(WIDTH) > 2), slope * drawn + offset, 1).astype(np.float32)
    return Drawn(depths, {"depth": got}, matrix)


PLANES = {  # of depths slope * d + offset, where d is 1.25 - 1.25 / w
    (0.9, 0.05): "near 0.957 and far 6.43, not 1 and 5",
    (1.1, -0.05): "near 1.04 and far 4.23, not 1 and 5",
    (1.0, 1.25 * 2.0**-14): "near 1 and far 5, not 1 and 5",
    (1 + 1.25 * 2.0**-14, 0.0): "near 1 and far 5, not 1 and 5",
}


@pytest.mark.parametrize(("slope", "offset"), PLANES)
def test_other_planes_are_told_from_the_depths(slope, offset):
    (found,) = told(with_depths(slope, offset), " near ")
    assert found.charge.text == f"{LIGHT} has {PLANES[slope, offset]}"
    assert (found.charge.blames, found.charge.names, found.rank) == (INPUT, (LIGHT,), STATE)
    z, w = MATRIX[2:]
    assert found.uniforms[LIGHT].dtype == np.float32
    assert np.allclose(found.uniforms[LIGHT][2], slope * (z + w) + 2 * offset * w - w, rtol=0, atol=1e-5)
    assert np.array_equal(found.uniforms[LIGHT][[0, 1, 3]], MATRIX[[0, 1, 3]])


@pytest.mark.parametrize(
    ("slope", "offset"),
    [(1.0, 0.0), (1.0, 1.5 * 2.0**-15), (1 + 1.5 * 2.0**-15, 0.0), (-1.0, 1.0)],  # the last has far and near swapped
)
def test_depths_that_are_nearly_right_or_fall_have_the_same_planes(slope, offset):
    assert not told(with_depths(slope, offset), " near ")


def test_a_parallel_view_has_depths_and_no_distances():
    text = f"{LIGHT} has other near and far planes: depths are 0.9 * d + 0.05"
    assert [each.charge.text for each in told(with_depths(0.9, 0.05, PARALLEL), " near ")] == [text]


def test_where_nothing_is_drawn_or_all_is_as_deep_no_planes_are_told():
    todo = with_depths(0.9, 0.05)
    todo.case.drawing.buffers["depth"][:] = 1
    assert not told(todo, " near ")
    flat = Drawn(lambda x, y: 0.5 + 0 * x, {"depth": np.full((HEIGHT, WIDTH), 0.25, np.float32)})
    assert not told(flat, " near ")


@pytest.mark.parametrize("w", [(0, 0, -1, 0), (0.6, 0, -0.8, 2), (0, 3, 0, 0)])
def test_the_planes_of_a_matrix(w):
    matrix = np.array([(1, 0, 0, 0), (0, 1, 0, 0), 1.5 * np.array(w) - (0, 0, 0, 2.5), w])
    assert np.allclose(planes_of(matrix), (NEAR, FAR), rtol=1e-12, atol=0)  # the slope is a quotient
    assert planes_of(PARALLEL) is None


def test_a_far_plane_may_be_nowhere():
    assert planes_of(np.array([(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, -1, -2.0), (0, 0, -1, 0)])) == (1, np.inf)


def test_a_size_is_measured_on_the_buffer_itself():
    todo = dumped(smooth, scale=1.25)
    todo.case.drawing.buffers["depth"] = Drawn(smooth).at(0, 0, 1.5)
    (found,) = told(todo, "times as large")
    assert found.charge.text.endswith(" is 0.8 times as large")


@pytest.mark.parametrize("buffer", ["light_triangle", "light_depth", "light_distance"])
def test_a_draw_with_nothing_changed_is_the_oracles(oracle, buffer):
    assert np.array_equal(draw_of(oracle, buffer, {buffer: oracle[buffer]}).draw(), oracle[buffer])
