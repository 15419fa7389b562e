"""Right drawings by other conventions than ours, and on another processor: they pass."""

import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from edited import SHIPPED, drawn, drawn_edited, rendered
from opengl import needs_mesa

from sss_ref import gl
from sss_ref.gl import uploads as textures
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_mesa

PLACED = "gl_Position = vertex.clip_position;"
SHIFTED = "return sample_bilinear_vec3(picture, pixel + whole_part(offset), fractional_part(offset));"
SAMPLED = "return textureLod(picture, (vec2(pixel) + 0.5 + offset) / vec2(textureSize(picture, 0)), 0.0).xyz;"
DRAW_AND_KEEP = """
import sys
import numpy as np
from edited import drawn
for scene in sys.argv[2:]:
    np.savez(f"{sys.argv[1]}/{scene}.npz", **drawn(scene))
"""


def passes(scene, drawing):
    found = validate(rendered(scene), drawing, explain=False)
    assert found.passed, found.summary
    return any(drawing[name].tobytes() != buffer.tobytes() for name, buffer in drawn(scene).items())


@pytest.mark.parametrize("turn", [1, 2])
@pytest.mark.parametrize("scene", ["slabs", "bust cut open", "texture space"])
def test_triangles_that_begin_with_another_corner(scene, turn):
    ours = rendered(scene).scene
    mesh = replace(ours.mesh, triangles=np.ascontiguousarray(np.roll(ours.mesh.triangles, turn, axis=1)))
    passes(scene, gl.draw(replace(ours, mesh=mesh)))


@pytest.mark.parametrize("scene", ["slabs", "bust"])
def test_pictures_that_begin_with_the_top_row(scene, tmp_path):
    """The camera looks upside down and the blur reads downwards; the dumps are turned when they are read."""
    from_camera = {PLACED: f"{PLACED} gl_Position.y = -gl_Position.y;"}
    blurred = {"tap_offset[tap] * pixel_scale": "tap_offset[tap] * vec2(pixel_scale, -pixel_scale)"}
    first = drawn_edited(scene, from_camera | blurred, tmp_path, ("camera.", "blur."))
    of_the_light = ("light_triangle", "light_depth", "light_distance")
    drawing = {name: buffer if name in of_the_light else buffer[::-1].copy() for name, buffer in first.items()}
    passes(scene, drawing)
    assert not validate(rendered(scene), first, explain=False).passed


@pytest.mark.parametrize("scene", ["slabs", "bust"])
def test_depths_from_0_to_1(scene, tmp_path):
    edits = {PLACED: f"{PLACED} gl_Position.z = 0.5 * (gl_Position.z + gl_Position.w);"}
    edits["gl_FragCoord.z"] = "2.0 * gl_FragCoord.z - 1.0"
    assert passes(scene, drawn_edited(scene, edits, tmp_path, ("camera", "shadow_map")))


@pytest.mark.parametrize("scene", ["wax", "wax from near"])
def test_taps_by_the_sampler(scene, tmp_path, monkeypatch):
    """texture() at uv + offset/size in the place of four texels around a shifted pixel."""
    uploaded = textures.uploaded

    def filtered(context, data):
        texture = uploaded(context, data)
        if data.dtype == np.float32:
            texture.filter = (context.LINEAR, context.LINEAR)
            texture.repeat_x = texture.repeat_y = False
        return texture

    monkeypatch.setattr(textures, "uploaded", filtered)
    assert passes(scene, drawn_edited(scene, {SHIFTED: SAMPLED}, tmp_path, "blur"))


@pytest.fixture(scope="module")
def of_a_narrow_processor(tmp_path_factory):
    """A folder of drawings by llvmpipe without AVX and FMA."""
    folder = tmp_path_factory.mktemp("narrow")
    environment = {**os.environ, "GALLIUM_OVERRIDE_CPU_CAPS": "sse4.1", "PYTHONPATH": os.pathsep.join(sys.path)}
    subprocess.run([sys.executable, "-c", DRAW_AND_KEEP, str(folder), *SHIPPED], env=environment, check=True)
    return folder


@pytest.mark.parametrize("scene", list(SHIPPED))
def test_a_processor_with_fewer_instructions(scene, of_a_narrow_processor):
    passes(scene, dict(np.load(of_a_narrow_processor / f"{scene}.npz")))
