"""Rows that a draw fills, and rows that go into buffers: functions of rows that no stage is behind.

assembly.py translates them for LLVM, as it does what is written for stages; without a compiler they run as they are.
"""

from typing import Any

import numpy as np

from sss_ref.interpret.kernel.plain_memory import (
    put_byte,
    put_float,
    put_word,
    read_float,
    read_int,
    reread_float,
    texel_byte,
    texel_float,
    texel_int,
    write_float,
    write_int,
)
from sss_ref.language.types import ivec2

PACK = 8  # columns of a vertex that are interpolated side by side


def beginning(scratch: Any, count: Any, index: Any) -> Any:
    """The first index of a strip, which ascend in the row `index`, if none is left out up to the last, else -1.

    Then what is at the indices lies side by side, and processors move several at once.
    """
    first = np.int64(read_int(scratch, index))
    return first if np.int64(read_int(scratch, index + count - 1)) - first == count - 1 else np.int64(-1)


def numbered(scratch: Any, index: Any, begin: Any, k: Any) -> Any:
    """Index number k of a strip with this `beginning`."""
    return begin + k if begin >= 0 else np.int64(read_int(scratch, index + k))


def take_words(scratch, count, rows, uniforms, tables):
    """Values of 32 bits out of an array: rows index, values; tables: address, columns, first column, values each."""
    address, columns, first, channels = tables[0], tables[1], tables[2], tables[3]
    index, begin = rows[0], beginning(scratch, count, rows[0])
    if columns == 3 and channels == 3:  # all of one fragment at once
        x, y, z = rows[1], rows[2], rows[3]
        for k in range(count):
            place = numbered(scratch, index, begin, k) * 3
            write_int(0, scratch, x + k, texel_int(address, place))
            write_int(1, scratch, y + k, texel_int(address, place + 1))
            write_int(2, scratch, z + k, texel_int(address, place + 2))
    else:
        for channel in range(channels):
            values, column = rows[1 + channel], first + channel
            for k in range(count):
                place = numbered(scratch, index, begin, k) * columns + column
                write_int(0, scratch, values + k, texel_int(address, place))


def take_bytes(scratch, count, rows, uniforms, tables):
    """Truth values out of an array of bytes: rows index, value; tables: address."""
    address, index, value, begin = tables[0], rows[0], rows[1], beginning(scratch, count, rows[0])
    for k in range(count):
        place = numbered(scratch, index, begin, k)
        write_int(0, scratch, value + k, np.int32(texel_byte(address, place)))


def put_words(scratch, count, rows, uniforms, tables):
    """Values of 32 bits into an array: rows index, values; tables as in `take_words`."""
    address, columns, first, channels = tables[0], tables[1], tables[2], tables[3]
    index, begin = rows[0], beginning(scratch, count, rows[0])
    if columns == 3 and channels == 3:
        x, y, z = rows[1], rows[2], rows[3]
        for k in range(count):
            place = numbered(scratch, index, begin, k) * 3
            put_word(address, place, read_int(scratch, x + k))
            put_word(address, place + 1, read_int(scratch, y + k))
            put_word(address, place + 2, read_int(scratch, z + k))
    else:
        for channel in range(channels):
            values, column = rows[1 + channel], first + channel
            for k in range(count):
                place = numbered(scratch, index, begin, k) * columns + column
                put_word(address, place, read_int(scratch, values + k))


def take_whole(scratch, count, rows, uniforms, tables):
    """Whole numbers out of an array of float32, as ivec2 has it; rows and tables as in `take_words`."""
    address, columns, first, channels = tables[0], tables[1], tables[2], tables[3]
    index = rows[0]
    for channel in range(channels):
        values, column = rows[1 + channel], first + channel
        for k in range(count):
            place = np.int64(read_int(scratch, index + k)) * columns + column
            write_int(0, scratch, values + k, np.int32(texel_float(address, place)))


def put_whole(scratch, count, rows, uniforms, tables):
    """Whole numbers into an array of float32, as ivec2 has it; rows and tables as in `take_words`."""
    address, columns, first, channels = tables[0], tables[1], tables[2], tables[3]
    index = rows[0]
    for channel in range(channels):
        values, column = rows[1 + channel], first + channel
        for k in range(count):
            place = np.int64(read_int(scratch, index + k)) * columns + column
            put_float(address, place, np.float32(read_int(scratch, values + k)))


