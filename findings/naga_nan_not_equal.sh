#!/bin/sh
# naga, which compiles WGSL for wgpu and Firefox, writes `!=` of two floats as a comparison that is false for NaN.
#
# Expected: x != x is true of NaN alone, as in IEEE 754, GLSL and HLSL, and says the same as !(x == x).
# Seen with wgpu 0.32.0 (wgpu-native 29.0.1) on Mesa 22.3.6 lavapipe: of a NaN both x == x and x != x are false, and
# !(x == x) is true; SPIR-V has two kinds of inequality, and OpFOrdNotEqual is false where one side is NaN. WGSL lets
# an implementation assume that there is none. A shader that looks for NaN by x != x never finds one; the bits tell,
# (bitcast<u32>(x) & 0x7fffffffu) > 0x7f800000u.
# Exits 0 while it is so, 1 when it changes. Needs a Vulkan: Debian's mesa-vulkan-drivers has one without a GPU.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check wgpu==0.32.0 numpy==2.2.6
cd "$folder"
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import numpy as np
import wgpu
from wgpu.backends.wgpu_native import lib_version_info

SOURCE = """
@group(0) @binding(0) var<storage, read> given: array<f32>;
@group(0) @binding(1) var<storage, read_write> found: array<u32>;

@compute @workgroup_size(1)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let x = given[id.x];
    found[id.x * 4u] = u32(x == x);
    found[id.x * 4u + 1u] = u32(x != x);
    found[id.x * 4u + 2u] = u32(!(x == x));
    found[id.x * 4u + 3u] = u32((bitcast<u32>(x) & 0x7fffffffu) > 0x7f800000u);
}
"""

adapters = [each for each in wgpu.gpu.enumerate_adapters_sync() if each.info["backend_type"] == "Vulkan"]
if not adapters:
    sys.exit("no Vulkan is here")
device = adapters[0].request_device_sync()
print("wgpu", wgpu.__version__, "wgpu-native", lib_version_info, device.adapter.info["description"])
given = np.float32([1.5, np.nan, np.inf])
usage = wgpu.BufferUsage
read = device.create_buffer_with_data(data=given, usage=usage.STORAGE)
written = device.create_buffer(size=16 * len(given), usage=usage.STORAGE | usage.COPY_SRC)
module = device.create_shader_module(code=SOURCE)
pipeline = device.create_compute_pipeline(layout="auto", compute={"module": module, "entry_point": "main"})
entries = [{"binding": k, "resource": {"buffer": each}} for k, each in enumerate((read, written))]
encoder = device.create_command_encoder()
compute = encoder.begin_compute_pass()
compute.set_pipeline(pipeline)
compute.set_bind_group(0, device.create_bind_group(layout=pipeline.get_bind_group_layout(0), entries=entries))
compute.dispatch_workgroups(len(given))
compute.end()
device.queue.submit([encoder.finish()])
found = np.frombuffer(device.queue.read_buffer(written), np.uint32).reshape(-1, 4).tolist()
for x, row in zip(given, found, strict=True):
    print(x, dict(zip(("x == x", "x != x", "!(x == x)", "by its bits"), row, strict=True)))
sys.exit(0 if found == [[1, 0, 0, 0], [0, 0, 1, 1], [1, 0, 0, 0]] else 1)
PYTHON
