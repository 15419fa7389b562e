"""The stages of the printed figures, worked by hand."""

import naive_published
import numpy as np
import pytest
from one_stage import assert_same_bits, call

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips as kernel
from sss_ref.language.pipeline import MeshDraw, Pass
from sss_ref.methods.published.printed_stages import (
    directly_lit_exact,
    entry_from_irradiance,
    entry_interpolated,
    image_sqrt_add,
    irradiance_gathered,
    lookup_vertex,
    phong_ungated,
    translucency_unclamped,
    untransformed_vertex,
)

# Twice as large, then moved by (10, 20, 30).
WORLD_FROM_MODEL = [[2, 0, 0, 10], [0, 2, 0, 20], [0, 0, 2, 30], [0, 0, 0, 1]]
CLIP_FROM_MODEL = [[1, 1, 1, 1], [0, 2, 0, 0], [0, 0, -1, 0.5], [0, 0, -1, 0]]
VERTEX = {"position": (1, 2, 3), "normal": (0, 0, 1), "uv": (0.25, 0.75)}
MATRICES = {"world_from_model": WORLD_FROM_MODEL, "clip_from_model": CLIP_FROM_MODEL}


def test_untransformed_vertex():
    # As mesh_vertex, but for the normal.
    assert call(untransformed_vertex, **VERTEX, **MATRICES) == (
        (7, 4, -2.5, -3),
        (12, 24, 36),
        (0, 0, 1),
        (0.25, 0.75),
    )


@pytest.mark.parametrize(
    ("light_clip", "entry_point"),
    [
        # (12, 24)/48 = (.25, .5); times .5 (inset), plus 1, halved: uv (.5625, .625), of 4 x 2 texels (1.75, .75) from
        # the first centre: lower row 10*.25 + 20*.75 = 17.5, upper 30*.25 + 40*.75 = 37.5, together 17.5*.25 + 37.5*.75
        # = 32.5. From the light at (12, 24, 0) straight along +z.
        ([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 48]], (12, 24, 32.5)),
        # w = 0: uv (0, 0), the lower left texel, 5.
        ([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 0]], (12, 24, 5)),
        # (12, 24)/-12 = (-1, -2), inset and shifted: uv (.25, 0) after the clamp; between 5 and 10.
        ([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, -12]], (12, 24, 7.5)),
    ],
)
def test_lookup_vertex(light_clip, entry_point):
    distances = [[5, 10, 20, 0], [6, 30, 40, 0]]
    light = {"light_position": (12, 24, 0), "lookup_inset": 0.5, "light_distance": np.array(distances, np.float32)}
    result = call(lookup_vertex, **VERTEX, **MATRICES, light_clip_from_world=light_clip, **light)
    assert result == ((7, 4, -2.5, -3), (12, 24, 36), (0, 0, 1), (0.25, 0.75), entry_point)


def test_entry_interpolated():
    assert call(entry_interpolated, position_world=(1, 2, 3), fragment_entry_point=(1, 6, 0)) == ((1, 6, 0), 5)


def test_entry_from_irradiance():
    # The map holds 2 at the left and 4 at the right: 3 at uv .5, of red alone. From (0, 0, 1) along -z to (0, 0, -2).
    irradiance = np.array([[[2, 9, 9], [4, 9, 9]]], np.float32)
    light = {"light_position": (0, 0, 1), "irradiance": irradiance}
    assert call(entry_from_irradiance, position_world=(0, 0, -7), uv=(0.5, 0.5), **light) == ((0, 0, -2), 5)


@pytest.mark.parametrize(("thickness", "lit"), [(0, True), (1e-45, False), (1, False)])
def test_directly_lit_exact(thickness, lit):
    assert call(directly_lit_exact, thickness=thickness) == (lit,)


@pytest.mark.parametrize(
    ("normal", "expected"),
    [
        # Light and eye straight above: N.L = 1, V.R = 1: .25 + .5*1*2 + .5*3*1 = 2.75 in red, .25 + .5 + .75 in green.
        ((0, 0, 1), (2.75, 1.5)),
        # N turned away: no diffuse light, but the mirror image of -L about N is the same, so the highlight stays.
        ((0, 0, -1), (1.75, 1)),
        # N to the side: R = -L, behind: ambient alone.
        ((1, 0, 0), (0.25, 0.25)),
    ],
)
def test_phong_ungated(normal, expected):
    surface = {"position_world": (0, 0, 0), "normal_world": normal, "albedo": (1, 1, 0)}
    light = {"light_position": (0, 0, 2), "camera_position": (0, 0, 5), "incident_light": (1, 0.5, 1)}
    terms = {"ambient": 0.25, "diffuse": 1, "specular": 1.5, "shininess": 8}
    assert call(phong_ungated, **surface, **light, **terms) == ((*expected, 0),)


