"""Textures of OpenGL: what is asked of a context that only notes it, and which uniforms are textures."""

from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.gl.uploads import downloaded, filled, texture_data, uploaded
from sss_ref.interpret.shader import ARRAY_WIDTH
from sss_ref.language.types import vec2, vec3, vec4


class Context:
    """Notes the textures that are made."""

    NEAREST = "nearest"

    def texture(self, size, channels, data, alignment, dtype):
        return SimpleNamespace(size=size, channels=channels, data=data, alignment=alignment, dtype=dtype)


@pytest.mark.parametrize(
    ("shape", "given", "kind", "channels"),
    [((2, 5), "f4", "f4", 1), ((2, 5), "i4", "i4", 1), ((2, 5), "u1", "u1", 1), ((2, 5, 2), "f4", "f4", 2)],
)
def test_an_array_is_read_without_a_filter(shape, given, kind, channels):
    data = np.arange(np.prod(shape)).reshape(shape).astype(given)
    made = uploaded(Context(), np.asfortranarray(data))
    assert (made.size, made.channels, made.dtype, made.alignment) == ((5, 2), channels, kind, 1)
    assert made.data == data.tobytes() and made.filter == ("nearest", "nearest")


@pytest.mark.parametrize(
    ("kind", "background", "texel"),
    [
        (float, 2.5, [2.5]),
        (int, -1, [-1]),
        (bool, 1, [1]),
        (vec2, (1, 2), [1, 2]),
        (vec3, (1, 2, 3), [1, 2, 3, 1]),
        (vec4, (1, 2, 3, 4), [1, 2, 3, 4]),
    ],
)
def test_a_target_holds_its_background(kind, background, texel):
    """Of three channels the first is there again as the fourth."""
    made = filled(Context(), kind, (4, 3), background)
    found = np.frombuffer(made.data, {"f4": "f4", "i4": "i4", "u1": "u1"}[made.dtype])
    assert made.size == (4, 3) and found.reshape(12, -1).tolist() == [texel] * 12


@pytest.mark.parametrize(("kind", "stored"), [(float, 1), (bool, 1), (vec2, 2), (vec3, 4), (vec4, 4)])
def test_a_buffer_is_read_back(kind, stored):
    dtype = np.uint8 if kind is bool else np.float32
    data = np.arange(3 * 5 * stored).astype(dtype).reshape(3, 5, stored)
    texture = SimpleNamespace(width=5, height=3, components=stored, read=lambda alignment: data.tobytes())
    got = downloaded(texture, kind)
    assert got.tolist() == (data[..., 0] if stored == 1 else data[..., :3] if kind is vec3 else data).tolist()
    got[...] = 0  # it is the caller's own


def test_pictures_and_arrays_too_long_for_a_shader_are_textures():
    """Rows of 4096, the last filled up with 0; a matrix and a short array are none."""
    picture, short, long = np.ones((2, 3, 3), np.float32), np.ones((13, 2), np.float32), np.arange(1.0, 9001.0)
    of_vectors = np.ones((ARRAY_WIDTH, 3), np.float32)
    uniforms = {"picture": picture, "short": short, "long": long, "vectors": of_vectors, "x": 2.0, "count": 3}
    found = texture_data({**uniforms, "matrix": np.eye(4)})
    assert list(found) == ["picture", "long", "vectors"] and found["picture"] is picture
    assert found["long"].shape == (3, 4096) and found["long"].dtype == long.dtype
    assert found["long"].reshape(-1)[:9000].tolist() == long.tolist() and not found["long"].reshape(-1)[9000:].any()
    assert found["vectors"].shape == (1, ARRAY_WIDTH, 3) and found["vectors"].all()
