"""The package's sources, what each imports wherever it stands, and the circles of that graph."""

import ast
from pathlib import Path

import sss_ref

PACKAGE = Path(sss_ref.__file__).parent
SOURCES = sorted(path for path in PACKAGE.rglob("*.py") if "data" not in path.relative_to(PACKAGE).parts)
IDS = {"ids": lambda path: path.relative_to(PACKAGE).as_posix()}  # of a test that runs for every source


def module_name(source, package=PACKAGE):
    """The dotted name; a folder's for its __init__.py."""
    parts = source.relative_to(package.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imported_names(text):
    """All that a source's text imports, at its top, inside functions, for types, and by a name in quotes: dotted names.

    The longest of one import comes last.
    """
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom):
            assert not node.level, "relative imports are not read"
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.Call) and ast.unparse(node.func) == "import_module":
            yield from (given.value for given in node.args if isinstance(given, ast.Constant))


def import_graph(package=PACKAGE):
    """Module -> the modules of the package that it needs: those it imports, and the folders around them.

    The folders that a module lies in are left out: they are on their way when it is imported.
    """
    sources = {module_name(path, package): path for path in sorted(package.rglob("*.py"))}
    graph = {}
    for module, path in sources.items():
        needed = {above for name in imported_names(path.read_text()) for above in _with_folders(name)}
        graph[module] = needed & set(sources) - set(_with_folders(module))
    return graph


def _with_folders(name):
    """a.b.c -> a.b.c, a.b and a."""
    parts = name.split(".")
    return [".".join(parts[:count]) for count in range(len(parts), 0, -1)]


def circles(graph):
    """The groups of modules that need each other, sorted."""
    reached = {module: _reached(graph, module) for module in graph}
    groups = {frozenset(other for other in reached[module] if module in reached[other]) for module in graph}
    return sorted(sorted(group) for group in groups if group)


def _reached(graph, module):
    """Every module that is needed, directly or not; the module itself only if it needs itself in the end."""
    found, ahead = set(), [module]
    while ahead:
        new = graph[ahead.pop()] - found
        found |= new
        ahead += new
    return found
