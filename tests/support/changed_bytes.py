"""Files with something changed at random, as bytes: what a broken disk, a cut transfer or an enemy makes of them."""

import struct

from changed_values import picked

LONGEST = 4096  # bytes that are inserted or doubled
HEADER = 512  # bytes in which numbers are changed more often
WORDS = [
    *(struct.pack("<I", each) for each in (0, 1, 2, 0x7F, 0xFF, 0xFFFF, 2**31 - 1, 2**31, 2**32 - 1)),
    *(struct.pack("<H", each) for each in (0, 1, 0xFF, 0x7FFF, 0xFFFF)),
    *(struct.pack("<q", each) for each in (-1, 2**40, 2**63 - 1)),
    *(struct.pack("<f", each) for each in (float("nan"), float("inf"), -float("inf"), 3e38, 1e-40)),
]


def one_bit(rng, data):
    """A bit turned."""
    at = rng.randrange(len(data))
    return data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1 :]


def one_byte(rng, data):
    """A byte replaced."""
    at = rng.randrange(len(data))
    return data[:at] + bytes([picked(rng, (0, 1, 9, 10, 13, 32, 127, 128, 255, rng.randrange(256)))]) + data[at + 1 :]


def cut_off(rng, data):
    """The end is missing."""
    return data[: rng.randrange(len(data))]


def beginning_lost(rng, data):
    """The beginning is missing."""
    return data[rng.randrange(min(len(data), HEADER)) :]


def part_lost(rng, data):
    """A part is missing."""
    first, last = part(rng, data)
    return data[:first] + data[last:]


def part_twice(rng, data):
    """A part is there twice or thrice."""
    first, last = part(rng, data)
    return data[:last] + data[first:last] * rng.randint(1, 2) + data[last:]


def parts_swapped(rng, data):
    """A part stands elsewhere."""
    first, last = part(rng, data)
    rest = data[:first] + data[last:]
    at = rng.randrange(len(rest) + 1)
    return rest[:at] + data[first:last] + rest[at:]


def junk_inserted(rng, data):
    """Bytes at random, or many times the same."""
    at, count = rng.randrange(len(data) + 1), rng.randrange(1, 64)
    return data[:at] + picked(rng, (rng.randbytes(count), bytes([rng.randrange(256)]) * count)) + data[at:]


def word_replaced(rng, data):
    """A number of two to eight bytes has an extreme value, mostly one of the header."""
    reach = picked(rng, (len(data), HEADER, HEADER))
    word = picked(rng, WORDS)
    word = picked(rng, (word, word, word[::-1]))
    at = rng.randrange(max(min(len(data), reach) - len(word), 1))
    at -= at % picked(rng, (1, len(word)))
    return data[:at] + word + data[at + len(word) :]


def part(rng, data):
    """Where a part begins and ends."""
    first = rng.randrange(len(data))
    return first, min(len(data), first + 1 + int(LONGEST ** rng.random()))


CHANGES = (
    *(one_bit, one_byte, cut_off, beginning_lost, part_lost),
    *(part_twice, parts_swapped, junk_inserted, word_replaced, word_replaced),
)
