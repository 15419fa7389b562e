"""What may be wrong with a draw: every matrix and every move of its pieces, worked out by hand."""

from types import SimpleNamespace

import numpy as np
import pytest
from scenes import around, two_squares, written

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language.types import mat3, mat4, vec3
from sss_ref.raster.primitives import Primitives
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.cause.hypothesis import INPUT, NUMBER, SETTING, STATE
from sss_ref.validation.cause.redrawn import Redrawing, lies, redrawings, seen_otherwise

CLIP, OTHER, NORMALS, MODEL = "light_clip_from_model_1", "light_clip_from_model_2", "normal_matrix", "world_from_model"
UNIFORMS = {
    CLIP: np.float32([[2, 0, 1, 3], [0, 4, 1, 5], [0, 0, -1, -2], [0, 0, -1, 7]]),
    OTHER: np.float32(np.arange(16).reshape(4, 4)),
    NORMALS: np.float32([[1, 2, 3], [4, 5, 6], [7, 8, 9]]),
    MODEL: np.float32([[2, 1, 0, 9], [0, 3, 1, 8], [1, 0, 4, 7], [0, 0, 0, 1]]),
    "light_position_1": np.float32([1, 2, 3]),
}


def redrawn(*reads, size=(8, 4), uniforms=UNIFORMS):
    """In words -> the charge, its rank, and what is drawn: other uniforms, and a move of pieces."""
    kinds = {CLIP: mat4, NORMALS: mat3, MODEL: mat4, "light_position_1": vec3}

    def draw(changed=None, move=None):
        return changed, move

    todo = SimpleNamespace(
        case=SimpleNamespace(
            oracle=SimpleNamespace(scene=SimpleNamespace(uniforms=uniforms, size=lambda this_pass: size))
        ),
        this_pass=SimpleNamespace(draw=SimpleNamespace(reads={name: kinds[name] for name in reads})),
        draw=draw,
    )
    return {charge.text: (charge, rank, drawn()) for charge, rank, drawn in redrawings(todo)}


def matrix(name, words, **scene):
    """The one that a matrix is in such words, and that it is to blame alone."""
    charge, rank, (uniforms, move) = redrawn(name, **scene)[f"{name} is {words}"]
    assert (charge.blames, charge.names, rank, move) == (INPUT, (name,), NUMBER, None) and [*uniforms] == [name]
    assert uniforms[name].dtype == np.float32
    return uniforms[name]


def scaled(factors):
    return np.float32(np.array(factors)[:, None] * UNIFORMS[CLIP])


@pytest.mark.parametrize("name", [CLIP, NORMALS, MODEL])
def test_any_matrix_may_be_transposed_or_left_out(name):
    assert np.array_equal(matrix(name, "transposed"), UNIFORMS[name].T)
    assert np.array_equal(matrix(name, "the identity"), np.eye(len(UNIFORMS[name])))


def test_the_model_matrix_may_turn_normals():
    model = matrix(NORMALS, "world_from_model, not its inverse transpose")
    assert np.array_equal(model, [[2, 1, 0], [0, 3, 1], [1, 0, 4]])
    assert not any("inverse transpose" in text for text in redrawn(CLIP, MODEL))


def test_another_light_may_lend_its_matrix():
    assert np.array_equal(matrix(CLIP, OTHER), UNIFORMS[OTHER])
    lent = [text for text in redrawn(CLIP, NORMALS, MODEL) if text.rpartition(" is ")[2] in UNIFORMS]
    assert lent == [f"{CLIP} is {OTHER}"]


def test_a_depth_of_the_other_convention():
    expected = [*UNIFORMS[CLIP][:2], (UNIFORMS[CLIP][2] + UNIFORMS[CLIP][3]) / 2, UNIFORMS[CLIP][3]]
    assert np.array_equal(matrix(CLIP, "of the other convention: z from 0 to w, not from -w to w"), expected)


FIELD = "of another field of view: tan(fov_y/2) is"
ZOOMS = ["0.5", "0.8", "0.9", "0.95", "0.98", "0.99", "0.995", "1.005", "1.01", "1.02", "1.05", "1.1", "1.25", "2"]
TURNS = ["-5", "-2", "-1", "-0.5", "-0.25", "-0.1", "0.1", "0.25", "0.5", "1", "2", "5"]


