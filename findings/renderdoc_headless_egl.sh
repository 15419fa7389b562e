#!/bin/sh
# A frame of OpenGL 4.5 core, captured by RenderDoc from an EGL context without a surface, and replayed on the same machine.
#
# Expected: it replays where it was captured, with the driver that drew it; or the message says that a display is missing.
# Seen with RenderDoc 1.24 (Debian 12) on Mesa 22.3.6 without a display: the replay asks eglGetDisplay for the default
# display, gets none, and says APIHardwareUnsupported, "Couldn't create OpenGL ES 3.x replay context", although nothing of
# the frame is OpenGL ES and the same driver has just drawn it. With EGL_PLATFORM=surfaceless it replays.
# So `sss_ref/capture/renderdoc_file.py` sets that where there is no display.
# Needs Debian's librenderdoc python3-renderdoc libegl1 libegl-mesa0 libgl1-mesa-dri.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY EGL_PLATFORM || true
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet moderngl==5.13.0
cat >"$folder/draw.py" <<'PYTHON'
import ctypes
import sys

import moderngl

api = ctypes.c_void_p()
ctypes.CDLL("librenderdoc.so").RENDERDOC_GetAPI(10600, ctypes.byref(api))
table = ctypes.cast(api, ctypes.POINTER(ctypes.c_void_p))
ctypes.CFUNCTYPE(None, ctypes.c_char_p)(table[11])(f"{sys.argv[1]}/frame".encode())
context = moderngl.create_context(standalone=True, backend="egl", require=400)
print("captured:", context.info["GL_RENDERER"], context.info["GL_VERSION"])
ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)(table[19])(None, None)
vertex = "#version 400\nvoid main() { gl_Position = vec4(gl_VertexID % 2 * 4 - 1, gl_VertexID / 2 * 4 - 1, 0, 1); }"
fragment = "#version 400\nout vec4 color;\nvoid main() { color = vec4(1); }"
context.framebuffer([context.texture((4, 4), 4)]).use()
context.vertex_array(context.program(vertex, fragment), []).render(vertices=3)
context.finish()
assert ctypes.CFUNCTYPE(ctypes.c_uint32, ctypes.c_void_p, ctypes.c_void_p)(table[21])(None, None) == 1
PYTHON
cat >"$folder/replay.py" <<'PYTHON'
import sys

import renderdoc

renderdoc.InitialiseReplay(renderdoc.GlobalEnvironment(), [])
capture = renderdoc.OpenCaptureFile()
capture.OpenFile(sys.argv[1], "", None)
result, _ = capture.OpenCapture(renderdoc.ReplayOptions(), None)
print(result.code.name, "-", result.Message(), f"(RenderDoc {renderdoc.GetVersionString()})")
PYTHON
LD_PRELOAD=librenderdoc.so "$folder/venv/bin/python" "$folder/draw.py" "$folder"
plain=$(/usr/bin/python3 "$folder/replay.py" "$folder"/frame*.rdc)
surfaceless=$(EGL_PLATFORM=surfaceless /usr/bin/python3 "$folder/replay.py" "$folder"/frame*.rdc)
echo "as it is:                 $plain"
echo "EGL_PLATFORM=surfaceless: $surfaceless"
case "$plain" in *APIHardwareUnsupported*"OpenGL ES"*) ;; *) exit 1 ;; esac
case "$surfaceless" in *Succe*) ;; *) exit 1 ;; esac
