"""Every shader of every alternative of a scene file compiles in every dialect, by the reference compiler."""

import os
import shutil
import subprocess

import pytest
from every_shader import shaders_of

from sss_ref.interpret.shader import DIALECTS
from sss_ref.methods.stages import all_stages

VALIDATOR = shutil.which("glslangValidator")

COMMANDS = {  # per file; the compiler for HLSL makes SPIR-V, whose bindings the file need not have
    "glsl": [],
    "vulkan": ["-V", "-o", os.devnull],
    "essl": [],
    "hlsl": ["-D", "-e", "main", "-V", "--auto-map-bindings", "--auto-map-locations", "-o", os.devnull],
}


@pytest.fixture(scope="module", params=COMMANDS)
def dialect(request):
    return request.param


@pytest.fixture(scope="module")
def shaders(dialect):
    """Every shader once: (suffix, source)."""
    return shaders_of(DIALECTS[dialect])


def test_every_stage_is_in_some_shader(shaders):
    sources = "".join(source for _, source in shaders)
    assert [name for name in all_stages() if f" {name}(" not in sources] == []


@pytest.mark.skipif(VALIDATOR is None, reason="glslangValidator is not installed (Debian: glslang-tools)")
def test_every_shader_compiles(shaders, dialect, tmp_path):
    paths = [tmp_path / f"{number}.{suffix}" for number, (suffix, _) in enumerate(shaders)]
    for path, (_, source) in zip(paths, shaders, strict=True):
        path.write_text(source)
    batches = (
        [[path] for path in paths] if "-V" in COMMANDS[dialect] else [paths]
    )  # of several, it would link one program
    for batch in batches:
        done = subprocess.run([VALIDATOR, *COMMANDS[dialect], *map(str, batch)], capture_output=True, text=True)
        problems = [line for line in done.stdout.splitlines() if "ERROR" in line or "WARNING" in line]
        assert not problems and done.returncode == 0
    assert len(paths) > 60
