"""Captures of our own drawing, made by RenderDoc's library around `sss_ref.gl.draw`, where the machine has both."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from sss_ref.capture.renderdoc_file import renderdoc_python

LIBRARY = "librenderdoc.so"
SCRIPT = """
import ctypes, json, sys
from sss_ref.gl import drawing
from sss_ref.scene.load import load_scene

START, END, TEMPLATE = 19, 21, 11  # places in RENDERDOC_API_1_6_0
api = ctypes.c_void_p()
ctypes.CDLL("librenderdoc.so").RENDERDOC_GetAPI(10600, ctypes.byref(api))
table = ctypes.cast(api, ctypes.POINTER(ctypes.c_void_p))
ctypes.CFUNCTYPE(None, ctypes.c_char_p)(table[TEMPLATE])(sys.argv[1].encode())
call = lambda place: ctypes.CFUNCTYPE(ctypes.c_uint32, ctypes.c_void_p, ctypes.c_void_p)(table[place])(None, None)
scene = load_scene(sys.argv[2], **json.loads(sys.argv[3]))

opened = drawing.open_context

def recorded():
    context = opened()
    call(START)
    release = context.release

    def ended():
        context.finish()
        assert call(END) == 1, "no frame was captured"
        release()

    context.release = ended
    return context

drawing.open_context = recorded
drawing.draw(scene)
"""


def captured(folder, scene, overrides):
    """The capture of a scene's drawing; the test is skipped where there is no OpenGL or no RenderDoc.

    The library takes itself out of LD_PRELOAD when it is loaded, so nothing may stand between it and Python.
    """
    pytest.importorskip("moderngl")
    if not Path("/usr/lib", LIBRARY).exists():
        pytest.skip("Debian's librenderdoc, which captures, is not installed")
    if renderdoc_python() is None:
        pytest.skip("Debian's python3-renderdoc, which replays captures, is not installed")
    command = [sys.executable, "-c", SCRIPT, str(folder / "frame"), scene, json.dumps(overrides)]
    preloaded = {**os.environ, "LD_PRELOAD": LIBRARY}
    done = subprocess.run(command, env=preloaded, capture_output=True, text=True, check=False)
    if "OpenGL 4.0" in done.stderr:
        pytest.skip("there is no OpenGL 4.0")
    assert done.returncode == 0, done.stderr
    (file,) = folder.glob("frame*.rdc")
    return file
