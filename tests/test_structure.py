"""What holds for all sources at once: which way they import, how large they are, and that nothing is left over."""

import ast
import inspect
import re
import subprocess
import sys
from collections import Counter
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from pkgutil import iter_modules

import pytest
from alternatives import all_methods
from package_sources import PACKAGE, SOURCES, circles, import_graph, imported_names, module_name

import sss_ref.passes
from sss_ref.methods.stages import all_stages
from sss_ref.passes.buffers import BUFFERS, described, entry_of

ROOT = Path(__file__).parents[1]
STAGES = all_stages()

ROOMS = [  # from the ground up: whoever stands higher imports from those below
    *("rules", "errors", "cache", "numerics", "language", "scene_file", "view", "mesh", "passes", "methods", "raster"),
    *(
        "interpret",
        "scene",
        "rendering",
        "pictures",
        "results",
        "batch",
        "dump",
        "capture",
        "truth",
        "yardstick",
        "explanation",
        "bundle",
        "validation",
        "neutral",
    ),
    *("gl", "webgl", "webgpu", "blame", "viewer", "course", "cli", "pytest_plugin"),
    "__main__",
]
BACK_DOORS = {("sss_ref.rendering.result", "results")}  # Result.save

# What is still to be mended. Whoever mends one deletes its line: a line without its cause fails too.
UPWARD: set[tuple[str, str]] = set()
CIRCLES: list[str] = []
TWICE: set[str] = set()


def room_of(module):
    """The folder or file right below the package that a module belongs to; "" for the package itself."""
    return module.partition(".")[2].partition(".")[0]


def test_every_room_has_its_floor():
    assert sorted(ROOMS) == sorted({room_of(module_name(source)) for source in SOURCES} - {""})


def test_rooms_import_downwards_only():
    """Imports inside functions and for types count; what the package itself offers is loaded when it is asked for."""
    upward = {
        (module, room_of(needed))
        for module, all_needed in import_graph().items()
        for needed in all_needed
        if room_of(module) and ROOMS.index(room_of(needed)) > ROOMS.index(room_of(module))
    }
    assert upward == UPWARD | BACK_DOORS


@pytest.mark.parametrize("room", ROOMS)
def test_no_file_of_a_room_needs_itself(room):
    """Between rooms there is no circle where all import downwards only."""
    graph = {module: needed for module, needed in import_graph().items() if room_of(module) == room}
    inside = {module: needed & set(graph) for module, needed in graph.items()}
    told = [
        f"sss_ref.{room}: {', '.join(each.removeprefix(f'sss_ref.{room}.') for each in circle)}"
        for circle in circles(inside)
    ]
    assert told == [each for each in CIRCLES if each.startswith(f"sss_ref.{room}:")]


def test_circles_are_found_wherever_the_imports_stand(tmp_path):
    """One of a and b imports in a function, one for types; c needs them unneeded; e comes with its folder."""
    package = tmp_path / "toy"
    (package / "inner").mkdir(parents=True)
    texts = {
        "__init__": "import toy.c",
        "a": "def f():\n    from toy import b",
        "b": "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from toy.a import f",
        "c": "import toy.a",
        "d": "import toy.inner.f",
        "inner/__init__": "from toy.inner.e import x",
        "inner/e": "import toy.d",
        "inner/f": "import toy.inner",
    }
    for name, text in texts.items():
        (package / f"{name}.py").write_text(text)
    assert circles(import_graph(package)) == [["toy.a", "toy.b"], ["toy.d", "toy.inner", "toy.inner.e"]]


def test_no_name_is_used_twice():
    classes = [
        node.name
        for source in SOURCES
        for node in ast.walk(ast.parse(source.read_text()))
        if isinstance(node, ast.ClassDef)
    ]
    stems = [source.stem for source in SOURCES if source.stem not in ("__init__", "__main__")]
    assert {name for names in (classes, stems) for name, count in Counter(names).items() if count > 1} == TWICE


def test_no_test_is_imported_by_another():
    """What two of them need lies in tests/support."""
    for path in sorted(Path(__file__).parent.rglob("*.py")):
        imported = list(imported_names(path.read_text()))
        assert not [name for name in imported if re.search(r"(^|\.)(test_|conftest)", name)], path