def put_bytes(scratch, count, rows, uniforms, tables):
    """Truth values into an array of bytes: rows index, value; tables: address."""
    address, index, value, begin = tables[0], rows[0], rows[1], beginning(scratch, count, rows[0])
    for k in range(count):
        put_byte(address, numbered(scratch, index, begin, k), np.uint8(read_int(scratch, value + k) != 0))


def clear_words(scratch, count, rows, uniforms, tables):
    """One value of 32 bits a channel into an array: rows index; uniforms: the values; tables as in `take_words`."""
    address, columns, first, channels = tables[0], tables[1], tables[2], tables[3]
    index, begin = rows[0], beginning(scratch, count, rows[0])
    if columns == 3 and channels == 3:
        x, y, z = read_int(uniforms, 0), read_int(uniforms, 1), read_int(uniforms, 2)
        for k in range(count):
            place = numbered(scratch, index, begin, k) * 3
            put_word(address, place, x)
            put_word(address, place + 1, y)
            put_word(address, place + 2, z)
    else:
        for channel in range(channels):
            value, column = read_int(uniforms, channel), first + channel
            for k in range(count):
                put_word(address, numbered(scratch, index, begin, k) * columns + column, value)


def clear_bytes(scratch, count, rows, uniforms, tables):
    """One truth value into an array of bytes: rows index; uniforms: the value; tables: address."""
    address, index, value = tables[0], rows[0], np.uint8(read_int(uniforms, 0) != 0)
    begin = beginning(scratch, count, rows[0])
    for k in range(count):
        put_byte(address, numbered(scratch, index, begin, k), value)


def same(scratch, count, rows, uniforms, tables):
    """One value for all fragments: rows value; uniforms: the value."""
    row, value = rows[0], read_int(uniforms, 0)
    for k in range(count):
        write_int(0, scratch, row + k, value)


def triangle(scratch, count, rows, uniforms, tables):
    """The scene triangle of each fragment: rows index, triangle; tables: address of the pieces, and of theirs."""
    piece, triangles, index, value = tables[0], tables[1], rows[0], rows[1]
    for k in range(count):
        here = texel_int(piece, read_int(scratch, index + k))
        write_int(0, scratch, value + k, texel_int(triangles, here))


def weights(scratch, count, rows, uniforms, tables):
    """The corners of each fragment's piece, their weights and the sum of these (rule R5).

    rows: index, column, row, three corners, three weights, sum. tables: the addresses of pieces, corners, snapped
    positions and inverse w, then the step. The edge functions are those of raster.coverage, seen from the sample: whole
    numbers below 2^53, exact in float64 too, which processors have side by side. No zero of them is negative.
    """
    piece, corners, snapped, inverse_w, step = tables[0], tables[1], tables[2], tables[3], np.float64(tables[4])
    index, column, row = rows[0], rows[1], rows[2]
    corner_a, corner_b, corner_c = rows[3], rows[4], rows[5]
    weight_a, weight_b, weight_c, total = rows[6], rows[7], rows[8], rows[9]
    for k in range(count):
        here = texel_int(piece, read_int(scratch, index + k)) * np.int64(3)
        a, b, c = texel_int(corners, here), texel_int(corners, here + 1), texel_int(corners, here + 2)
        x, y = read_int(scratch, column + k) * step, read_int(scratch, row + k) * step
        ax, ay = texel_int(snapped, np.int64(a) * 2) - x, texel_int(snapped, np.int64(a) * 2 + 1) - y
        bx, by = texel_int(snapped, np.int64(b) * 2) - x, texel_int(snapped, np.int64(b) * 2 + 1) - y
        cx, cy = texel_int(snapped, np.int64(c) * 2) - x, texel_int(snapped, np.int64(c) * 2 + 1) - y
        edge_a, edge_b, edge_c = bx * cy - cx * by, cx * ay - ax * cy, ax * by - bx * ay
        turn = -1.0 if edge_a + edge_b + edge_c < 0.0 else 1.0
        wa = np.float32(turn * edge_a + 0.0) * texel_float(inverse_w, a)
        wb = np.float32(turn * edge_b + 0.0) * texel_float(inverse_w, b)
        wc = np.float32(turn * edge_c + 0.0) * texel_float(inverse_w, c)
        write_int(0, scratch, corner_a + k, a)
        write_int(1, scratch, corner_b + k, b)
        write_int(2, scratch, corner_c + k, c)
        write_float(3, scratch, weight_a + k, wa)
        write_float(4, scratch, weight_b + k, wb)
        write_float(5, scratch, weight_c + k, wc)
        write_float(6, scratch, total + k, (wa + wb) + wc)


