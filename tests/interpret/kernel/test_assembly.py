"""Modules in LLVM's language: what they compute is what their Python computes, to the bit."""

import ctypes

import llvmlite.binding as llvm
import numpy as np
import pytest
from numba.core import registry

from sss_ref.cache.linked import address_of_linked, link
from sss_ref.cache.object_files import compiled_module
from sss_ref.interpret.kernel import plain_memory
from sss_ref.interpret.kernel.assembly import assembled
from sss_ref.interpret.kernel.source import StageSource
from sss_ref.methods.stages import all_stages

STAGES = all_stages()
FUNCTION = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int64, *[ctypes.c_void_p] * 3)
COUNT, ROWS = 19, 12
FLOATS = [0.0, -0.0, 1.5, -1.5, 7.0, np.inf, -np.inf, np.nan, 1e-45, 3e38]
NUMBERS = [0, 1, -1, 2**31 - 1, -(2**31), 12345]
HEADER = """
F_0_1 = np.float32(0.1)
F_m0_0 = np.float32(-0.0)
I_m7 = np.int32(-7)


@row_function
def tried(scratch, count, rows, uniforms, tables):
    a_row, b_row, n_row, f_at, i_at, g_at = rows[0], rows[1], rows[2], rows[3], rows[4], rows[5]
    table, bytes_at = tables[0], tables[1]
    scale, turns = read_float(uniforms, 0), read_int(uniforms, 1)
    for k in range(count):
        a = read_float(scratch, a_row + k)
        b = read_float(scratch, b_row + k)
        n = read_int(scratch, n_row + k)
"""
EXPRESSIONS = [
    "a + b * F_0_1", "a / b", "(a - b) * scale", "-a", "F_m0_0 * a", "np.sqrt(a)", "np.floor(b)",
    "chosen(a < b, a, b)", "chosen(a <= b, a, b)", "chosen(a == b, a, scale)", "chosen(a != b, a, scale)",
    "chosen(a > b, scale, a)", "chosen(a >= b, scale, a)", "chosen((a < b) & (n > I_m7), a, b)",
    "chosen((a < b) | (n >= I_m7), a, b)", "chosen((n == I_m7) == (a < b), a, b)", "np.float32(n)", "np.float32(a < b)",
    "texel_float(table, k)", "chosen(texel_byte(bytes_at, k) != 0, a, b)", "chosen(True, a, b)",
]  # fmt: skip
WHOLE_EXPRESSIONS = [
    "np.int32(n + I_m7)", "np.int32(n * n)", "np.int32(n - k)", "np.int32(-n)", "np.int32(a < b)",
    "texel_int(table, k)", "np.int32((n ^ np.int32(k)) | I_m7)", "np.int32(count >> 1)", "chosen(n < I_m7, n, I_m7)",
    "np.int32(b * F_0_1)",
    "np.int32(texel_byte(bytes_at, k))", "chosen(np.int32(n + I_m7) < n, n, I_m7)",
    "chosen((n ^ k) != 0, np.int32(k), n)",
]  # fmt: skip
OUTPUT = {True: "write_float(0, scratch, f_at + k, value)", False: "write_int(1, scratch, i_at + k, value)"}
TURNS = """
    for k in range(count):
        write_float(0, scratch, f_at + k, F_m0_0)
        write_int(1, scratch, i_at + k, I_m7)
    for turn in range(np.int32(1), turns):
        low, high = np.int64(turn), count
        for k in range(low, high):
            value = reread_float(0, scratch, f_at + k)
            number = reread_int(1, scratch, i_at + k)
            value, number = value + read_float(scratch, a_row + k), np.int32(number + turn)
            same = both = value * scale
            write_float(0, scratch, f_at + k, same)
            write_float(2, scratch, g_at + k, both)
            write_int(1, scratch, i_at + k, number)
"""

MORE = """
TWO = 2


def sum_of(pair, more):
    first, n = pair[0] + more, np.float64(pair[1])
    return (first + n) / 3.0


def either(n, bound):
    \"\"\"One of two.\"\"\"
    return bound if n >= bound else np.int64(-1)


def tried(scratch, count, rows, uniforms, tables):
    a_row, b_row, n_row, f_at, i_at, g_at = rows[0], rows[1], rows[2], rows[3], rows[4], rows[5]
    texture, truths, step = tables[0], tables[1], np.float64(tables[2])
    for k in range(count // TWO * TWO):
        n = read_int(scratch, n_row + k)
        pair = texel_float(texture, k), read_float(scratch, b_row + k)
        if n > 0 and k != 3:
            first = np.float64(k)
            total = sum_of((pair[1], pair[0]), n * step + 0.5)
            write_float(0, scratch, f_at + k, np.float32(total * first))
        else:
            write_float(0, scratch, f_at + k, np.float32(sum_of(pair, -step)))
        write_int(1, scratch, i_at + k, np.int32(either(n, k)))
        put_word(texture, k, n)
        put_byte(truths, k, np.uint8(n != 0))
    put_float(texture, count - 1, F_0_1)
"""


