"""A stage's own names in shading languages that keep some of them for themselves."""

import keyword
import os
import shutil
import subprocess
from importlib.util import module_from_spec, spec_from_file_location

import pytest
from lavapipe import LAVAPIPE, needs_lavapipe

from sss_ref.interpret.shader import DIALECTS, WGSL, fragment_shader
from sss_ref.interpret.shader.dialect import clear_of
from sss_ref.interpret.shader.reserved import (
    GLSL_BUILT_INS,
    GLSL_WORDS,
    HLSL_BUILT_INS,
    HLSL_WORDS,
    WGSL_BUILT_INS,
    WGSL_WORDS,
)
from sss_ref.language.pipeline import Pass, ScreenDraw
from sss_ref.webgpu.adapter import open_device

VALIDATOR = shutil.which("glslangValidator")
WORDS = sorted(
    word
    for word in GLSL_WORDS | GLSL_BUILT_INS | HLSL_WORDS | HLSL_BUILT_INS | WGSL_WORDS | {"main", "returned", "result"}
    if not keyword.iskeyword(word)
)
ODD = ["gl_Position", "gl_x", "two__two", "two___two", "ends_", "double_", "sample_", "λ", "größe"]
TOGETHER = 40  # stages in a shader
FLAGS = {
    "glsl": [],
    "vulkan": ["-V", "-o", os.devnull],
    "essl": [],
    "hlsl": ["-D", "-e", "main", "-V", "--auto-map-bindings", "--auto-map-locations", "-o", os.devnull],
}
OUT = """

class Out_{k}(NamedTuple):
    \"\"\"What is written.\"\"\"

    written_{k}: float
"""
USED = """
@function
def {name}_of(x: float) -> float:
    \"\"\"Twice x.\"\"\"
    {name} = x + x
    return {name}


@stage(source="test")
def stage_{k}({name}: float, {before}: float) -> Out_{k}:
    \"\"\"Read a uniform of this name, and use it on the way.\"\"\"
    inner = {name}_of({name}) * {before}
    return Out_{k}(inner)
"""
LOCAL = """
@stage(source="test")
def stage_{k}(value: float, {before}: float) -> Out_{k}:
    \"\"\"Have a local of this name.\"\"\"
    {name} = value * {before}
    return Out_{k}({name} + {name})
"""


@pytest.fixture(scope="module", params=[USED, LOCAL], ids=["uniform", "local"])
def template(request):
    return request.param


@pytest.fixture(scope="module")
def own(template, tmp_path_factory):
    """A stage for every word that one of the languages reserves, and for odd ones."""
    return stages(tmp_path_factory.mktemp("stages"), template, [*WORDS, *ODD])


def stages(folder, template, names):
    """A stage for each name that a stage may have."""
    names = [name for name in names if name not in ("function", "stage")]
    head = "from typing import NamedTuple\n\nfrom sss_ref.language import function, stage\n"
    outs = [
        f'\n\nclass Out_{k}(NamedTuple):\n    """What is written."""\n\n    written_{k}: float\n'
        for k in range(len(names))
    ]
    texts = [
        template.format(name=name, k=k, before=f"written_{k - 1}" if k else "scale") for k, name in enumerate(names)
    ]
    path = folder / "own_stages.py"
    path.write_text(head + "".join(outs) + "\n".join(texts), encoding="utf-8")
    spec = spec_from_file_location("own_stages", path)
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return [getattr(module, f"stage_{k}") for k in range(len(names))]


def shaders(own, dialect):
    """Shaders of these stages, so many in each."""
    for start in range(0, len(own), TOGETHER):
        this_pass = Pass("own", "camera", ScreenDraw(), tuple(own[start : start + TOGETHER]))
        last = list(this_pass.outputs)[-1]  # each stage reads what the one before it writes, so this needs them all
        yield fragment_shader(this_pass, set(), [last], {}, dialect)


@pytest.mark.skipif(VALIDATOR is None, reason="glslangValidator is not installed (Debian: glslang-tools)")
@pytest.mark.parametrize("dialect", FLAGS)
def test_every_reserved_word_may_name_a_value(dialect, own, tmp_path):
    for number, source in enumerate(shaders(own, DIALECTS[dialect])):
        path = tmp_path / f"{number}.frag"
        path.write_text(source)
        done = subprocess.run([VALIDATOR, *FLAGS[dialect], str(path)], capture_output=True, text=True)
        problems = [line for line in done.stdout.splitlines() if "ERROR" in line or "WARNING" in line]
        assert not problems and done.returncode == 0


@needs_lavapipe
def test_naga_lets_every_reserved_word_name_a_value(own, template, tmp_path):
    device = open_device(LAVAPIPE)
    built_ins = stages(tmp_path, template, sorted(WGSL_BUILT_INS - {*WORDS}))
    for source in (*shaders(own, WGSL), *shaders(built_ins, WGSL)):
        device.create_shader_module(code=source)  # raises an error that shows the line
    device.destroy()


def test_no_two_names_become_one():
    names = {
        *WORDS,
        *ODD,
        *(f"{word}_" for word in WORDS),
        *(f"{word}__" for word in WORDS[:50]),
        "two_0_two",
        "ends_0",
    }
    for reserved in (GLSL_WORDS, HLSL_WORDS, WGSL_WORDS):
        assert len({clear_of(reserved, name) for name in names}) == len(names)


def test_what_nobody_reserves_stays_as_it_is():
    assert (
        clear_of(GLSL_WORDS, "thickness") == "thickness"
        and clear_of(GLSL_WORDS, "light_distance_2") == "light_distance_2"
    )
    assert clear_of(GLSL_WORDS, "double") == "double_"
