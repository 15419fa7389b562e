"""In which ways a file may hold a buffer's numbers, and at which pixels the two are compared; worked out by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.capture.expected import Pixels, Sought

# A camera at (1, 2, 3) whose right is the world's -Z, its upwards Y and its backwards X.
TURNED = np.array([[0.0, 0, -1, 0], [0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
CAMERA = SimpleNamespace(view=TURNED, eye=(1.0, 2.0, 3.0))
KINDS = {"f": np.float32, "i": np.int32, "u": np.uint8}


def seen(parallel):
    return SimpleNamespace(near=1.0, far=3.0, lens=SimpleNamespace(is_parallel=parallel))


def sought(name, values, kind="f", **known):
    """A buffer of one row. known: what its slot says beside."""
    buffer = np.array([values], KINDS[kind])
    channels = buffer.shape[2] if buffer.ndim == 3 else 1
    about = {"is_window_depth": False, "view": None, "is_direction": False, "is_spatial": False, **known}
    slot = SimpleNamespace(
        name=name, dtype=buffer.dtype, height=1, width=buffer.shape[1], channels=channels, mask="", **about
    )
    return Sought(slot, buffer, Pixels.among(np.ones(buffer.shape[:2], bool)), CAMERA)


def held(buffer):
    """Of each way the numbers, the keys and the storages."""
    return [(each.expected.values.tolist(), dict(each.keys), each.storages) for each in buffer.readings]


def test_yes_and_no_may_be_bytes():
    assert held(sought("coverage", [0, 1], "u")) == [
        ([[0], [1]], {}, ()),
        ([[0], [255]], {"encoding": "unorm8"}, ("uint8",)),
    ]


def test_numbers_of_triangles_may_be_shares_of_a_byte_or_two_where_none_is_all():
    plain, eight, sixteen = held(sought("triangle", [-1, 51], "i"))
    assert plain[0] == [[-1], [51]] and len(plain[2]) == 8
    assert eight == ([[1], [0.2]], {}, ("unorm8",))
    assert sixteen == ([[1], [51 / 65535]], {}, ("unorm16",))


def test_colours_may_be_encoded():
    plain, encoded = held(sought("phong", [[0.5, 1.0, 4.0]]))
    assert plain[0] == [[0.5, 1, 4]] and encoded[1:] == ({"encoding": "srgb8"}, ("unorm8",))
    assert encoded[0][0] == pytest.approx([0.7353569, 1, 1])  # 1.055 * .5^(1/2.4) - .055


def test_texture_coordinates_may_run_downwards_and_nothing_stays_nothing():
    plain, downwards = held(sought("uv", [[0.25, 0.125], [0.5, 0.0], [-1.0, -1.0]]))
    assert plain[0] == [[0.25, 0.125], [0.5, 0], [-1, -1]]
    assert downwards == ([[0.25, 0.875], [0.5, 1], [-1, -1]], {"scale": [1, -1], "offset": [0, 1]}, ())


@pytest.mark.parametrize(("parallel", "along"), [(False, [[1], [1.5], [3]]), (True, [[1], [2], [3]])])
def test_depths_may_be_reversed_or_distances(parallel, along):
    """From near = 1 to far = 3, by far*near / (far - z*(far - near)), or evenly."""
    plain, reverse, distance = held(sought("depth", [0.0, 0.5, 1.0], is_window_depth=True, view=seen(parallel)))
    assert plain[0] == [[0], [0.5], [1]]
    assert reverse == ([[1], [0.5], [0]], {"scale": -1, "offset": 1}, ())
    assert distance == (along, {"depth": "view"}, ())


def test_directions_may_be_packed_and_in_the_cameras_space():
    plain, packed, turned, both = held(sought("normal_world", [[0.0, 1.0, -1.0]], is_direction=True, is_spatial=True))
    assert plain[0] == [[0, 1, -1]] and packed == ([[0.5, 1, 0]], {"normals": "n*.5+.5"}, ())
    assert turned == ([[1, 1, 0]], {"space": "view"}, ())
    assert both == ([[1, 1, 0.5]], {"space": "view", "normals": "n*.5+.5"}, ())


def test_points_may_be_in_the_cameras_space():
    """(2, 4, 7) lies at (1, 2, 4) from the eye."""
    plain, turned = held(sought("position_world", [[2.0, 4.0, 7.0]], is_spatial=True))
    assert plain[0] == [[2, 4, 7]] and turned == ([[-4, 2, 1]], {"space": "view"}, ())


def test_how_much_must_speak_for_a_place():
    assert sought("coverage", [0, 1], "u").least == 0.8
    assert sought("thickness", [2.0, 2.0]).least == 0.6
    assert sought("thickness", [2.0, 3.0]).least == 0.0


def test_what_is_whole_and_what_is_blank():
    assert [sought("x", [0, 1], kind).is_whole for kind in "fiu"] == [False, True, True]
    assert [sought("x", values).is_blank for values in ([2, 2], [2, 3])] == [True, False]
    assert not sought("x", [[1.0, 2.0], [1.0, 3.0]]).is_blank and sought("x", [[1.0, 2.0], [1.0, 2.0]]).is_blank


def test_a_file_fits_by_its_storage():
    plain, packed = sought("coverage", [0, 1], "u").readings
    stored = [SimpleNamespace(texels=SimpleNamespace(storage=storage)) for storage in ("uint8", "float32")]
    assert [plain.fits(each) for each in stored] == [True, True]
    assert [packed.fits(each) for each in stored] == [True, False]


def test_a_thousand_pixels_of_those_that_are_drawn_and_a_grid_of_all():
    where = np.zeros((200, 100), bool)
    where[50:150] = True
    pixels = Pixels.among(where)
    assert len(pixels.rows) == len(pixels.columns) == 1024 and where[pixels.rows, pixels.columns].all()
    ends = [(pixels.rows[k], pixels.columns[k]) for k in (0, -1)]
    assert ends == [(50, 0), (149, 99)]
    up, across = pixels.grid
    assert len(up) == len(across) == 96 * 96
    assert (up.min(), up.max(), across.min(), across.max()) == (0, 199, 0, 99)
    assert len(set(up.tolist())) == len(set(across.tolist())) == 96


def test_where_nothing_is_drawn_all_pixels_are_compared():
    pixels = Pixels.among(np.zeros((2, 3), bool))
    assert [*zip(pixels.rows.tolist(), pixels.columns.tolist(), strict=True)] == [
        (0, 0),
        (0, 1),
        (0, 2),
        (1, 0),
        (1, 1),
        (1, 2),
    ]
    assert pixels.of(np.arange(6).reshape(2, 3)).tolist() == [[0], [1], [2], [3], [4], [5]]