def machine_code(text):
    """The function of a module."""
    prefix = f"tested{abs(hash(text))}"
    processor = registry.cpu_target.target_context.codegen().magic_tuple()
    link(compiled_module(assembled(text, prefix), processor))
    return FUNCTION(address_of_linked(f"{prefix}.tried"))


def python(text):
    """The function as Python."""
    namespace = {"np": np, "row_function": lambda function: function, **vars(plain_memory)}
    exec(compile(text, "<tried>", "exec"), namespace)
    return namespace["tried"]


def given():
    """Scratch, rows, uniforms, tables."""
    generator = np.random.default_rng(7)
    scratch = np.zeros((ROWS, COUNT), np.float32)
    scratch[:2] = generator.choice(np.array(FLOATS, np.float32), (2, COUNT))
    scratch.view(np.int32)[2] = generator.choice(np.array(NUMBERS, np.int32), COUNT)
    uniforms = np.array([0.7, 0], np.float32)
    uniforms.view(np.int32)[1] = 4
    return scratch, np.arange(6) * COUNT, uniforms


def in_memory():
    """A texture and an array of bytes, and the tables with their addresses and a number."""
    texture, truths = np.linspace(-3, 3, COUNT, dtype=np.float32), np.arange(COUNT, dtype=np.uint8) % 3 * 100
    return texture, truths, np.array([texture.ctypes.data, truths.ctypes.data, 16])


def same_bits(text):
    """Run both; what they write has the same bits."""
    (*memory, tables), (scratch, rows, uniforms) = in_memory(), given()
    machine_code(text)(scratch.ctypes.data, COUNT, rows.ctypes.data, uniforms.ctypes.data, tables.ctypes.data)
    (*plain_memories, tables), (plain, rows, uniforms) = in_memory(), given()
    with np.errstate(all="ignore"):
        python(text)(plain.reshape(-1), COUNT, rows, uniforms, tables)
    assert [each.tobytes() for each in memory] == [each.tobytes() for each in plain_memories]
    assert np.array_equal(scratch[3:], plain[3:], equal_nan=True)
    finite = ~np.isnan(scratch[3:])
    assert np.array_equal(scratch[3:].view(np.int32)[finite], plain[3:].view(np.int32)[finite])
    assert scratch[3:].view(np.int32).any()


@pytest.mark.filterwarnings("ignore:overflow")
@pytest.mark.parametrize("is_float", [True, False])
def test_expressions_have_the_bits_of_their_python(is_float):
    for expression in EXPRESSIONS if is_float else WHOLE_EXPRESSIONS:
        if "np.int32(b" in expression:
            expression = f"chosen((b < F_0_1) & (b > np.float32(I_m7)), {expression}, I_m7)"
        same_bits(f"{HEADER}        value = {expression}\n        {OUTPUT[is_float]}\n")


def test_loops_have_the_bits_of_their_python():
    same_bits(HEADER.partition("    for k")[0] + TURNS)


def test_choices_functions_and_buffers_have_the_bits_of_their_python():
    same_bits(HEADER.partition("@")[0] + MORE)


def test_rows_that_are_written_are_told_apart():
    """Else no processor would compute several fragments at once."""
    text = assembled(HEADER.partition("    for k")[0] + TURNS, "apart")
    own, others = "!alias.scope !6", "!noalias !7"
    assert [text.count(each) for each in (own, others)] == [3, 3]
    assert "!5 = !{" in text and '!5 = !{!"row 1", !0}' in text
    assert "!6 = !{!5}" in text and "!7 = !{!2, !8}" in text and "!1 = !{!2, !5, !8}" in text


@pytest.mark.parametrize("name", STAGES)
def test_every_stage_is_a_module_that_llvm_takes(name):
    llvm.parse_assembly(assembled(StageSource(STAGES[name], set()).text, "stage")).verify()


def test_what_no_stage_has_is_no_module():
    with pytest.raises(AssertionError, match="while count"):
        assembled(HEADER + "        while count:\n            a = b\n", "none")
