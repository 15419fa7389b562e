"""What textures keep: the values that one may have been given that holds another, and depths in all their formats."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sss_ref
from sss_ref.dump.loss import LOSSES
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.numerics.interval import Interval
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.color_texture import srgb_decoded
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.storage import after_storage, before_storage, depth_storage, lost_in_storage, step_of

F = np.float32
VULKAN = PROFILES["vulkan"]
CODES = {"unorm8": 255, "rgb10a2": 1023, "unorm16": 65535, "unorm24": 2**24 - 1, "snorm8": 127, "snorm16": 32767}
BITS = {"float16": 10, "float24": 15, "r11g11b10f": 5}  # of the significand
LEAST = {"float24": -126}  # exponents of normal numbers; else -14


def neighbours(x, storage):
    """The values below and above that a texture has, each on its own; 0 <= x <= 1 for the normalised ones."""
    if storage == "srgb8":
        codes = srgb_decoded().astype(float)
        return codes[codes <= x].max(), codes[codes >= x].min()
    if storage in BITS:
        step = 2.0 ** (max(np.floor(np.log2(abs(x) or 1e-45)), LEAST.get(storage, -14)) - BITS[storage])
        return np.floor(x / step) * step, np.ceil(x / step) * step
    return np.floor(x * CODES[storage]) / CODES[storage], np.ceil(x * CODES[storage]) / CODES[storage]


@pytest.mark.parametrize("storage", LOSSES)
@given(x=st.floats(0, 1, width=32))
@settings(max_examples=200)
def test_a_texture_holds_a_neighbour_of_what_it_was_given(storage, x):
    for held in neighbours(x, storage):
        kept = np.array([held], F)
        before = before_storage(storage, kept)
        assert before.low[0] - 1e-7 <= x <= before.high[0] + 1e-7  # float32 holds n/255 only nearly
        assert lost_in_storage(storage, np.array([x], F), kept)[0] >= abs(held - x) - 1e-7


def test_steps_by_hand():
    values = F([0, 1, 3])
    assert step_of("float32", values).tolist() == [0, 0, 0]
    assert step_of("float16", values).tolist() == [2.0**-24, 2.0**-10, 3 * 2.0**-10]
    assert step_of("unorm8", values).tolist() == [1 / 255] * 3


def test_float32_keeps_everything():
    held = F([0, 0.1, -3, np.inf, -np.inf, np.nan])
    before = before_storage("float32", held)
    assert np.array_equal([before.low, before.high], [held, held], equal_nan=True)
    assert not lost_in_storage("float32", F([1, 0.1, np.nan, 2, 3, np.nan]), held).any()


def test_what_is_beyond_the_range_is_cut_off():
    held = F([0, 1, 0.2])
    before = before_storage("unorm8", held)
    assert before.low.tolist() == [-np.inf, 1 - 1 / 255, F(0.2) - 1 / 255]
    assert before.high.tolist() == [1 / 255, np.inf, F(0.2) + 1 / 255]
    assert lost_in_storage("unorm8", F([-3, 7, 7]), held).tolist() == [3, 6, 1 / 255]
    assert lost_in_storage("float16", F([7]), F([1])).tolist() == [2.0**-10]
    assert lost_in_storage("float32", F([7]), F([1])).tolist() == [0]


@pytest.mark.parametrize("held", [65504, np.inf])
def test_a_half_too_large_is_the_largest_or_infinite(held):
    """llvmpipe keeps 1e5 as 65504, a conversion to the nearest as infinity; -1e5 likewise."""
    before = before_storage("float16", F([held, -held]))
    assert before.low[0] <= 65504 and before.high[0] == np.inf
    assert before.low[1] == -np.inf and before.high[1] >= -65504
    assert lost_in_storage("float16", F([1e5]), F([held]))[0] >= held - 1e5
    assert np.isfinite(lost_in_storage("float16", F([5]), F([np.inf]))[0])


SMALL_HALF = 3 * 2.0**-16  # a subnormal one


def test_a_small_half_may_be_flushed():
    before = before_storage("float16", F([0.0, SMALL_HALF]))
    assert before.low[0] == -(2.0**-14) and before.high[0] == 2.0**-14
    assert before.low[1] == SMALL_HALF - 2.0**-24
    assert lost_in_storage("float16", F([SMALL_HALF]), F([0.0]))[0] >= SMALL_HALF
    assert lost_in_storage("float16", F([2.0**-13]), F([0.0]))[0] < 2.0**-13


def test_what_a_texture_may_hold_of_an_interval():
    low, high = [SMALL_HALF, -SMALL_HALF, 1.0, 60000.0, -1e5], [1.0, -SMALL_HALF, 2.0, 1e5, 0.0]
    held = after_storage("float16", Interval(np.array(low), np.array(high)))
    assert held.low.tolist() == [0.0, -SMALL_HALF - 2.0**-24, 1 - 2.0**-10, 60000 - 60000 * 2.0**-10, -np.inf]
    assert held.high.tolist() == [1 + 2.0**-10, 0.0, 2 + 2.0**-9, np.inf, 2.0**-24]
    held = after_storage("unorm8", Interval(np.array([-3.0, 0.5]), np.array([0.5, 7.0])))
    assert held.low.tolist() == [-1 / 255, 0.5 - 1 / 255] and held.high.tolist() == [0.5 + 1 / 255, 1 + 1 / 255]


SMALL = {f"{table}.{side}": 48 for table in ("camera", "shadow_map") for side in ("width", "height")}


@pytest.fixture(scope="module")
def oracle():
    return render(load_scene("sphere", **SMALL), interpreter="arrays")


def test_a_colour_that_a_texture_cut_off_is_no_error(oracle):
    bright = render(sss_ref.load_scene("sphere", **SMALL, **{"lights.0.intensity": 5.0}), interpreter="arrays")
    assert bright["image"].max() > 1
    cut = np.rint(np.clip(bright["image"], 0, 1) * 255).astype(F) / F(255)
    assert sss_ref.validate(bright, {"image": cut}, {"image": "unorm8"}, explain=False).passed
    assert not sss_ref.validate(bright, {"image": np.minimum(cut, F(0.9))}, {"image": "unorm8"}, explain=False).passed


@pytest.mark.parametrize(("depth_format", "codes"), [("D16", 2**16 - 1), ("D24", 2**24 - 1), ("D32F", None)])
@pytest.mark.parametrize("reversed_depth", [False, True])
def test_depths_in_every_format(oracle, depth_format, codes, reversed_depth):
    profile = replace(VULKAN, depth_format=depth_format, reversed_depth=reversed_depth)
    assert depth_storage(profile) == {"D16": "unorm16", "D24": "unorm24", "D32F": "float32"}[depth_format]
    turned = 1.0 - oracle["depth"].astype(np.float64) if reversed_depth else oracle["depth"].astype(np.float64)
    held = {"depth": (np.floor(turned * codes) / codes if codes else turned).astype(F)}
    assert sss_ref.validate(oracle, held, profile=profile, explain=False).passed
    assert not sss_ref.validate(
        oracle, held, profile=replace(profile, reversed_depth=not reversed_depth), explain=False
    ).passed
    if depth_format == "D16":
        assert not sss_ref.validate(oracle, held, profile=replace(profile, depth_format="D24"), explain=False).passed


def test_a_sampler_may_decode_srgb_by_half_a_code_beside_the_formula():
    codes = srgb_decoded()[[0, 38, 200, 255]][:, np.newaxis]
    read = Drawing({}, {"lit": "srgb8"}).as_read("lit", codes)
    halfway = (F([38.5, 200.5]) / 255 + 0.055) ** 2.4 / 1.055**2.4
    assert np.allclose(read.high[1:3, 0], halfway, atol=1e-6)
    assert (read.low[1:, 0] < codes[1:, 0]).all() and (read.low[0], read.high[3]) == (0.0, 1.0)
    assert Drawing({}, {"lit": "unorm8"}).as_read("lit", codes).low is codes
