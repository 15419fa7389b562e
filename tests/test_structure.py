"""What holds for all sources at once: which way they import, how large they are, and that nothing is left over."""

import ast
import inspect
import re
import subprocess
import sys
from importlib import import_module
from itertools import product
from pathlib import Path
from pkgutil import iter_modules
from typing import get_args

import pytest
from scenes import settings_with

import sss_ref
import sss_ref.passes
from sss_ref.language.stage import Stage
from sss_ref.passes.buffers import BUFFERS, described, entry_of
from sss_ref.scene.catalogue import METHODS, method_of
from sss_ref.scene_file import settings, viewpoints
from sss_ref.scene_file.presets import FIXED, ONLY_PUBLISHED

PACKAGE = Path(sss_ref.__file__).parent
SOURCES = sorted(path for path in PACKAGE.rglob("*.py") if "data" not in path.relative_to(PACKAGE).parts)
STAGES = {
    name: value
    for module in iter_modules(sss_ref.passes.__path__)
    for name, value in vars(import_module(f"sss_ref.passes.{module.name}")).items()
    if isinstance(value, Stage)
}

FREE = {"errors", "compiled", "rules", "cache_root"}  # anyone may import these
MAY_IMPORT = {
    "numerics": set(),
    "language": {"numerics"},
    "raster": {"numerics"},
    "interpret": {"numerics", "language", "raster"},
    "passes": {"language"},
    "scene": set(),
    "methods": {"language", "passes", "scene"},
    "own_stage": {"language", "scene", "methods"},
    "rendering": {"language", "raster", "interpret", "passes", "scene", "methods", "result"},
    "result": {"scene"},
    "samples": {"scene", "result", "rendering"},
    "explanation": {"language", "raster", "interpret", "passes", "scene", "methods", "result", "rendering"},
    "gl": {"interpret", "language", "passes", "scene", "methods"},
    "webgl": {"gl", "interpret", "language", "passes", "scene", "methods"},
    "io": {"language", "interpret", "passes", "scene", "methods", "result", "rendering", "samples"},
    "validation": {
        "numerics",
        "language",
        "raster",
        "interpret",
        "passes",
        "scene",
        "methods",
        "result",
        "rendering",
        "explanation",
        "io",
    },
    "cli": {"language", "passes", "scene", "methods", "result", "rendering", "explanation", "io"},
}


def top_level_imports(source):
    """The parts of the package (its folders and files) that a source imports when it is itself imported."""
    for node in ast.parse(source.read_text()).body:
        names = []
        if isinstance(node, ast.ImportFrom):
            names = (
                [f"{node.module}.{alias.name}" for alias in node.names] if node.module == "sss_ref" else [node.module]
            )
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        yield from (name.split(".")[1] for name in names if name.startswith("sss_ref."))


def part_of(source):
    """The folder or file right below the package that a source belongs to."""
    return source.relative_to(PACKAGE).parts[0].removesuffix(".py")


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: path.relative_to(PACKAGE).as_posix())
def test_imports_go_one_way(source):
    part = part_of(source)
    if part == "__init__" or part in FREE:
        assert set(top_level_imports(source)) <= ({"cache_root"} if part == "compiled" else set())
    else:
        assert set(top_level_imports(source)) <= MAY_IMPORT[part] | FREE | {part}


def test_the_direction_has_no_circle():
    order = [
        "numerics",
        "language",
        "raster",
        "interpret",
        "passes",
        "scene",
        "methods",
        "own_stage",
        "result",
        "rendering",
        "samples",
        "explanation",
        "gl",
        "webgl",
        "io",
        "validation",
        "cli",
    ]
    assert sorted(order) == sorted(MAY_IMPORT)
    assert all(order.index(below) < order.index(part) for part in MAY_IMPORT for below in MAY_IMPORT[part])
    assert {part_of(source) for source in SOURCES} == {*order, *FREE, "__init__"}


LIGHT = [
    "sss_ref",
    "sss_ref.scene.load",
    *(f"sss_ref.{part_of(path)}.{path.stem}" for path in SOURCES if part_of(path) in ("passes", "methods")),
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


def all_methods():
    """Every method that a scene file can select."""
    choices = {
        "method": METHODS,
        "mesh.color": ((0.7, 0.4, 0.4), "material"),
        "mesh.texture": (None, "any.png"),
        "shadow_map.filter": alternatives(settings.ShadowMap, "filter"),
        "shadow_map.test": alternatives(settings.ShadowMap, "test"),
        "translucency.form": alternatives(settings.Translucency, "form"),
        "translucency.combine": alternatives(settings.Translucency, "combine"),
        "blur.mask": alternatives(settings.Blur, "mask"),
        "lights.0.falloff": alternatives(viewpoints.LightSettings, "falloff"),
        "irradiance_map.mode": alternatives(settings.IrradianceMap, "mode"),
        "irradiance_map.image": alternatives(settings.IrradianceMap, "image"),
    }
    for values in product(*choices.values()):
        yield method_of(settings_with(dict(zip(choices, values, strict=True))))
    for method in METHODS:
        yield method_of(settings_with({"method": method, "lights": [{"position": [0.0, 0.0, 5.0]}] * 3}))
        yield method_of(settings_with({"method": method, "preset": "published"}))


def alternatives(table, key):
    """The values of a key, but for those that only preset `published` has."""
    only_published = {FIXED[each] for each in ONLY_PUBLISHED}
    return [value for value in get_args(table.model_fields[key].annotation) if value not in only_published]


def test_every_buffer_is_listed_every_listed_one_written_and_every_stage_used():
    methods = list(all_methods())
    written = {name for method in methods for name in method.values}
    assert len({name for name in written if re.fullmatch("tap_[0-9]{2}", name)}) == 13
    assert {entry_of(name) for name in written} == set(BUFFERS)
    assert all(described(name) is BUFFERS[entry_of(name)] for name in written)
    used = {stage.name for method in methods for one in method.passes for stage in one.stages}
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
