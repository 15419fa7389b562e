"""Philox gives the published words, and a stream gives the words of its block, in order."""

import numpy as np
import pytest

from sss_ref.numerics.random_numbers import (
    new_stream,
    one_of_each_run,
    philox,
    philox_words,
    restart,
    uniform,
    whole_numbers,
)

# The authors' own known answers for philox4x32, 10 rounds (Random123, kat_vectors): counter, key, words.
PI = "243f6a88 85a308d3 13198a2e 03707344", "a4093822 299f31d0", "d16cfe09 94fdcceb 5001e420 24126ea1"
KNOWN = [
    (" ".join(["00000000"] * 4), " ".join(["00000000"] * 2), "6627e8d5 e169c58d bc57ac4c 9b00dbd8"),
    (" ".join(["ffffffff"] * 4), " ".join(["ffffffff"] * 2), "408f276d 41c83b0e a20bc7c6 6d5451fd"),
    PI,
]


def words(text):
    return tuple(np.uint64(int(word, 16)) for word in text.split())


@pytest.mark.parametrize(("counter", "key", "expected"), KNOWN)
@pytest.mark.parametrize("run", [philox, philox_words], ids=["compiled", "plain"])
def test_known_answers(run, counter, key, expected):
    assert tuple(map(int, run(words(counter), words(key)))) == tuple(map(int, words(expected)))


def test_a_stream_counts_blocks_in_the_low_half_and_its_item_in_the_high_half():
    seed, item = 0xA4093822299F31D0, 0x0123456789ABCDEF
    stream = new_stream(seed, item)
    drawn = [uniform(stream) for _ in range(12)]
    key = words("299f31d0 a4093822")
    for block in range(3):
        expected = philox((np.uint64(block), np.uint64(0), *words("89abcdef 01234567")), key)
        assert drawn[4 * block : 4 * block + 4] == [(int(word) + 0.5) / 2**32 for word in expected]


def test_a_restarted_stream_is_a_new_one():
    stream = new_stream(7)
    first = [uniform(stream) for _ in range(5)]
    restart(stream, 1)
    assert [uniform(stream) for _ in range(5)] == [uniform(other) for other in [new_stream(7, 1)] for _ in range(5)]
    restart(stream, 0)
    assert [uniform(stream) for _ in range(5)] == first


@pytest.mark.parametrize("seed", [0, 0xA4093822299F31D0])
def test_whole_numbers_are_what_the_streams_of_their_places_begin_with(seed):
    low, high = np.array([0, 5, -3, 7, 0]), np.array([10, 6, 3, 1000, 2**32 - 1])
    first = [int(uniform(new_stream(seed, item)) * 2**32) for item in range(5)]
    expected = [a + (word * (b - a) >> 32) for word, a, b in zip(first, low.tolist(), high.tolist(), strict=True)]
    assert whole_numbers(low, high, seed).tolist() == expected
    assert (whole_numbers(low, high).tolist() == expected) is (seed == 0)


def test_whole_numbers_reach_both_ends_of_their_range_and_no_further():
    found = whole_numbers(np.full(4000, -2), np.full(4000, 3))
    assert found.dtype == np.int64
    assert (np.bincount(found + 2, minlength=5) > 700).all() and set(found.tolist()) == {-2, -1, 0, 1, 2}
    assert whole_numbers(np.zeros(0, np.int64), np.zeros(0, np.int64)).tolist() == []


@pytest.mark.parametrize(("length", "count"), [(1000, 7), (13, 12), (5, 5), (9, 1), (3, 0), (0, 0)])
def test_one_place_is_taken_of_each_run(length, count):
    found = one_of_each_run(length, count).tolist()
    runs = [range(k * length // count, (k + 1) * length // count) for k in range(count)]
    assert len(found) == count
    assert all(place in run for place, run in zip(found, runs, strict=True))
    first, end = (np.array([getattr(run, name) for run in runs], np.int64) for name in ("start", "stop"))
    assert found == whole_numbers(first, end).tolist()