@pytest.mark.parametrize(
    ("thickness", "lit", "expected"),
    [
        (4, False, 4),  # 2^(4 / 4^.5)
        (0.0625, False, 65504),  # 2^(4 / .25) = 65536, bounded
        (0.25, False, 256),
        (0, True, 0),
    ],
)
def test_translucency_unclamped(thickness, lit, expected):
    material = {"x": 2, "y": 4, "exponent": 0.5}
    assert call(translucency_unclamped, thickness=thickness, directly_lit=lit, **material) == (expected,)


def test_irradiance_gathered():
    # Texels 1, 3 below and 5, 7 above; the first tap is at their middle: 4. The second, half a texel to the right and
    # one and a half up, beyond the edge: 7.
    irradiance = np.array([[[1, 1, 1], [3, 3, 3]], [[5, 5, 5], [7, 7, 7]]], np.float32)
    taps = {"tap_offset": [[0, 0], [0.25, 0.75]], "tap_weight": [[0.5, 1, 0], [0.25, 0, 1]], "tap_count": 2}
    result = call(irradiance_gathered, uv=(0.5, 0.5), irradiance=irradiance, **taps, pixel_scale=2)
    assert result == ((0.5 * 4 + 0.25 * 7, 4, 7),)


def test_image_sqrt_add():
    # sqrt(4*1) + .5*(2*.25)*(1 - 0) = 2.25; sqrt of what is below 0 is 0; N faces away from the light.
    values = {"irradiance_used": (4, 1, -1), "phong": (1, 0.25, 1), "albedo": (0.5, 0, 1), "translucency": 2}
    geometry = {"position_world": (0, 0, 0), "normal_world": (0, 0, 1), "translucency_scale": 0.25}
    assert call(image_sqrt_add, **values, **geometry, light_position=(0, 0, -2)) == ((2.25, 0.5, 0.5),)
    assert call(image_sqrt_add, **values, **geometry, light_position=(0, 0, 2)) == ((2, 0.5, 0),)


def random_inputs(seed):
    rng = np.random.default_rng(seed)
    counts = {"position": 3, "normal": 3, "uv": 2}
    mesh = {name: rng.normal(size=(200, count)).astype(np.float32) for name, count in counts.items()}
    mesh["position"][:20] = 0  # below, w is 0 there
    sizes = ("world_from_model", "clip_from_model", "light_clip_from_world")
    given = {name: rng.normal(size=(4, 4)).astype(np.float32) for name in sizes}
    given["world_from_model"][:, 3] = (0, 0, 0, 1)
    given["light_clip_from_world"][3, 3] = 0
    given["light_position"] = np.array([0.5, 2, 1], np.float32)
    given["lookup_inset"] = np.float32(0.99)
    given["light_distance"] = rng.random((5, 7)).astype(np.float32)
    return mesh, given


@pytest.mark.parametrize("stage", [untransformed_vertex, lookup_vertex])
@pytest.mark.parametrize("interpreter", [arrays, kernel])
def test_both_interpreters_give_the_bits_of_the_naive_form(interpreter, stage):
    mesh, given = random_inputs(seed=4)
    given = {name: value for name, value in given.items() if name in stage.parameters}
    draw = MeshDraw(stage, "triangle", "depth")
    varyings = {name: 3 * k for k, name in enumerate(draw.varyings)}  # each has three columns, the last of uv unused
    columns = 3 * len(varyings)
    clip_position, attributes = interpreter.run_vertices(Pass("vertices", "", draw, ()), mesh, given, varyings, columns)
    attributes[:, 8] = 0
    for k, vertex in enumerate(zip(*map(list, mesh.values()), strict=True)):
        clip, *rest = getattr(naive_published, stage.name)(*vertex, **given)
        expected = np.zeros(columns, np.float32)
        for number, value in enumerate(rest):
            expected[3 * number : 3 * number + len(value)] = value
        assert_same_bits({"clip": clip_position[k, None, None]}, {"clip": np.array(clip)[None, None]})
        assert_same_bits({"varyings": attributes[k, None, None]}, {"varyings": expected[None, None]})
