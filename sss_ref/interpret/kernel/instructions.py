"""Instructions of LLVM's language, written one after the other, and the types that they have.

As in numba, arithmetic of whole numbers is one of 64 bits. Of the language see LLVM's Reference Manual.
"""

import ast
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

BIT, BYTE, WORD, WHOLE, FLOAT, DOUBLE, POINTER = "i1", "i8", "i32", "i64", "float", "double", "ptr"
KINDS = {"np.float32": FLOAT, "np.float64": DOUBLE, "np.int32": WORD, "np.int64": WHOLE, "np.uint8": BYTE}
CONVERSIONS = {
    (BIT, BYTE): "zext",
    (BIT, WORD): "zext",
    (BIT, WHOLE): "zext",
    (BIT, FLOAT): "uitofp",
    (BYTE, WORD): "zext",
    (WORD, WHOLE): "sext",
    (WORD, FLOAT): "sitofp",
    (WORD, DOUBLE): "sitofp",
    (WHOLE, WORD): "trunc",
    (WHOLE, FLOAT): "sitofp",
    (WHOLE, DOUBLE): "sitofp",
    (FLOAT, WORD): "fptosi",
    (FLOAT, WHOLE): "fptosi",
    (FLOAT, DOUBLE): "fpext",
    (DOUBLE, FLOAT): "fptrunc",
}
ByOperator = dict[type[ast.operator], str]
OF_FLOATS: ByOperator = {ast.Add: "fadd", ast.Sub: "fsub", ast.Mult: "fmul", ast.Div: "fdiv"}
OF_BITS: ByOperator = {ast.BitAnd: "and", ast.BitOr: "or", ast.BitXor: "xor"}
OF_WHOLE: ByOperator = {
    ast.Add: "add",
    ast.Sub: "sub",
    ast.Mult: "mul",
    ast.RShift: "ashr",
    ast.FloorDiv: "sdiv",  # the same, as no kernel divides numbers below 0
    **OF_BITS,
}
ORDER = {ast.Lt: "lt", ast.LtE: "le", ast.Gt: "gt", ast.GtE: "ge", ast.Eq: "eq", ast.NotEq: "ne"}
ALL_ROWS = "!1"


class Value(NamedTuple):
    """A value: its type, and the name or number that stands for it."""

    kind: str
    text: str

    def __str__(self) -> str:
        return f"{self.kind} {self.text}"


def constant(kind: str, number: float) -> Value:
    """A number; LLVM writes one of float32 too as the bits of the same number in float64."""
    if kind not in (FLOAT, DOUBLE):
        return Value(kind, str(number))
    rounded = np.float32(number) if kind == FLOAT else np.float64(number)
    return Value(kind, f"0x{np.float64(rounded).view(np.uint64):016x}")


def scopes(rows: int) -> list[str]:
    """What tells apart the rows that a function writes: lists of all, of each one, of all others.

    A kernel gets its rows by their places, so LLVM cannot know that two of them are apart, and would not compute
    several fragments at once. So every access says which row it may touch: one that is written is no other row, and
    nothing that is written is ever a texture, a uniform, or a row that is only read.
    """
    names = [f'!{3 * row + 2} = !{{!"row {row}", !0}}' for row in range(rows)]
    own = [f"{own_row(row)} = !{{!{3 * row + 2}}}" for row in range(rows)]
    others = [f"{other_rows(row)} = !{{{listed(each for each in range(rows) if each != row)}}}" for row in range(rows)]
    return ['!0 = !{!"sss_ref rows"}', f"{ALL_ROWS} = !{{{listed(range(rows))}}}", *names, *own, *others]


def own_row(row: int) -> str:
    """The list of one row."""
    return f"!{3 * row + 3}"


def other_rows(row: int) -> str:
    """The list of all rows but one."""
    return f"!{3 * row + 4}"


def listed(rows: Iterable[int]) -> str:
    """Rows by their names."""
    return ", ".join(f"!{3 * row + 2}" for row in rows)


class Instructions:
    """Lines of a function; rows: how many it writes, as far as they are told apart. block: the label of the last."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.rows = self.counted = 0
        self.block = "entry"

    def fresh(self) -> str:
        """A name for a value or a label."""
        self.counted += 1
        return f"v{self.counted}"

    def named(self, kind: str, instruction: str) -> Value:
        """What an instruction gives, under a name."""
        value = Value(kind, f"%{self.fresh()}")
        self.lines.append(f"{value.text} = {instruction}")
        return value

    def begin(self, label: str) -> None:
        """The next block begins, to which somebody branches."""
        self.lines.append(f"{label}:")
        self.block = label

    def go_to(self, label: str) -> None:
        """End the block."""
        self.lines.append(f"br label %{label}")

    def branch(self, condition: Value, if_true: str, if_false: str) -> None:
        """End the block, in one of two ways."""
        self.lines.append(f"br {condition}, label %{if_true}, label %{if_false}")

    def as_kind(self, kind: str, value: Value) -> Value:
        """A value as one of this type."""
        if value.kind == kind:
            return value
        return self.named(kind, f"{CONVERSIONS[value.kind, kind]} {value} to {kind}")

    def negated(self, value: Value) -> Value:
        """The number of the other sign."""
        if value.kind in (FLOAT, DOUBLE):
            return self.named(value.kind, f"fneg {value}")
        return self.named(WHOLE, f"sub i64 0, {self.as_kind(WHOLE, value).text}")

    def operation(self, operator: type[ast.operator], left: Value, right: Value) -> Value:
        """An operation: of truth values one of bits, of whole numbers one of 64 of them."""
        kinds = {left.kind, right.kind}
        kind = DOUBLE if DOUBLE in kinds else left.kind if kinds in ({FLOAT}, {BIT}) else WHOLE
        instructions = OF_FLOATS if kind in (FLOAT, DOUBLE) else OF_WHOLE
        left, right = self.as_kind(kind, left), self.as_kind(kind, right)
        return self.named(kind, f"{instructions[operator]} {left}, {right.text}")

    def comparison(self, order: str, left: Value, right: Value) -> Value:
        """A comparison; nothing is equal to NaN, nor less or greater."""
        if left.kind in (FLOAT, DOUBLE):
            return self.named(BIT, f"fcmp {'une' if order == 'ne' else 'o' + order} {left}, {right.text}")
        signed = order if order in ("eq", "ne") else f"s{order}"
        return self.named(BIT, f"icmp {signed} {self.as_kind(WHOLE, left)}, {self.as_kind(WHOLE, right).text}")

    def element(self, kind: str, memory: Value, index: Value) -> Value:
        """Where an element lies, of memory that is given by a pointer or an address."""
        if memory.kind == WHOLE:
            memory = self.named(POINTER, f"inttoptr {memory} to ptr")
        return self.named(POINTER, f"getelementptr {kind}, {memory}, {index}")

    def only(self, row: int) -> str:
        """What says that an access touches this row of those that are written, and no other."""
        self.rows = max(self.rows, row + 1)
        return f"!alias.scope {own_row(row)}, !noalias {other_rows(row)}"
