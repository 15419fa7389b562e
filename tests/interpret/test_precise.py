"""Every sum and product of our shaders stays as written: compilers for Vulkan and OpenGL are told so of each one."""

import re
import shutil
import subprocess

import pytest
from scenes import settings_with

from sss_ref.interpret.shader import shader_files
from sss_ref.scene.catalogue import METHODS, method_of

TOOLS = [shutil.which(name) for name in ("glslangValidator", "spirv-dis")]
LENGTHS = {"tap_offset": 13, "tap_weight": 13}
ARITHMETIC = re.compile(r"= Op(FAdd|FSub|FMul|FDiv|FNegate|Dot|VectorTimes\w+|MatrixTimes\w+) ")
PRESETS = ("paper", "nearest", "literal", "exponent"), ("robust", "bilinear", "slope", "beer")
CASES = [
    {
        "method": method,
        "preset": preset,
        "shadow_map.filter": lookup,
        "shadow_map.test": test,
        "translucency.form": form,
    }
    for method in METHODS
    for preset, lookup, test, form in PRESETS
]
CASES += [{"method": method, "preset": "published"} for method in METHODS]
CASES += [
    {"lights": [{"position": [0.0, 0.0, 5.0], "falloff": "inverse_square"}] * 2, "translucency.combine": "add"},
    {"mesh.texture": "any.png", "irradiance_map.mode": "distance", "method": "texture_space"},
]
FLAGS = {  # loose uniforms are a habit of OpenGL that the compiler lets pass for Vulkan with -R
    "vulkan": ["-V", "-R", "--auto-map-bindings", "--auto-map-locations"],
    "opengl": ["-G", "--auto-map-bindings", "--auto-map-locations"],
}


@pytest.fixture(scope="module")
def shaders():
    """The shaders of some scene files that together have every stage of a fragment, each once: (suffix, source)."""
    methods = [method_of(settings_with(case)) for case in CASES]
    files = [item for method in methods for item in shader_files(method, LENGTHS).items()]
    return sorted({(name.rpartition(".")[2], source) for name, source in files})


@pytest.mark.skipif(
    None in TOOLS, reason="glslangValidator and spirv-dis are not installed (Debian: glslang-tools, spirv-tools)"
)
@pytest.mark.parametrize("client", FLAGS)
def test_no_operation_may_be_contracted(shaders, client, tmp_path):
    counted = 0
    for number, (suffix, source) in enumerate(shaders):
        path, binary = tmp_path / f"{number}.{suffix}", tmp_path / f"{number}.spv"
        path.write_text(source)
        done = subprocess.run([TOOLS[0], *FLAGS[client], "-o", str(binary), str(path)], capture_output=True, text=True)
        assert done.returncode == 0, done.stdout
        listed = subprocess.run([TOOLS[1], str(binary)], capture_output=True, text=True, check=True).stdout
        operations = len(ARITHMETIC.findall(listed))
        assert listed.count("NoContraction") == operations
        counted += operations
    assert counted > 500
