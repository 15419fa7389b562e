"""Functions of rows: what a pass is compiled to is a list of calls of these, all with the same arguments.

scratch: the float32 memory of a strip. count: how many fragments are in it. rows: where the rows of this call begin in
the scratch, int64. uniforms: float32, whole numbers by their bits. tables: int64, addresses and sizes.
"""

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from sss_ref.cache.compiled import SETTINGS, callable_compiled
from sss_ref.interpret.kernel import plain_memory

FLOATS, NUMBERS = types.CPointer(types.float32), types.CPointer(types.int64)
SIGNATURE = types.void(FLOATS, types.int64, NUMBERS, FLOATS, NUMBERS)


def row_function(function: Callable[..., None]) -> Any:
    """Compile a function of rows (decorator); its `address` is what a program calls."""
    return plain_memory.PlainFunction(function) if SETTINGS.DISABLE_JIT else callable_compiled(function, SIGNATURE)


@intrinsic
def call(typingctx, address, scratch, count, rows, first_row, uniforms, first_uniform, tables, first_table):
    """Call the function of rows at an address; rows, uniforms and tables: arrays, each from an element on."""

    def codegen(context, builder, signature, arguments):
        def begin(number, first=None):
            data = context.make_array(signature.args[number])(context, builder, arguments[number]).data
            return data if first is None else builder.gep(data, [arguments[first]])

        values = [begin(1), arguments[2], begin(3, 4), begin(5, 6), begin(7, 8)]
        kind = ir.FunctionType(ir.VoidType(), [value.type for value in values])
        builder.call(builder.inttoptr(arguments[0], ir.PointerType(kind)), values)
        return context.get_dummy_value()

    whole = types.int64
    return types.void(whole, scratch, whole, rows, whole, uniforms, whole, tables, whole), codegen


if SETTINGS.DISABLE_JIT:  # then kernels run as the Python that they are
    call = plain_memory.call
