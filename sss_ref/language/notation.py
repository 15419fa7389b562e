"""How a tree reads as source: the Python it came from, on one line."""

from sss_ref.language import tree

# How tightly an operator binds, in Python: comparisons least.
BINDING = {"|": 2, "&": 3, "+": 4, "-": 4, "*": 5, "/": 5, "neg": 6}
COMPARISON, ATOM = 1, 7


def written(expression: tree.Expression) -> str:
    """The source of an expression, with the parentheses that its order of operations needs and no others."""
    match expression:
        case tree.Literal(value=value):
            return repr(value)
        case tree.Constant(name=name) | tree.Variable(name=name):
            return name
        case tree.Member(vector=vector, letters=letters):
            return f"{_inside(vector, ATOM)}.{letters}"
        case tree.Construct(type=kind, parts=parts):
            return f"{kind.__name__}({_listed(parts)})"
        case tree.Element(array=array, index=index):
            return f"{array.name}[{written(index)}]"
        case tree.Call(callee=callee, arguments=arguments):
            return f"{callee.name}({_listed(arguments)})"
        case tree.Operation(operator="neg", operands=(operand,)):
            return f"-{_inside(operand, BINDING['neg'])}"
        case tree.Operation(operator=operator, operands=(left, right)):
            binding = _binding(expression)
            return f"{_inside(left, binding)} {operator} {_inside(right, binding + 1)}"
    raise AssertionError(expression)


def _listed(expressions: tuple[tree.Expression, ...]) -> str:
    return ", ".join(map(written, expressions))


def _inside(expression: tree.Expression, binding: int) -> str:
    """An operand, in parentheses where it binds less than what stands around it."""
    text = written(expression)
    return text if _binding(expression) >= binding else f"({text})"


def _binding(expression: tree.Expression) -> int:
    if not isinstance(expression, tree.Operation):
        return ATOM
    return BINDING.get(expression.operator, COMPARISON)