@pytest.mark.parametrize("zoom", ZOOMS)
def test_another_field_of_view(zoom):
    expected = scaled([1 / float(zoom), 1 / float(zoom), 1, 1])
    assert np.array_equal(matrix(CLIP, f"{FIELD} {zoom} times as large"), expected)


@pytest.mark.parametrize("degrees", TURNS)
def test_another_time(degrees):
    angle = float(degrees) * np.pi / 180
    x, z = UNIFORMS[CLIP][:, 0].astype(np.float64), UNIFORMS[CLIP][:, 2].astype(np.float64)
    along_x, along_z = x * np.cos(angle) - z * np.sin(angle), x * np.sin(angle) + z * np.cos(angle)
    expected = np.column_stack([along_x, UNIFORMS[CLIP][:, 1], along_z, UNIFORMS[CLIP][:, 3]])
    words = f"of another time: the scene is turned by {degrees} degrees about the vertical"
    assert np.allclose(matrix(CLIP, words), expected, rtol=1e-6, atol=1e-7)  # the twin multiplies in another order


def test_nothing_else_is_tried_of_a_projection_nor_any_of_that_of_other_matrices():
    assert len([text for text in redrawn(CLIP) if text.startswith(CLIP)]) == 2 + 1 + 1 + len(ZOOMS) + len(TURNS) + 2
    assert len([text for text in redrawn(MODEL) if text.startswith(MODEL)]) == 2
    assert len(redrawn()) == len(redrawn("light_position_1"))


def test_an_aspect_ratio_left_out_or_turned_round():
    assert np.array_equal(matrix(CLIP, "of another aspect ratio: it is left out"), scaled([2, 1, 1, 1]))
    assert np.array_equal(matrix(CLIP, "of another aspect ratio: it is turned round"), scaled([4, 1, 1, 1]))
    high = matrix(CLIP, "of another aspect ratio: it is left out", size=(4, 8))
    assert np.array_equal(high, scaled([0.5, 1, 1, 1]))
    assert not any("aspect" in text for text in redrawn(CLIP, size=(8, 8)))
    assert not any("aspect" in text for text in redrawn(MODEL))


def test_a_parallel_view_has_a_height():
    parallel = UNIFORMS[CLIP].copy()
    parallel[3] = (0, 0, 0, 1)
    assert seen_otherwise(parallel) == "of another height: view_height is"
    for column in range(3):
        perspective = parallel.copy()
        perspective[3, column] = -1
        assert seen_otherwise(perspective) == FIELD
    matrix(CLIP, "of another height: view_height is 2 times as large", uniforms={CLIP: parallel})


@pytest.mark.parametrize(
    ("x", "y", "words"),
    [
        (1, 0, "1 pixel too far right"),
        (-0.5, 0, "0.5 pixels too far left"),
        (0, 1, "1 pixel too far up"),
        (0, -1, "1 pixel too far down"),
        (2.5, -1, "2.5 pixels too far right and 1 pixel too far down"),
        (-0.3125, 0.125, "0.312 pixels too far left and 0.125 pixels too far up"),
    ],
)
def test_where_a_picture_lies_in_words(x, y, words):
    assert lies(x, y) == f"the picture lies {words}"


STEP = 16
SNAPPED = np.int32([[0, 0], [33, 7], [-5, 40], [24, -8], [100, 20], [60, 90]])
PIECES = Primitives(
    np.int32([[0, 1, 2], [3, 5, 4]]),
    np.int32([4, 6]),
    SNAPPED,
    np.float32([0, 0.25, 0.5, 0.75, 1, 0.125]),
    np.ones(6, np.float32),
    np.zeros((6, 1), np.float32),
)


def moved(words):
    """The rank of an explanation in such words, and the pieces then."""
    charge, rank, (_, move) = redrawn()[words]
    assert charge.blames == SETTING
    return rank, move(PIECES, STEP)


@pytest.mark.parametrize(
    ("words", "triangle"),
    [("front faces, counter-clockwise", 6), ("back faces, clockwise", 4)],  # the second piece turns clockwise
)
def test_faces_are_culled(words, triangle):
    rank, pieces = moved(f"{words} in the window, are culled")
    assert rank == STATE and pieces.triangle.tolist() == [triangle] and np.array_equal(pieces.snapped, SNAPPED)


