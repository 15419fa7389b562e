"""Random numbers that are a function of a seed, of who draws, and of how often it has drawn: no state is shared.

Philox4x32-10 of Salmon, Moraes, Dror and Shaw, "Parallel Random Numbers: As Easy as 1, 2, 3" (SC 2011): ten rounds turn
a counter of 128 bits and a key of 64 into four words of 32 bits. Here the key is the seed; the counter is the number
of the photon or sample that draws, and the number of the block of four words.
"""

from typing import Any

import numpy as np

from sss_ref.cache.compiled import compiled

ROUNDS = 10
MULTIPLIER_0, MULTIPLIER_1 = np.uint64(0xD2511F53), np.uint64(0xCD9E8D57)
WEYL_0, WEYL_1 = np.uint64(0x9E3779B9), np.uint64(0xBB67AE85)
LOW, HALF = np.uint64(0xFFFFFFFF), np.uint64(32)  # a word of 64 bits holds 32, so that products fit
ONE, LANES, LANE_BITS = np.uint64(1), np.uint64(3), np.uint64(2)
UNIT = 1.0 / 4294967296.0
DRAWN, ITEM, SEED, WORDS = 0, 1, 2, 3  # the places of a stream


def new_stream(seed: int, item: int = 0) -> np.ndarray:
    """The numbers of one photon or sample, from the first: uint64 (7,), see `restart`. seed, item: below 2^64."""
    return np.array([0, item, seed, 0, 0, 0, 0], np.uint64)


@compiled
def restart(stream, item):
    """Let a stream give the numbers of another photon or sample, from the first."""
    stream[DRAWN] = np.uint64(0)
    stream[ITEM] = np.uint64(item)


@compiled
def uniform(stream):
    """The next number of a stream: (w + 1/2) / 2^32 for a word w, so above 0 and below 1."""
    drawn = stream[DRAWN]
    lane = drawn & LANES
    if lane == np.uint64(0):
        refill(stream, drawn >> LANE_BITS)
    stream[DRAWN] = drawn + ONE
    return (np.float64(stream[WORDS + np.int64(lane)]) + 0.5) * UNIT


@compiled
def refill(stream, block):
    """Put the four words of a block into a stream."""
    item, seed = stream[ITEM], stream[SEED]
    counter = (block & LOW, block >> HALF, item & LOW, item >> HALF)
    words = philox(counter, (seed & LOW, seed >> HALF))
    stream[WORDS], stream[WORDS + 1], stream[WORDS + 2], stream[WORDS + 3] = words


def whole_numbers(low: np.ndarray, high: np.ndarray, seed: int = 0) -> np.ndarray:
    """One whole number of each range, low <= n < high: low + floor(w (high - low) / 2^32), int64 (N,).

    low, high: int64 (N,), less than 2^32 apart. The word w is the first of the stream of the item of the range's place.
    """
    item = np.arange(len(low), dtype=np.uint64)
    first = np.zeros_like(item)
    word, *_ = philox_words((first, first, item, first), (np.uint64(seed) & LOW, np.uint64(seed) >> HALF))
    found: np.ndarray = low + (word * (high - low).astype(np.uint64) >> HALF).astype(np.int64)
    return found


def one_of_each_run(length: int, count: int) -> np.ndarray:
    """Of places 0 to length - 1 a random one of each of `count` runs of them, ascending, int64 (count,).

    A run is as long as the next, or one longer; of fewer places than runs each comes as often as another, or once more.
    """
    edges = np.arange(count + 1, dtype=np.int64) * length // max(count, 1)
    return whole_numbers(edges[:-1], edges[1:])


def philox_words(counter: Any, key: Any) -> Any:
    """Four words for a counter of four and a key of two; each a uint64 below 2^32."""
    a, b, c, d = counter
    key_0, key_1 = key
    for _ in range(ROUNDS):
        product_0, product_1 = MULTIPLIER_0 * a, MULTIPLIER_1 * c
        a, c = (product_1 >> HALF) ^ b ^ key_0, (product_0 >> HALF) ^ d ^ key_1
        b, d = product_1 & LOW, product_0 & LOW
        key_0, key_1 = (key_0 + WEYL_0) & LOW, (key_1 + WEYL_1) & LOW
    return a, b, c, d


philox = compiled(philox_words)
