"""The documentation names everything there is, and its links lead somewhere; docs/build.sh builds the site itself."""

import ast
import inspect
import re
import sys
from importlib import import_module
from pathlib import Path

import pytest
from package_sources import IDS, SOURCES
from scenes import settings_with

import sss_ref
from sss_ref.course.lessons import lessons
from sss_ref.dump.mapping import BufferTable
from sss_ref.methods.stages import all_stages
from sss_ref.rules import RULES_VERSION
from sss_ref.scene_file.kernels import HBH09
from sss_ref.scene_file.reading import TABLES
from sss_ref.scene_file.settings import LayerSettings

STAGES = all_stages()
DOCS = Path(__file__).parents[1] / "docs"
sys.path.insert(0, str(DOCS / "generate"))

import house_docstrings  # noqa: E402
import lesson_pictures  # noqa: E402
import markup  # noqa: E402
import pages  # noqa: E402

WRITTEN = [path for path in sorted(DOCS.rglob("*.md")) if not {"_build", "generated"} & {*path.relative_to(DOCS).parts}]
FUNCTIONS = re.findall(r"autofunction:: (\S+)", (DOCS / "api.md").read_text())


@pytest.fixture(scope="module")
def generated():
    return pages.texts()


@pytest.mark.parametrize("name", sss_ref.__all__)
def test_every_public_name_is_in_the_api_reference(name):
    assert re.search(rf"auto\w+:: sss_ref\.{name}\b", (DOCS / "api.md").read_text())


@pytest.mark.parametrize("name", STAGES)
def test_every_stage_is_described_with_all_it_reads_and_writes(name, generated):
    page = generated[f"stages/{STAGES[name].python.__module__.rpartition('.')[2]}"]
    _, _, section = page.partition(f"(stage-{name})=\n## {name}\n")
    section = section.partition("\n(stage-")[0]
    assert STAGES[name].source in section.replace("\\", "")
    for each in (*STAGES[name].parameters, *STAGES[name].outputs):
        assert f"| `{each}` " in section
    assert f"def {name}(" in section and f" {name}(" in section.partition("```glsl")[2]


def scene_keys():
    """Every key of a filled scene file, and those of the other types of camera."""
    filled = settings_with({}).model_dump()
    tables = {name: value for name, value in filled.items() if isinstance(value, dict)}
    tables |= {"lights": filled["lights"][0], "layers": LayerSettings.model_fields}
    yield from (name for name in filled if name not in tables)
    yield from (f"{name}.{key}" for name, table in tables.items() for key in table)
    for path, model in TABLES.items():
        if path[:1] in (("camera",), ("lights",)):
            yield from (f"{path[0]}.{key}" for key in model.model_fields)


@pytest.mark.parametrize("key", dict.fromkeys(scene_keys()))
def test_every_scene_key_is_described_with_type_and_default(key, generated):
    assert re.search(rf"\{{confval\}} {re.escape(key)}\n:type: \S.*\n:default: \S.*\n", generated["scene_file"])


@pytest.mark.parametrize("key", ["origin", *(f"buffers.NAME.{key}" for key in BufferTable.model_fields)])
def test_every_mapping_key_is_described_with_type_and_default(key, generated):
    assert re.search(rf"\{{confval\}} {re.escape(key)}\n:type: \S.*\n:default: \S.*\n", generated["mapping_file"])


def test_the_defaults_are_those_of_each_preset(generated):
    page = generated["scene_file"]
    number, each = "number ≥ 0, or three: `[r, g, b]`", "`0.1` in `paper`; `0.03` in `robust`; `0.0` in `published`"
    assert f"{{confval}} translucency.d_min\n:type: {number}\n:default: {each}" in page
    assert '| {confval}`blur.mask` | `"output"` | `"taps"` | `"none"` |' in page


def test_the_rules_are_those_that_a_rendering_records():
    assert (DOCS / "rules.md").read_text().startswith(f"# The rules, version {RULES_VERSION}\n")


