"""Which shaders of which passes are drawn, by a painter that only notes them."""

from contextlib import contextmanager

import numpy as np
import pytest

from sss_ref.errors import ShaderError
from sss_ref.gl.folding import drawn, pass_drawn
from sss_ref.interpret.shader import GLSL
from sss_ref.scene.load import load_scene

SCENE = load_scene("sphere", preset="robust")
CAMERA = SCENE.method["camera"]


class Noting:
    """Each texture is the name of its buffer."""

    dialect = GLSL

    def __init__(self):
        self.drawn, self.uploads = [], []

    def uploaded(self, data):
        self.uploads.append(data)
        return f"upload {len(self.uploads)}"

    def downloaded(self, texture, kind):
        return np.array([texture])

    def prepared(self, this_pass, pair):
        def draw(read):
            self.drawn.append((this_pass.name, pair, dict(read)))
            return {name: f"{this_pass.name} {name}" for name in pair.outputs}

        return draw


@pytest.fixture
def painter():
    return Noting()


def painting_with(painter):
    @contextmanager
    def opened(scene):
        yield painter

    return opened


def found(buffers):
    return {name: texture.item() for name, texture in buffers.items()}


def test_what_is_kept_comes_out_in_stage_order(painter):
    kept = found(drawn(SCENE, {}, ["image", "lit", "light_distance"], painting_with(painter)))
    assert list(kept.items()) == [
        ("light_distance", "shadow_map light_distance"),
        ("lit", "camera lit"),
        ("image", "composite image"),
    ]
    passes = list(dict.fromkeys(name for name, *_ in painter.drawn))
    assert passes == ["shadow_map", "camera", "blur", "composite"]
    _, _, read = next(each for each in painter.drawn if each[0] == "composite")
    assert read["scattered"] == "blur scattered"


def test_a_pass_on_demand_is_drawn_where_it_is_asked_for(painter):
    kept = found(drawn(SCENE, {}, "taps", painting_with(painter)))
    assert kept["tap_00"] == "taps tap_00" and len(kept) == 13
    with pytest.raises(ShaderError) as error:
        drawn(SCENE, {"taps": []}, "final", painting_with(painter))
    listed = "shadow_map, camera, blur, composite"
    assert str(error.value) == f"shaders: expected passes of screen_space ({listed}), got 'taps'"


def test_a_users_shader_is_drawn_with_what_of_the_draw_it_leaves(painter, tmp_path):
    """Ours add what the rasterizer writes, and nothing of the stages."""
    shader, other = tmp_path / "a.frag", tmp_path / "b.frag"
    shader.write_text("layout(location = 0) out vec3 out_lit;\n")
    other.write_text("layout(location = 0) out float out_thickness;\n")
    with pytest.raises(ShaderError, match="pass blur: expected the buffer lit, which no shader wrote; write it as an"):
        drawn(SCENE, {"camera": other}, "final", painting_with(Noting()))
    files = {"camera": shader}
    kept = found(drawn(SCENE, files, ["lit", "coverage", "normal_world", "image"], painting_with(painter)))
    assert list(kept) == ["coverage", "lit", "image"]
    theirs, ours = [pair for name, pair, _ in painter.drawn if name == "camera"]
    assert theirs.outputs == ("lit",) and set(ours.outputs) == set(CAMERA.draw.outputs)


def test_a_vertex_shader_alone_is_drawn_with_our_fragment_shaders(painter, tmp_path):
    (tmp_path / "a.vert").write_text("mine")
    drawn(SCENE, {"camera": tmp_path / "a.vert"}, "final", painting_with(painter))
    pairs = [pair for name, pair, _ in painter.drawn if name == "camera"]
    assert {pair.vertex for pair in pairs} == {"mine"}
    assert {name for pair in pairs for name in pair.outputs} == {*CAMERA.outputs}


def test_one_pass_gives_what_it_writes(painter, tmp_path):
    given = {name: np.zeros(1) for name in CAMERA.needs if name in SCENE.method.outputs}
    written = found(pass_drawn(SCENE, CAMERA, given, {}, painting_with(painter)))
    assert list(written) == [name for name in CAMERA.values if name in CAMERA.outputs]
    assert len(painter.uploads) == len(given) and set(painter.drawn[0][2].values()) == {
        f"upload {number}" for number in range(1, len(given) + 1)
    }
    with pytest.raises(
        ShaderError, match="pass camera: expected the buffer light_distance, which no shader wrote; write"
    ):
        pass_drawn(SCENE, CAMERA, {}, {}, painting_with(painter))