def test_a_piece_without_area_is_culled_with_both():
    flat = PIECES._replace(corners=np.int32([[0, 1, 1]]), triangle=np.int32([9]))
    for words in ("front faces, counter-clockwise", "back faces, clockwise"):
        _, _, (_, move) = redrawn()[f"{words} in the window, are culled"]
        assert len(move(flat, STEP).corners) == 0


def test_the_farthest():
    rank, pieces = moved("the depth test keeps the farthest")
    assert rank == STATE and pieces.depth.tolist() == [1, 0.75, 0.5, 0.25, 0, 0.875]


@pytest.mark.parametrize(
    ("words", "x", "y"),
    [
        ("0.5", 0.5, 0.5),
        ("2", 2, 2),
        ("0.5 in x", 0.5, 1),
        ("0.5 in y", 1, 0.5),
        ("2 in x", 2, 1),
        ("2 in y", 1, 2),
    ],
)
def test_a_viewport_of_another_size(words, x, y):
    """The corner of the picture stays, half a pixel beside the first sample."""
    rank, pieces = moved(f"its viewport is {words} times as large as its target")
    expected = [(round((a + 8) * x - 8), round((b + 8) * y - 8)) for a, b in SNAPPED.tolist()]
    assert rank == NUMBER and pieces.snapped.tolist() == [[*each] for each in expected]
    assert pieces.snapped.dtype == np.int32


def test_a_viewport_that_lies_off():
    around = (-1, -0.5, 0, 0.5, 1)
    found = {text for text in redrawn() if text.endswith(": a viewport or a jitter")}
    assert found == {f"{lies(x, y)}: a viewport or a jitter" for x in around for y in around if x or y}
    for x in around:
        for y in around:
            if x or y:
                rank, pieces = moved(f"{lies(x, y)}: a viewport or a jitter")
                assert rank == STATE and np.array_equal(pieces.snapped, SNAPPED + np.array([x * 16, y * 16]))
                assert pieces.snapped.dtype == np.int32


def test_the_least_turn_is_one():
    """Twice the area of half a square of the grid that corners snap to."""
    least = PIECES._replace(
        corners=np.int32([[0, 1, 2], [0, 2, 1]]), triangle=np.int32([1, 2]), snapped=np.int32([[0, 0], [1, 0], [0, 1]])
    )
    for words, kept in (("front faces, counter-clockwise", 2), ("back faces, clockwise", 1)):
        _, _, (_, move) = redrawn()[f"{words} in the window, are culled"]
        assert move(least, STEP).triangle.tolist() == [kept]


@pytest.fixture(scope="module")
def squares(tmp_path_factory):
    """Two squares of two triangles each, seen by a camera of 12 x 8 pixels."""
    path = written(tmp_path_factory.mktemp("squares") / "squares.obj", *two_squares())
    scene = load_scene(around(path, 8), **{"camera.width": 12})
    return render(scene, "arrays")


def drawing(oracle, buffer):
    """The draw of a buffer of the camera, of which all was dumped."""
    return Redrawing(Case(oracle, Drawing(oracle.buffers), PROFILES["vulkan"]), oracle.scene.method["camera"], buffer)


@pytest.mark.parametrize("buffer", ["triangle", "depth", "coverage", "position_world"])
def test_with_nothing_changed_a_draw_is_the_oracles(squares, buffer):
    """Triangle 0 is seen, and so is the background."""
    assert {-1, 0} <= set(squares["triangle"].ravel().tolist())
    drawn = drawing(squares, buffer).draw()
    assert drawn.dtype == squares[buffer].dtype and np.array_equal(drawn, squares[buffer])
    check = drawing(squares, buffer).judged({}, PROFILES["vulkan"])
    assert check.buffer == buffer and np.array_equal(check.expected, squares[buffer])


def test_a_draw_that_gives_no_numbers_is_drawn_all_the_same(squares):
    nowhere = {"camera_clip_from_model": np.full((4, 4), np.nan, np.float32)}
    assert (drawing(squares, "triangle").draw(nowhere) == -1).all()
    assert (drawing(squares, "triangle").judged(nowhere, PROFILES["vulkan"]).expected == -1).all()