OUTSIDE = [
    path
    for folder in ("benchmarks", "data/generate", "docs", "examples", "notebooks", "solutions")
    for path in sorted((ROOT / folder).rglob("*.py"))
    if "_build" not in path.parts
]


@pytest.mark.parametrize("path", OUTSIDE, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_what_lies_beside_the_package_imports_what_is_in_it(path):
    for name in imported_names(path.read_text()):
        if name.startswith("sss_ref."):
            assert is_there(name), name


def is_there(name):
    """Whether a dotted name is a module, or something that a module holds."""
    module, _, own = name.rpartition(".")
    try:
        return hasattr(import_module(module), own) or bool(find_spec(name))
    except ModuleNotFoundError:
        return False


LIGHT = [
    "sss_ref",
    "sss_ref.scene.load",
    *(module_name(source) for source in SOURCES if room_of(module_name(source)) in ("passes", "methods")),
]


@pytest.mark.parametrize("modules", [LIGHT[:1], LIGHT], ids=["the package", "the stages and the scene"])
def test_what_defines_the_method_loads_no_compiler_and_no_mesh_reader(modules):
    code = f"import sys, {', '.join(modules)}; print(sorted({{'numba', 'trimesh'}} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], cwd=PACKAGE.parent, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_no_source_is_longer_than_300_lines():
    lengths = {source.name: len(source.read_text().splitlines()) for source in SOURCES}
    assert not {name: length for name, length in lengths.items() if length > 300}


def test_every_source_is_named_after_what_it_holds():
    shapeless = {"util", "utils", "helper", "helpers", "core", "common", "misc"}
    assert not shapeless & {
        part.removesuffix(".py") for source in SOURCES for part in source.relative_to(PACKAGE).parts
    }


def test_most_functions_are_small():
    lengths = sorted(
        code_lines(node)
        for source in SOURCES
        for node in ast.walk(ast.parse(source.read_text()))
        if isinstance(node, ast.FunctionDef)
    )
    assert lengths[len(lengths) // 2] <= 6
    assert lengths[len(lengths) * 9 // 10] <= 20


def code_lines(function):
    """The lines of a function's body without its docstring."""
    body = function.body[1:] if ast.get_docstring(function) else function.body
    return len({line for node in body for line in range(node.lineno, node.end_lineno + 1)})


def test_there_are_stages():
    assert len(STAGES) >= 18


@pytest.mark.parametrize("name", STAGES)
def test_every_stage_explains_itself(name):
    stage = STAGES[name]
    assert stage.name == name
    assert stage.source.strip() and not stage.source.endswith(".")
    assert inspect.getdoc(stage.python)
    outputs = inspect.signature(stage.python).return_annotation
    assert inspect.getdoc(outputs) and not inspect.getdoc(outputs).startswith(outputs.__name__ + "(")


def test_every_buffer_is_listed_every_listed_one_written_and_every_stage_used():
    methods = all_methods()
    written = {name for method in methods for name in method.values}
    assert len({name for name in written if re.fullmatch("tap_[0-9]{2}", name)}) == 13
    assert {entry_of(name) for name in written} == set(BUFFERS)
    assert all(described(name) is BUFFERS[entry_of(name)] for name in written)
    used = {stage.python.__name__ for method in methods for one in method.passes for stage in one.stages}
    vertex = {one.draw.vertex.name for method in methods for one in method.passes if hasattr(one.draw, "vertex")}
    assert used | vertex == set(STAGES)


def test_what_two_passes_compute_has_two_names():
    for method in all_methods():
        assert len(method.values) == sum(len(one.values) for one in method.passes)


def test_every_pass_reads_only_what_is_there_before_it():
    """A uniform is what no pass writes; a buffer must come from an earlier one."""
    for method in all_methods():
        there = set()
        for one in method.passes:
            assert one.needs & set(BUFFERS) - {"background"} <= there
            there |= set(one.outputs)


def test_the_table_of_contents_of_the_passes_names_every_file():
    named = re.findall(r"`(\w+)`", sss_ref.passes.__doc__)  # what has a dot is elsewhere
    assert sorted(named) == sorted(module.name for module in iter_modules(sss_ref.passes.__path__))
