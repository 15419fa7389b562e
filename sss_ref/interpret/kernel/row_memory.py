"""Memory as kernels see it: rows of the scratch, uniforms and textures, each read by an address and a number.

A kernel gets its rows by their places, so the compiler cannot know that two of them are apart, and would not compute
several pixels at once. So every access says here which row it may touch: a row that is written is no other row, and
nothing that is written is ever a texture, a uniform, or a row that is only read.
"""

from collections.abc import Iterable
from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from sss_ref.cache.compiled import SETTINGS
from sss_ref.interpret.kernel import plain_memory

SCOPES = 64  # rows written by one kernel that are told apart
DOMAIN = "sss_ref rows"
WORD, FLOAT, BYTE = ir.IntType(32), ir.FloatType(), ir.IntType(8)
ANY_ROW = range(SCOPES)


def _scopes(builder: Any, rows: Iterable[int]) -> Any:
    """The metadata that names some of the rows that a kernel writes."""
    module = builder.module
    domain = module.add_metadata([DOMAIN])
    return module.add_metadata([module.add_metadata([f"row {row}", domain]) for row in rows])


def _bytes(kind: Any) -> int:
    return 1 if kind is BYTE else 4


def _place(builder: Any, memory: Any, index: Any, kind: Any) -> Any:
    pointer = builder.bitcast(memory, ir.PointerType(kind))
    return builder.gep(pointer, [index], source_etype=kind)


def _load(builder: Any, place: Any, kind: Any) -> Any:
    """Read what no kernel writes while it runs."""
    value = builder.load(place, typ=kind, align=_bytes(kind))
    value.set_metadata("noalias", _scopes(builder, ANY_ROW))
    return value


def _own(builder: Any, access: Any, row: int) -> None:
    """Say that an access touches this row of those that are written, and no other."""
    access.set_metadata("alias.scope", _scopes(builder, [row % SCOPES]))
    access.set_metadata("noalias", _scopes(builder, [each for each in ANY_ROW if each != row % SCOPES]))


def _reader(result: Any, kind: Any) -> Any:
    """A function (memory, index) that reads a number of this kind from memory that is only read."""

    @intrinsic
    def read(typingctx, memory, index):
        def codegen(context, builder, signature, arguments):
            return _load(builder, _place(builder, arguments[0], arguments[1], kind), kind)

        return result(memory, types.int64), codegen

    return read


def _texel(result: Any, kind: Any) -> Any:
    """A function (address, index) that reads a number of this kind from a texture or array at an address."""

    @intrinsic
    def texel(typingctx, address, index):
        def codegen(context, builder, signature, arguments):
            memory = builder.inttoptr(arguments[0], ir.PointerType(kind))
            return _load(builder, _place(builder, memory, arguments[1], kind), kind)

        return result(types.int64, index), codegen

    return texel


def _writer(value: Any, kind: Any) -> Any:
    """A procedure (row, memory, index, value); row: a literal, the number among the rows that this kernel writes."""

    @intrinsic(prefer_literal=True)
    def write(typingctx, row, memory, index, written):
        def codegen(context, builder, signature, arguments):
            _, pointer, place, number = arguments
            _own(builder, builder.store(number, _place(builder, pointer, place, kind), align=4), row.literal_value)
            return context.get_dummy_value()

        return types.void(row, memory, types.int64, value), codegen

    return write


def _reread(result: Any, kind: Any) -> Any:
    """A function (row, memory, index) that reads a row which this kernel writes."""

    @intrinsic(prefer_literal=True)
    def read(typingctx, row, memory, index):
        def codegen(context, builder, signature, arguments):
            value = builder.load(_place(builder, arguments[1], arguments[2], kind), typ=kind, align=4)
            _own(builder, value, row.literal_value)
            return value

        return result(row, memory, types.int64), codegen

    return read


read_float, read_int = _reader(types.float32, FLOAT), _reader(types.int32, WORD)
write_float, write_int = _writer(types.float32, FLOAT), _writer(types.int32, WORD)
reread_float, reread_int = _reread(types.float32, FLOAT), _reread(types.int32, WORD)
texel_float, texel_int, texel_byte = (
    _texel(types.float32, FLOAT),
    _texel(types.int32, WORD),
    _texel(types.uint8, BYTE),
)


def _putter(number: Any, kind: Any) -> Any:
    """A procedure (address, index, value) that writes into a buffer, which no kernel reads meanwhile."""

    @intrinsic
    def put(typingctx, address, index, value):
        def codegen(context, builder, signature, arguments):
            memory = builder.inttoptr(arguments[0], ir.PointerType(kind))
            place = _place(builder, memory, arguments[1], kind)
            _own(builder, builder.store(arguments[2], place, align=_bytes(kind)), 0)
            return context.get_dummy_value()

        return types.void(types.int64, index, number), codegen

    return put


put_float, put_word = _putter(types.float32, FLOAT), _putter(types.int32, WORD)
put_byte = _putter(types.uint8, BYTE)


@intrinsic
def chosen(typingctx, condition, if_true, if_false):
    """`if_true if condition else if_false`, without a branch."""

    def codegen(context, builder, signature, arguments):
        return builder.select(*arguments)

    return if_true(types.boolean, if_true, if_true), codegen


if SETTINGS.DISABLE_JIT:  # then kernels run as the Python that they are
    chosen = plain_memory.chosen
    read_float, read_int = plain_memory.read_float, plain_memory.read_int
    reread_float, reread_int = plain_memory.reread_float, plain_memory.reread_int
    write_float, write_int = plain_memory.write_float, plain_memory.write_int
    texel_float, texel_int, texel_byte = plain_memory.texel_float, plain_memory.texel_int, plain_memory.texel_byte
    put_float, put_word, put_byte = plain_memory.put_float, plain_memory.put_word, plain_memory.put_byte
