"""The scratch as the elementary functions see it, which numba compiles: rows, each read or written by its place.

The compiler cannot know that two rows are apart, and would not compute several elements at once. So every access says
here that what is written is never what is read. All else that kernels touch is in the language of assembly.py.
"""

from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from sss_ref.cache.compiled import SETTINGS
from sss_ref.interpret.kernel import plain_memory

FLOAT = ir.FloatType()


def _written(builder: Any) -> Any:
    """The metadata that names the rows which a kernel writes."""
    module = builder.module
    domain = module.add_metadata(["sss_ref rows"])
    return module.add_metadata([module.add_metadata(["written", domain])])


@intrinsic
def read_float(typingctx, memory, index):
    """A float32 that the kernel does not write."""

    def codegen(context, builder, signature, arguments):
        memory, index = arguments
        value = builder.load(builder.gep(memory, [index], source_etype=FLOAT), typ=FLOAT, align=4)
        value.set_metadata("noalias", _written(builder))
        return value

    return types.float32(memory, types.int64), codegen


@intrinsic
def write_float(typingctx, row, memory, index, value):
    """Write a float32 into a row; row: its number among those that the kernel writes."""

    def codegen(context, builder, signature, arguments):
        _, memory, index, number = arguments
        access = builder.store(number, builder.gep(memory, [index], source_etype=FLOAT), align=4)
        access.set_metadata("alias.scope", _written(builder))
        return context.get_dummy_value()

    return types.void(row, memory, types.int64, types.float32), codegen


@intrinsic
def chosen(typingctx, condition, if_true, if_false):
    """`if_true if condition else if_false`, without a branch."""

    def codegen(context, builder, signature, arguments):
        return builder.select(*arguments)

    return if_true(types.boolean, if_true, if_true), codegen


if SETTINGS.DISABLE_JIT:  # then kernels run as the Python that they are
    chosen, read_float, write_float = plain_memory.chosen, plain_memory.read_float, plain_memory.write_float
