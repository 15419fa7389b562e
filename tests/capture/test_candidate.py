"""In which way a file is a buffer: rows, channels, encodings, by pictures of a few pixels that are made here."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.capture.candidate import Comparison, Habit
from sss_ref.capture.expected import Pixels, Sought
from sss_ref.capture.surfaces import Unnamed
from sss_ref.dump.texels import StoredTexels

RNG = np.random.default_rng(5)
RGB = RNG.random((6, 5, 3)).astype(np.float32)
GREY = RNG.random((6, 5)).astype(np.float32)


def sought(buffer, name="phong", **known):
    """A buffer that is drawn everywhere."""
    height, width, channels = (*buffer.shape, 1)[:3]
    about = {"is_window_depth": False, "view": None, "is_direction": False, "is_spatial": False, **known}
    slot = SimpleNamespace(
        name=name, dtype=buffer.dtype, height=height, width=width, channels=channels, mask="", **about
    )
    return Sought(slot, buffer, Pixels.among(np.ones((height, width), bool)), SimpleNamespace())


def picture(data, file="a.npy", storage="float32"):
    data = data.reshape(*data.shape[:2], -1)
    return Unnamed(Path(file), StoredTexels(data, tuple("RGBA"[: data.shape[2]]), storage))


def found(data, buffer, free=None, habit=None, predicted=None, file="a.npy", storage="float32", **known):
    """The picture as the buffer."""
    surface, wanted = picture(data, file, storage), {"phong": sought(buffer, **known)}
    free = tuple(range(len(surface.channels))) if free is None else free
    return Comparison([surface], wanted).candidate(0, "phong", free, predicted, habit or Habit())


@pytest.mark.parametrize("data", [RGB[:-1], RGB[:, :-1], RGB[..., :2]])
def test_a_picture_of_another_size_or_with_too_few_channels_is_none(data):
    assert found(data, RGB) is None


def test_channels_of_another_buffer_are_not_free():
    data = np.dstack([GREY, RGB])
    assert found(data, RGB, free=(1, 2)) is None
    assert found(data, RGB, free=(1, 2, 3)).channels == (1, 2, 3)


def test_the_same_is_wholly_alike():
    each = found(RGB, RGB)
    assert (each.surface, each.name, each.channels, each.origin, dict(each.keys)) == (
        0,
        "phong",
        (0, 1, 2),
        "bottom",
        {},
    )
    assert each.score == pytest.approx(1) and each.close == pytest.approx(1)
    assert 0.3 < each.turned < 1 and 0.3 < each.ordered < 1


@pytest.mark.parametrize(("file", "usual", "other"), [("a.npy", "bottom", "top"), ("a.png", "top", "bottom")])
def test_rows_run_as_the_values_say_or_else_as_in_files_of_the_kind(file, usual, other):
    upright = GREY if usual == "bottom" else GREY[::-1]
    assert found(upright, GREY, file=file).origin == usual
    turned = found(upright[::-1], GREY, file=file)
    assert turned.origin == other and turned.score == pytest.approx(1) and turned.turned > 0.3
    even = np.vstack([GREY[:3], GREY[2::-1]])
    same = found(even, even, file=file)
    assert (same.origin, same.turned) == (usual, 0)


def test_how_much_less_speaks_for_the_other_rows():
    """As much as it would gain if it were turned; less than nothing where a habit has it the worse way."""
    right, forced = found(GREY, GREY), found(GREY, GREY, habit=Habit(("top",)))
    assert (right.origin, forced.origin) == ("bottom", "top")
    assert right.turned == pytest.approx(right.score - forced.score) == pytest.approx(-forced.turned)


@pytest.mark.parametrize("order", [(2, 1, 0), (1, 0, 2), (1, 2, 0)])
def test_channels_in_another_order(order):
    each = found(RGB[..., order], RGB)
    assert [order[channel] for channel in each.channels] == [0, 1, 2]
    assert each.score == pytest.approx(1) and each.ordered > 0.3
    orderly = found(RGB[..., order], RGB, habit=Habit(in_order=True))
    assert (orderly.channels, orderly.ordered) == ((0, 1, 2), 1.0) and orderly.score < 0.7


def test_one_channel_has_no_order_and_of_several_the_best_is_taken():
    data = np.dstack([RGB[..., 0], GREY, RGB[..., 1]])
    each = found(data, GREY)
    assert (each.channels, each.ordered) == ((1,), 1.0) and each.score == pytest.approx(1)


def test_channels_that_are_all_the_same_have_any_order():
    grey = np.dstack([GREY] * 3)
    each = found(grey, grey)
    assert (each.channels, each.ordered) == ((0, 1, 2), 0.0)


def test_a_slightly_better_order_is_not_taken():
    """The last two channels differ by a ten thousandth of what they hold: less than .05 speaks for their places."""
    near = np.dstack([RGB[..., 0], GREY, GREY * np.float32(1.0001)])
    each = found(near[..., [0, 2, 1]], near)
    assert each.channels == (0, 1, 2) and -0.05 < each.ordered < 0


def test_an_encoding_is_taken_where_it_fits_and_is_clearly_better():
    normals = RGB * 2 - 1
    packed = found(normals * np.float32(0.5) + np.float32(0.5), normals, is_direction=True)
    assert dict(packed.keys) == {"normals": "n*.5+.5"} and packed.close > 0.85
    assert dict(found(normals, normals, is_direction=True).keys) == {}


def test_an_encoding_that_does_not_fit_is_not_taken_though_more_speaks_for_it():
    """Packed, and every number a hundredth off: two of the four orders that count."""
    normals = RGB * 2 - 1
    off = RGB + np.where(RNG.random(RGB.shape) < 0.5, np.float32(0.005), np.float32(-0.005))
    packed = sought(normals, is_direction=True).readings[-1]
    other = found(off, normals, predicted=packed, is_direction=True)
    plain = found(off, normals, is_direction=True)
    assert plain.score + 0.05 < other.score and other.close < 0.85 and dict(plain.keys) == {}


def test_an_encoding_that_fits_as_well_is_not_taken():
    """0 and 1 are so in sRGB too."""
    wanted = np.float32(RNG.random((6, 5, 3)) < 0.5)
    each = found((wanted * 255).astype(np.uint8), wanted, storage="unorm8")
    assert each.score == pytest.approx(1) and dict(each.keys) == {}


def test_an_encoding_counts_only_for_files_of_its_storage():
    wanted = np.float32([[0.1, 0.5, 0.9], [0.2, 0.4, 0.7]]).reshape(1, 2, 3)
    codes = np.uint8([[89, 188, 243], [124, 170, 218]]).reshape(1, 2, 3)  # 255 times IEC 61966-2-1 of it
    assert dict(found(codes, wanted, storage="unorm8").keys) == {"encoding": "srgb8"}
    assert dict(found(codes / np.float32(255), wanted).keys) == {}


def test_what_a_stage_makes_of_the_dump_counts_where_it_is_nearer():
    drawn = RNG.random(RGB.shape).astype(np.float32)
    (usual, *_) = sought(drawn).readings
    assert found(drawn, RGB).score < 0.7
    assert found(drawn, RGB, predicted=usual).score == pytest.approx(1)
    assert found(RGB, RGB, predicted=usual).score == pytest.approx(1)


def test_numbers_of_triangles_are_read_as_the_file_holds_them():
    """As numbers, or in bytes that are shares of 255; nothing is near another number."""
    numbers = np.arange(30, dtype=np.int32).reshape(6, 5) - 1
    as_bytes = np.where(numbers < 0, 255, numbers).astype(np.uint8)
    for data, storage in (
        (numbers, "int32"),
        (as_bytes, "unorm8"),
        (numbers.astype(np.float32), "float24"),
    ):  # the last are numbers where nobody has said so
        each = found(data, numbers, storage=storage)
        assert each.score == pytest.approx(1) and each.close == pytest.approx(1) and dict(each.keys) == {}
    assert found(numbers + 1, numbers, storage="int32").close < 0.1


def test_a_picture_is_compared_once():
    surface, wanted = picture(RGB), {"phong": sought(RGB)}
    comparison = Comparison([surface], wanted)
    first = comparison.candidate(0, "phong", (0, 1, 2))
    assert comparison.candidate(0, "phong", (0, 1, 2)) == first and comparison.candidate(0, "phong", (2, 1, 0)) == first