def test_the_rules_have_the_numbers_of_the_kernel():
    rows = re.findall(r"^\| (-?\d.*) \|$", (DOCS / "rules.md").read_text(), re.MULTILINE)
    assert tuple(tuple(map(float, row.split(" | "))) for row in rows) == HBH09


def test_every_lesson_has_a_card_with_a_picture_of_its_own(generated):
    pictures = {path.stem for path in (DOCS / "images/course").glob("*.jpg")}
    assert pictures == {*lesson_pictures.TAKEN} == {lesson.name for lesson in lessons()}
    for lesson in lessons():
        assert f":link: /generated/course/{lesson.name}\n" in generated["lessons"]
        assert lesson.plan["aims"] in generated["lessons"]


def test_every_command_is_described(generated):
    from sss_ref.cli import app

    commands = [name for name in app if not name.startswith("-")]
    assert len(commands) >= 10
    for name in commands:
        usage = rf"\n## sss-ref {name}\n\n```shell\nsss-ref {name}( [A-Z[]| --[a-z]|\n)"
        assert re.search(usage, generated["command_line"])


@pytest.mark.parametrize("path", WRITTEN, ids=lambda path: path.relative_to(DOCS).as_posix())
def test_every_relative_link_leads_somewhere(path, generated):
    text = re.sub(r"```.*?```|`[^`\n]*`", "", path.read_text(), flags=re.DOTALL)
    for link in re.findall(r"\]\(([^)\s]+)\)", text):
        target = link.partition("#")[0]
        if not re.match(r"[a-z]+:", link) and target:
            found = (path.parent / target).resolve()
            page = found.relative_to(DOCS).as_posix().removeprefix("generated/").removesuffix(".md")
            assert found.exists() or page in generated, link


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_documented_function_names_every_argument(name):
    text, names = inspect.getdoc(documented(name)), inspect.signature(documented(name)).parameters
    assert not [each for each in names if not re.search(rf"\b{each}\b", text)]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_documented_function_tells_the_shape_of_its_arrays(name):
    if "ndarray" in str(inspect.signature(documented(name))):
        assert re.search(r"\([A-Z](, [A-Z0-9])*,?\)|as in `validate`", inspect.getdoc(documented(name)))


def documented(name):
    module, _, function = name.rpartition(".")
    return getattr(import_module(module), function)


def public_functions(source):
    """Every public function and method of a source, by its syntax tree."""
    for node in ast.walk(ast.parse(source.read_text())):
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            yield node


@pytest.mark.parametrize("source", SOURCES, **IDS)
def test_no_docstring_explains_what_is_no_argument(source):
    for function in public_functions(source):
        text = ast.get_docstring(function) or ""
        explained = re.findall(r"(?:^ *|\. )([a-z_][a-z_0-9]*(?:, [a-z_][a-z_0-9]*)*): ", text, re.MULTILINE)
        names = {each.arg for each in ast.walk(function.args) if isinstance(each, ast.arg)}
        assert {name for each in explained for name in each.split(", ")} <= names, function.name


def test_there_are_documented_functions():
    assert {"sss_ref.render", "sss_ref.gl.draw", "sss_ref.dump.read.read_dump"} <= {*FUNCTIONS}


def test_arguments_become_fields():
    text = "Do it.\n\na: the one,\n    a `b` * 2. b, c: the others.\nRaises SceneError for d: none."
    assert house_docstrings.with_fields(text, ["a", "b", "c"]).split("\n") == [
        *("Do it.", "", ""),
        *(":param a: the one, a ``b`` \\* 2.", ":param b: the others.", ":param c: the others."),
        *("", "Raises SceneError for d: none.", ""),
    ]


def test_prose_keeps_its_characters():
    assert markup.prose("a*b_c [d] `e*f`") == "a\\*b\\_c \\[d\\] `e*f`"
