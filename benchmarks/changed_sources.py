"""The mutants of the package: each of its sources with an operator, a comparison, a number or a truth value changed."""

import ast
import copy
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1] / "sss_ref"
SWAPPED = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.Add: ast.Sub, ast.Sub: ast.Add,
    ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult, ast.And: ast.Or, ast.Or: ast.And,
    ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.RShift: ast.LShift, ast.LShift: ast.RShift,
}  # fmt: skip
OF_A_ROW = ("write_float", "write_int", "reread_float", "reread_int")  # see interpret/kernel/plain_memory.py


@dataclass(frozen=True, eq=False)
class Mutant:
    """A source with one place changed."""

    path: Path  # relative to the package
    text: str  # of the file
    statement: ast.stmt | None  # of a function, which the place is in; None: it is computed when the file is imported
    node: ast.expr
    changed: ast.expr

    def __str__(self) -> str:
        before = " ".join((ast.get_source_segment(self.text, self.node) or "").split())
        return f"{self.path}:{self.node.lineno}: {before} -> {ast.unparse(self.changed)} | {self.changed_line}"

    @property
    def source(self) -> str:
        """The whole file, changed."""
        lines = self.text.splitlines(keepends=True)
        first, last = self.node.lineno - 1, self.node.end_lineno - 1
        head = lines[first].encode()[: self.node.col_offset].decode()
        tail = lines[last].encode()[self.node.end_col_offset :].decode()
        return "".join([*lines[:first], head, f"({ast.unparse(self.changed)})", tail, *lines[last + 1 :]])

    @property
    def changed_line(self) -> str:
        """The line of the place, without its indentation."""
        return self.source.splitlines()[self.node.lineno - 1].strip()

    @property
    def executed(self) -> range:
        """The lines of which one is executed with the place: those of its statement, without the statements in that."""
        if self.statement is None:
            return range(0)
        inner = [each.lineno for each in ast.walk(self.statement) if isinstance(each, ast.stmt)][1:]
        first, end = self.statement.lineno, self.statement.end_lineno + 1
        return range(first, max(first + 1, min(inner, default=end)))

    @property
    def room(self) -> str:
        """The folder that it is in, or the file outside of all."""
        return self.path.parts[0]


def sources(places: list[Path]) -> Iterator[Path]:
    """The files of the package that are meant, relative to it."""
    for place in map(PACKAGE.joinpath, places or [Path()]):
        for path in sorted(place.rglob("*.py")) if place.is_dir() else [place]:
            yield path.relative_to(PACKAGE)


def mutants(path: Path) -> Iterator[Mutant]:
    """Every mutant of a file."""
    text = (PACKAGE / path).read_text(encoding="utf-8")
    tree = ast.parse(text)
    same = {id(each) for each in lengths_left(tree)}
    for node, statement in computed(tree, None, False):
        for changed in changes(node) if id(node) not in same else ():
            yield Mutant(path, text, statement, node, changed)


def lengths_left(tree: ast.AST) -> Iterator[ast.expr]:
    """The 1 of every reshape(-1): NumPy takes any number below 0 for the length that is left, so -2 is the same."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "reshape":
            yield from (each.operand for each in node.args if isinstance(each, ast.UnaryOp))


def computed(node: ast.AST, statement: ast.stmt | None, is_called: bool) -> Iterator[tuple[ast.AST, ast.stmt | None]]:
    """Every expression of a tree outside types and decorators, with its statement where that is of a function's body.

    statement: which the node is of; is_called: whether a function has to be called for it.
    """
    apart = {id(each) for each in [*not_computed(node), *([] if is_called else union_type(node))]}
    body = {id(each) for each in node.body} if isinstance(node, ast.FunctionDef) else set()
    for child in ast.iter_child_nodes(node):
        if id(child) not in apart:
            inside = is_called or id(child) in body
            within = child if isinstance(child, ast.stmt) else statement
            yield child, within if inside else None
            yield from computed(child, within, inside)


def not_computed(node: ast.AST) -> list[ast.AST]:
    """What of a node says a type, how a function is made, that lengths agree, or to LLVM what is apart.

    That is a row's number among those that a kernel writes: with another one LLVM knows more or less of the memory, and
    the same is written.
    """
    found = [getattr(node, "annotation", None), getattr(node, "returns", None), *getattr(node, "decorator_list", [])]
    if isinstance(node, ast.Call) and ast.unparse(node.func) == "zip":
        found += node.keywords
    if isinstance(node, ast.Call) and ast.unparse(node.func) in OF_A_ROW:
        found += node.args[:1]
    return [each for each in found if each]


def union_type(node: ast.AST) -> list[ast.AST]:
    """The A | B that a node gives a name to; outside of functions it is a type, but with a dictionary in it."""
    value = node.value if isinstance(node, ast.Assign) else node
    is_union = isinstance(value, ast.BinOp) and isinstance(value.op, ast.BitOr)
    is_type = is_union and not any(isinstance(each, ast.Dict | ast.DictComp) for each in ast.walk(value))
    return [value] if is_type else []


def changes(node: ast.AST) -> Iterator[ast.AST]:
    """The same expression with its own operator, comparison or value changed."""
    if isinstance(node, ast.BinOp | ast.BoolOp) and type(node.op) in SWAPPED:
        yield changed_copy(node, op=SWAPPED[type(node.op)]())
    elif isinstance(node, ast.Compare) and type(node.ops[0]) in SWAPPED:
        yield changed_copy(node, ops=[SWAPPED[type(node.ops[0])](), *node.ops[1:]])
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not | ast.USub):
        yield node.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield changed_copy(node, value=not node.value)
    elif isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        yield changed_copy(node, value=node.value + 1 if node.value + 1 != node.value else node.value * 2)


def changed_copy(node: ast.AST, **fields: object) -> ast.AST:
    """A copy of a node with some fields replaced."""
    other = copy.copy(node)
    for name, value in fields.items():
        setattr(other, name, value)
    return other
