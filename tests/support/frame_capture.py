"""Captures of our own drawing, made by RenderDoc's library around OpenGL or WebGPU, where the machine has both."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from lavapipe import LAVAPIPE, adapter

from sss_ref.capture.renderdoc_file import renderdoc_python

LIBRARY = "librenderdoc.so"
SCRIPT = """
import ctypes, json, sys
from sss_ref.scene.load import load_scene

START, END, TEMPLATE = 19, 21, 11  # places in RENDERDOC_API_1_6_0
scene = load_scene(sys.argv[2], **json.loads(sys.argv[3]))

def call(place):
    api = ctypes.c_void_p()
    ctypes.CDLL("librenderdoc.so").RENDERDOC_GetAPI(10600, ctypes.byref(api))
    table = ctypes.cast(api, ctypes.POINTER(ctypes.c_void_p))
    ctypes.CFUNCTYPE(None, ctypes.c_char_p)(table[TEMPLATE])(sys.argv[1].encode())
    return ctypes.CFUNCTYPE(ctypes.c_uint32, ctypes.c_void_p, ctypes.c_void_p)(table[place])(None, None)

def end():
    assert call(END) == 1, "no frame was captured"
"""
OPENGL = """
from sss_ref.gl import drawing

opened = drawing.open_context

def recorded():
    context = opened()
    call(START)
    release = context.release

    def ended():
        context.finish()
        end()
        release()

    context.release = ended
    return context

drawing.open_context = recorded
drawing.draw(scene)
"""
LAYERS = """
from sss_ref.gl import drawing

COLOR, TARGET, UNSIGNED = 0x8CE0, 0x8D40, ctypes.c_uint  # of OpenGL's own calls, which moderngl has not for a layer
context = drawing.open_context()
egl = ctypes.CDLL("libEGL.so.1")
egl.eglGetProcAddress.restype = ctypes.c_void_p
types = [UNSIGNED] * 3 + [ctypes.c_int] * 2
attach = ctypes.CFUNCTYPE(None, *types)(egl.eglGetProcAddress(b"glFramebufferTextureLayer"))
call(START)
layers = context.texture_array((5, 3, 2), 4, dtype="f4")
frame = context.framebuffer([context.texture((5, 3), 4, dtype="f4")])
program = context.program(
    vertex_shader="#version 400\\nvoid main()"
    "{ gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.25, 1.0); }",
    fragment_shader="#version 400\\nuniform float value; out vec4 color; void main() { color = vec4(value); }",
)
frame.use()
for layer, values in enumerate(((1.0, 2.0), (3.0,))):
    attach(TARGET, COLOR, layers.glo, 0, layer)
    for value in values:
        program["value"] = value
        context.vertex_array(program, []).render(vertices=3)
context.finish()
end()
"""
WEBGPU = """
from wgpu.backends.wgpu_native.extras import set_instance_extras
from sss_ref.webgpu import painting

if sys.argv[5] == "named":
    set_instance_extras(flags=["Debug"])  # without, wgpu keeps the names of textures for itself
opened = painting.open_device

def recorded(words):
    device = opened(words)
    call(START)
    destroy = device.destroy

    def ended():
        end()
        destroy()

    device.destroy = ended
    return device

painting.open_device = recorded
painting.draw(scene, adapter=sys.argv[4])
"""
PASSES = """
import wgpu
from sss_ref.webgpu.adapter import open_device

TEXT = '''
@vertex fn corner(@builtin(vertex_index) k: u32) -> @builtin(position) vec4<f32>
{ return vec4<f32>(vec2<f32>(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0, 0.25, 1.0); }
@fragment fn color(@builtin(position) at: vec4<f32>) -> @location(0) vec4<f32>
{ return vec4<f32>(at.x, at.y, VALUE, 1.0); }
'''
DEPTH, COLOR = "depth24plus", "rgba32float"
device = open_device(sys.argv[4])
call(START)
usage = wgpu.TextureUsage.RENDER_ATTACHMENT
color, depth = (device.create_texture(size=(5, 3, 1), format=each, usage=usage) for each in (COLOR, DEPTH))
encoder = device.create_command_encoder()
for value, begin in (("1.0", "clear"), ("2.0", "clear"), ("3.0", "load")):
    module = device.create_shader_module(code=TEXT.replace("VALUE", value))
    drawing = encoder.begin_render_pass(
        color_attachments=[{"view": color.create_view(), "load_op": begin, "store_op": "store"}],
        depth_stencil_attachment={
            "view": depth.create_view(), "depth_load_op": begin, "depth_store_op": "store", "depth_clear_value": 1.0
        },
    )
    drawing.set_pipeline(device.create_render_pipeline(
        layout="auto",
        vertex={"module": module},
        primitive={},
        depth_stencil={"format": DEPTH, "depth_write_enabled": True, "depth_compare": "less-equal"},
        fragment={"module": module, "targets": [{"format": COLOR}]},
    ))
    drawing.draw(3)
    drawing.end()
device.queue.submit([encoder.finish()])
end()
"""


def captured(folder, scene, overrides):
    """The capture of a scene drawn by OpenGL; the test is skipped where there is none or no RenderDoc.

    The library takes itself out of LD_PRELOAD when it is loaded, so nothing may stand between it and Python.
    """
    return _by_opengl(folder, OPENGL, scene, json.dumps(overrides))


def captured_layers(folder):
    """The capture of two layers of a texture, 5 x 3, drawn into without a clear: 1 and then 2, 3 into the other."""
    return _by_opengl(folder, LAYERS, "sphere", "{}")


def _by_opengl(folder, script, *words):
    pytest.importorskip("moderngl")
    require_renderdoc()
    command = [sys.executable, "-c", SCRIPT + script, str(folder / "frame"), *words]
    done = run(command, {"LD_PRELOAD": LIBRARY})
    if "OpenGL 4.0" in done.stderr:
        pytest.skip("there is no OpenGL 4.0")
    return only_capture(folder, done)


def captured_of_vulkan(folder, scene, overrides, named):
    """The capture of a scene drawn by WebGPU on lavapipe; skipped as above. named: whether it has textures' names."""
    return _by_vulkan(folder, WEBGPU, scene, json.dumps(overrides), LAVAPIPE, "named" if named else "plain")


def captured_passes(folder):
    """The capture of a target, 5 x 3, drawn into in three passes: blue 1, cleared and 2, 3 over that; depth 1/4."""
    return _by_vulkan(folder, PASSES, "sphere", "{}", LAVAPIPE)


def _by_vulkan(folder, script, *words):
    if "llvmpipe" not in adapter():
        pytest.skip("no lavapipe (Debian: mesa-vulkan-drivers), or no wgpu (pip), is installed")
    require_renderdoc()
    command = [sys.executable, "-c", SCRIPT + script, str(folder / "frame"), *words]
    return only_capture(folder, run(command, {"ENABLE_VULKAN_RENDERDOC_CAPTURE": "1"}))


def require_renderdoc():
    """Skip the test where there is no RenderDoc."""
    if not Path("/usr/lib", LIBRARY).exists():
        pytest.skip("Debian's librenderdoc, which captures, is not installed")
    if renderdoc_python() is None:
        pytest.skip("Debian's python3-renderdoc, which replays captures, is not installed")


def run(command, environment):
    """Run a command with more in its environment."""
    return subprocess.run(command, env=os.environ | environment, capture_output=True, text=True, check=False)


def only_capture(folder, done):
    """The capture that a command left behind."""
    assert done.returncode == 0, done.stderr
    (file,) = folder.glob("frame*.rdc")
    return file