def mixed(values: Any, weights: Any, total: Any) -> Any:
    """What is interpolated (rule R5), from the three corners' values and weights."""
    return ((values[0] * weights[0] + values[1] * weights[1]) + values[2] * weights[2]) / total


def varying(scratch, count, rows, uniforms, tables):
    """What is interpolated: rows the seven of `weights`, then the values; tables as in `take_words`."""
    address, columns, first, channels = tables[0], tables[1], tables[2], tables[3]
    a, b, c, wa, wb, wc, total = rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6]
    for channel in range(channels):
        value, column = rows[7 + channel], first + channel
        for k in range(count):
            at_a = texel_float(address, np.int64(read_int(scratch, a + k)) * columns + column)
            at_b = texel_float(address, np.int64(read_int(scratch, b + k)) * columns + column)
            at_c = texel_float(address, np.int64(read_int(scratch, c + k)) * columns + column)
            weights = read_float(scratch, wa + k), read_float(scratch, wb + k), read_float(scratch, wc + k)
            write_float(0, scratch, value + k, mixed((at_a, at_b, at_c), weights, read_float(scratch, total + k)))


def varying_pack(scratch, count, rows, uniforms, tables):
    """PACK columns that lie side by side in a vertex: rows as in `varying`, then a `Program.block` of as many.

    tables as in `take_words`; since PACK is among them, the loop over the columns stays a loop, which LLVM computes at
    once. What it gives fragment after fragment is then sorted into rows.
    """
    address, columns, first, channels = tables[0], tables[1], tables[2], tables[3]
    a, b, c, wa, wb, wc, total, pack = rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[15]
    for k in range(count):
        at_a = np.int64(read_int(scratch, a + k)) * columns + first
        at_b = np.int64(read_int(scratch, b + k)) * columns + first
        at_c = np.int64(read_int(scratch, c + k)) * columns + first
        weights = read_float(scratch, wa + k), read_float(scratch, wb + k), read_float(scratch, wc + k)
        for channel in range(channels // PACK * PACK):
            values = (
                texel_float(address, at_a + channel),
                texel_float(address, at_b + channel),
                texel_float(address, at_c + channel),
            )
            value = mixed(values, weights, read_float(scratch, total + k))
            write_float(8, scratch, pack + k * PACK + channel, value)
    row_0, row_1, row_2, row_3 = rows[7], rows[8], rows[9], rows[10]
    row_4, row_5, row_6, row_7 = rows[11], rows[12], rows[13], rows[14]
    for k in range(count):
        place = pack + k * PACK
        write_float(0, scratch, row_0 + k, reread_float(8, scratch, place))
        write_float(1, scratch, row_1 + k, reread_float(8, scratch, place + 1))
        write_float(2, scratch, row_2 + k, reread_float(8, scratch, place + 2))
        write_float(3, scratch, row_3 + k, reread_float(8, scratch, place + 3))
        write_float(4, scratch, row_4 + k, reread_float(8, scratch, place + 4))
        write_float(5, scratch, row_5 + k, reread_float(8, scratch, place + 5))
        write_float(6, scratch, row_6 + k, reread_float(8, scratch, place + 6))
        write_float(7, scratch, row_7 + k, reread_float(8, scratch, place + 7))


TAKES, PUTS = {bool: take_bytes, ivec2: take_whole}, {bool: put_bytes, ivec2: put_whole}  # else: take_words, put_words
MOVES = (take_words, take_bytes, take_whole, put_words, put_bytes, put_whole, clear_words, clear_bytes)
ALL = (*MOVES, same, triangle, weights, varying, varying_pack)
