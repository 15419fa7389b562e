"""Random fragments for every stage, seeded, with the degenerate ones that a renderer meets mixed in."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from one_stage import Inputs

LIGHT_POSITION = np.array([0.25, 0.5, 1.0], np.float32)
LIGHT_CLIP_FROM_WORLD = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, -0.25], [0, 0, -1, 0]], np.float32)  # w = -z
MAP_WIDTH, MAP_HEIGHT = 7, 5
LAYOUT_WIDTH, LAYOUT_HEIGHT = 6, 9  # of the blurred irradiance

POSITIONS = [
    LIGHT_POSITION,
    LIGHT_POSITION - np.array([0, 0, 1], np.float32),  # straight below the light, and on its plane w = 0
    [1, 0.5, -1],  # u = 1
    [-1, 0.5, -1],  # u = 0
    [0.25, 1, -1],  # v = 1
    [0.25, -1, -1],  # v = 0
    [1, 1, -1],
    [1.0000001, 0.5, -1],  # just outside the map
    [0.5, 0.5, 0],  # w = 0
    [0.5, 0.5, 2],  # behind the light
    [-0.0, -0.0, -0.0],
    [-0.0, 0.5, -2],
    [1e-30, 1e-30, -1e-30],  # its squares underflow
]
NORMALS = [[0, 0, 0], [-0.0, -0.0, -0.0], [1, 0, 0], [-1, 0, 0], [0, 0, 1], [0, 0, -1], [1e-30, 0, 0]]
TANGENTS = [[0, 0, 0, 1], [0, 0, 1, -1], [0, 0, -1, -0.0], [1e-30, 0, 0, -1], [1, 0, 0, -1e-30]]  # none, along normals
COLORS = [[0, 0, 0], [-0.0, 0, -0.0], [1, 1, 1]]
HALVES = [[0.5 / 255, 1.5 / 255, 254.5 / 255], [-0.0, 0, 1], [100.5 / 255, 1e30, -1e30]]  # between two bytes, and far
UVS = [[0, 0], [1, 1], [-0.0, 0.5], [0.5, 1]]
OUTSIDE = [[-1, -1], [-0.25, 0.5], [1.5, 1.25]]  # no point of the shadow map; UVs that were clipped away
FAR_UVS = [*UVS, [-1e-30, 1.0000001], [0.99999994, -1], [3, 1e30], [-0.5, 2.05]]  # -1e-30 - floor(-1e-30) rounds to 1
THICKNESSES = [0.0, 1e-30, 0.1, 0.09999999, 1e30]  # with d_min = .1: both sides of it

LENGTHS = [0.0, -1.0, 1e-30, 1e30]  # nothing drawn, behind the camera
SCALES = [0.0, 1.0, 0.5, 4096.0]

KERNEL = [
    (0.0, 0.0, 0.22, 0.487, 0.635),
    (1.63, 0.04, 0.08, 0.064, 0.039),
    (-0.24, -0.22, 0.13, 0.15, 0.104),
    (5.97, 0.25, 0.048, 0.003, 0.0004),
    (-4.02, 4.16, 0.05, 0.006, 0.0014),
]


def taps(rows: Sequence[tuple[float, ...]]) -> dict[str, Any]:
    """The uniforms of a blur kernel with rows (x, y, red, green, blue)."""
    table = np.array(rows, np.float32)
    offset, weight = np.ascontiguousarray(table[:, :2]), np.ascontiguousarray(table[:, 2:])
    return {"tap_offset": offset, "tap_weight": weight, "tap_count": len(rows)}


UNIFORMS: dict[str, Any] = {
    "light_position": LIGHT_POSITION,
    "light_direction": np.array([-0.48, -0.64, -0.6], np.float32),
    "camera_direction": np.array([0.28, 0, -0.96], np.float32),
    "light_clip_from_world": LIGHT_CLIP_FROM_WORLD,
    "light_texel_size": np.float32(0.01),
    "light_color": np.array([1, 0.9, 0.7], np.float32),
    "light_intensity": np.float32(1.1),
    "light_count": np.float32(1),
    "lookup_inset": np.float32(1),
    "bias_abs": np.float32(0),
    "bias_slope": np.float32(1.5),
    "lookup_depth": np.float32(6),
    "kernel_scale": np.float32(6),
    "camera_position": np.array([0, 0.5, 3], np.float32),
    "camera_clip_from_world": np.array([[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, -1, 2.9], [0.1, 0, -1, 3]], np.float32),
    "camera_pixel_size": np.float32(0.03),
    "ahead": np.array([0.3, -0.2, -0.9], np.float32),
    "mm_per_unit": np.float32(15),
    "mm_per_offset": np.float32(1.2),
    "extinction_per_mm": np.array([0.1, 0, 0.7], np.float32),
    "triangle_stretch": np.array(
        [[0.1, 0.2], [0.03, 0.1], [0, 0], [1e30, 0.7], [1, 1], [2, 0.3], [0.1, 0]], np.float32
    ),
    "mesh_color": np.array([0.7, 0.4, -0.0], np.float32),
    "triangle_material": np.array([0, 3, 1, 1, 2, 0, 3], np.int32),
    "material_color": np.array([[0.1, 0.2, 0.3], [1, 0, -0.0], [0, 0, 0], [0.7, 0.6, 0.5]], np.float32),
    "normal_scale": np.array([1.5, -0.75], np.float32),
    "background": np.array([0.1, -0.0, 0.3], np.float32),
    "ambient": np.float32(0.1),
    "diffuse": np.float32(0.9),
    "specular": np.float32(0.5),
    "shininess": np.float32(32),
    "x": np.float32(2),
    "y": np.float32(-1),
    "exponent": np.float32(0.6),
    "d_min": np.float32(0.1),
    "translucency_neutral": np.float32(1),
    "x_by_channel": np.array([2, 0.7, 1.5], np.float32),
    "y_by_channel": np.array([-1, 0.5, 3], np.float32),
    "exponent_by_channel": np.array([0.6, 1, 0.3], np.float32),
    "d_min_by_channel": np.array([0.1, 0, 0.5], np.float32),
    "scale_by_channel": np.array([0.2, 1, 0], np.float32),
    "gaussian_weight": np.array([[0.233, 0.455, 0.649], [0.1, 0.3, 0], [0.7, 0.2, 0.4]], np.float32),
    "gaussian_variance": np.array([0.0064, 0.5, 740], np.float32),
    "gaussian_count": 3,
    "translucency_scale": np.float32(0.2),
    "wrap": np.float32(0.3),
    "kernel_offset": np.array([[-1, 0], [-0.25, 0], [0, 0], [0.25, 0], [0, 1]], np.float32),
    "kernel_weight": np.array(
        [[0.1, 0, 0.01], [0.2, 0.1, -0.1], [0.4, 0.8, 1], [0.2, 0.1, 0], [0, 0.1, 0]], np.float32
    ),
    "kernel_count": 5,
    "sample_place": np.array([[0.01, 0.02], [-0.3, 0.4], [0.8, -0.5], [-1, 0.1]], np.float32),
    "sample_radius": np.array([1e-3, 0.4, 2, 9], np.float32),
    "sample_area": np.array([2e-3, 0.9, 7, 300], np.float32),
    "sample_count": 4,
    "scatter_distance": np.array([0.7, 0.3, 1e-4], np.float32),
    "reach_mm": np.float32(9),
    "spread_mm": np.float32(0.4),
    "spread_offset": np.array([[0, k] for k in range(-3, 4)], np.float32),
    "spread_weight": np.array([0.01, 0.06, 0.24, 0.38, 0.24, 0.06, 0.01], np.float32),
    "profile_weight": np.array(
        [[0.2, 0.5, 0.6], [0.1, 0.3, 0.4], [0.1, 0.2, 0], [0.1, 0, 0], [0.4, 0, 0], [0.1, 0, 0]], np.float32
    ),
    "profile_variance": np.array([0.0064, 0.05, 0.2, 0.6, 2, 740], np.float32),
    "triangle_curvature": np.array(
        [
            [1, 2, -1, 0.3],
            [0, 0, 0, 1],
            [-3, 0.1, 2, -0.5],
            [0, 0, 0, 0],
            [1e30, -1e30, 1, 1],
            [9, 8, 7, 6],
            [0, -0.0, 0, -0.0],
        ],
        np.float32,
    ),
    "sharpest_curvature": np.float32(0.5),
    "pixel_scale": np.float32(1),
    "offset": np.array([-1.3, 2.6], np.float32),
    "weight": np.array([0.3, 0.2, 0.1], np.float32),
    **taps(KERNEL),
}

OVERFLOW = {"x": np.float32(3), "y": np.float32(90)}  # 3^90 is beyond float32: translucency_max decides
TRANSLUCENCY = [{"translucency_neutral": np.float32(0), "x": np.float32(0.3), "y": np.float32(1.5)}, OVERFLOW]
FAR = {"pixel_scale": np.float32(30)}  # beyond the picture
BLUR = [
    taps([(5, -2, 1, 0.5, 0.25)]),  # no tap in the middle: beside the model nothing is kept
    FAR,
    {"pixel_scale": np.float32(0.37)},
]
LONE_OFFSET = {
    "kernel_offset": np.array([[0, -30]], np.float32),
    "kernel_weight": np.ones((1, 3), np.float32),
    "kernel_count": 1,
}
VARIANTS: dict[str, list[dict[str, Any]]] = {  # stage -> further uniforms to run it with
    "shadow_lookup_nearest": [{"lookup_inset": np.float32(0.99)}],
    "shadow_lookup_bilinear": [{"lookup_inset": np.float32(0.99)}],
    "directly_lit_slope": [{"bias_abs": np.float32(0.01), "bias_slope": np.float32(0)}],
    "directly_lit_literal": [{"bias_abs": np.float32(0.01)}],
    "phong_shading": [{"light_count": np.float32(3), "shininess": np.float32(0.3)}],
    "translucency_ratio": TRANSLUCENCY,
    "translucency_exponent": TRANSLUCENCY,
    "translucency_beer": TRANSLUCENCY,
    "translucency_gaussians": [{"translucency_neutral": np.float32(0), "gaussian_count": 1}],
    "translucency_ratio_throughout": TRANSLUCENCY,
    "translucency_exponent_throughout": TRANSLUCENCY,
    "translucency_beer_throughout": TRANSLUCENCY,
    "translucency_gaussians_throughout": [{"translucency_neutral": np.float32(0), "gaussian_count": 1}],
    "below_surface": [{"lookup_depth": np.float32(0)}],
    "light_visible_kernel": [{"kernel_scale": np.float32(0), **taps([(1, 2, 0, -0.5, 1), (0, 0, 0, 1, 0)])}],
    "lit_transmit": [{"light_count": np.float32(3)}],
    "lit_transmit_wrapped": [{"light_count": np.float32(3), "wrap": np.float32(0)}],
    "gloss_where_lit": [{"shininess": np.float32(0.3)}],
    "translucency_unclamped": [{"x": np.float32(0.3), "y": np.float32(1.5)}, OVERFLOW],
    "phong_ungated": [{"shininess": np.float32(0.3)}],
    "irradiance_gathered": [FAR],
    "irradiance_added": [{"translucency_scale": np.float32(0)}],
    "irradiance_added_wrapped": [{"wrap": np.float32(0)}],
    "scatter": BLUR,
    "single_tap": [FAR],
    "scatter_inside": BLUR,
    "scatter_on_surface": BLUR,
    "scatter_inside_surface": BLUR,
    "phong_preintegrated": [{"light_count": np.float32(3), "shininess": np.float32(0.3)}],
    "directly_lit_round": [{"bias_abs": np.float32(0.01), "bias_slope": np.float32(0)}],
    "gaussian_along": [{"spread_mm": np.float32(3)}],
    "scatter_burley": [{"sample_count": 1}],
    "scatter_along": [LONE_OFFSET],
}


@dataclass
class Picture:
    """Draws random buffers of one size."""

    rng: np.random.Generator
    width: int
    height: int

    def mixed(self, values: np.ndarray, degenerate: Any) -> np.ndarray:
        """The values, three tenths of them replaced by degenerate ones."""
        chosen = self.rng.choice(np.array(degenerate, np.float32), self.shape)
        replaced = self.rng.random(self.shape) < 0.3
        return np.where(replaced.reshape(values.shape[:2] + (1,) * (values.ndim - 2)), chosen, values).astype(
            np.float32
        )

    def color(self) -> np.ndarray:
        """Linear RGB in [0, 1]."""
        return self.mixed(self.rng.random((*self.shape, 3)), COLORS)

    def truth(self, share: float) -> np.ndarray:
        """1 in this share of the pixels."""
        return (self.rng.random(self.shape) < share).astype(np.uint8)

    @property
    def shape(self) -> tuple[int, int]:
        """As ndarrays have it."""
        return self.height, self.width


def random_inputs(rng: np.random.Generator, width: int, height: int) -> Inputs:
    """Every buffer and uniform that stages read."""
    picture = Picture(rng, width, height)
    buffers = {**geometry(picture), **shading(picture), **shadow_map(rng), **texture_space(picture), **colors(picture)}
    return Inputs(width, height, {**buffers, **lengths(picture), **detail(picture), **inside(picture)}, UNIFORMS)


def geometry(picture: Picture) -> dict[str, np.ndarray]:
    """Where fragments lie, which way they face, and how far from the light the shadow map says they are."""
    rng = picture.rng
    position = picture.mixed(rng.uniform([-1.2, -1.2, -2], [1.2, 1.2, 0.2], (*picture.shape, 3)), POSITIONS)
    normal = picture.mixed(rng.normal(size=(*picture.shape, 3)), NORMALS)
    length = np.sqrt((normal.astype(float) ** 2).sum(axis=2, keepdims=True))
    own_distance = np.sqrt(((position.astype(float) - LIGHT_POSITION) ** 2).sum(axis=2))
    nearer = rng.choice([0, 1e-7, 0.003, 0.02, 0.1, 0.6], picture.shape)  # by rounding, within the bias and beyond it
    return {
        "fragment_position": position,
        "fragment_normal": normal,
        "fragment_entry_point": np.where(rng.random((*picture.shape, 1)) < 0.3, position, position * np.float32(0.75)),
        "fragment_uv": picture.mixed(rng.random((*picture.shape, 2)), UVS),
        "position_world": position,
        "unmapped_normal_world": (normal / np.maximum(length, 1e-30)).astype(np.float32),
        "normal_world": (normal / np.maximum(length, 1e-30)).astype(np.float32),
        "stored_distance": (own_distance * (1 - nearer)).astype(np.float32),
        "thickness": picture.mixed(rng.exponential(size=picture.shape), THICKNESSES),
    }


def shading(picture: Picture) -> dict[str, np.ndarray]:
    """Colours, factors and decisions; `lit` is 0 beside the model, and the left quarter holds no model."""
    coverage = picture.truth(0.6)
    coverage[:, : picture.width // 4] = 0
    return {
        "albedo": picture.color(),
        "incident_light": picture.color(),
        "phong": picture.color(),
        "shadow_valid": picture.truth(0.8),
        "directly_lit": picture.truth(0.5),
        "light_visible": picture.color(),
        "translucency": picture.mixed(picture.rng.exponential(size=picture.shape), [0.0, 1.0, 65504.0]),
        "coverage": coverage,
        "lit": picture.color() * coverage[..., None].astype(np.float32),
        "scattered": picture.color(),
        "color": picture.mixed(picture.rng.uniform(-0.5, 1.5, (*picture.shape, 3)), HALVES),
        "value": picture.mixed(picture.rng.uniform(-0.5, 1.5, picture.shape), HALVES[0]),
    }


def shadow_map(rng: np.random.Generator) -> dict[str, np.ndarray]:
    """A shadow map of a size of its own, with some background."""
    shape = MAP_HEIGHT, MAP_WIDTH
    return {
        "light_distance": rng.uniform(0.3, 3, shape).astype(np.float32),
        "light_triangle": rng.choice(np.array([-1, 0, 5, 6, 7, 8], np.int32), shape),
        "light_normal": rng.choice(np.float32([0, -0.6, 0.8, 1]), (*shape, 3)),
        "light_uv": np.where(rng.random((*shape, 1)) < 0.2, -1, rng.random((*shape, 2))).astype(np.float32),
    }


def texture_space(picture: Picture) -> dict[str, np.ndarray]:
    """A sparse irradiance map with texels on its border, the blurred one, and UVs at which fragments look it up."""
    rng = picture.rng
    mask = picture.truth(0.1)
    mask[0, :4] = mask[-1, -4:] = 1
    return {
        "irradiance": picture.color(),  # black beside the charts or not, as a dump may have it
        "irradiance_mask": mask,
        "scattered_irradiance": rng.random((LAYOUT_HEIGHT, LAYOUT_WIDTH, 3)).astype(np.float32),
        **{f"spread_{one}": rng.random((LAYOUT_HEIGHT, LAYOUT_WIDTH, 3)).astype(np.float32) for one in "abcdef"},
        "texels_per_mm": picture.mixed(rng.exponential(size=(*picture.shape, 2)), [[0, 0], [4096, 1], [0.5, 3]]),
        "uv": picture.mixed(rng.random((*picture.shape, 2)), UVS + OUTSIDE),
        "shadow_uv": picture.mixed(rng.random((*picture.shape, 2)), UVS + OUTSIDE),
        "irradiance_uv": picture.mixed(rng.random((*picture.shape, 2)), UVS + OUTSIDE),
        "irradiance_used": picture.color() - np.float32(0.25),  # below 0 where a kernel has negative weights
        "gloss": picture.color(),
        "first": picture.color(),
        "second": picture.color(),
    }


def colors(picture: Picture) -> dict[str, np.ndarray]:
    """What the albedo comes from: a texture of a size of its own with uv in and beyond it, and triangles."""
    rng = picture.rng
    return {
        "uv": picture.mixed(rng.uniform(-2, 3, (*picture.shape, 2)), FAR_UVS),
        "diffusion_table": rng.random((MAP_HEIGHT, MAP_WIDTH, 3)).astype(np.float32),
        "albedo_map": rng.random((MAP_HEIGHT, MAP_WIDTH, 3)).astype(np.float32),
        "triangle": rng.integers(0, len(UNIFORMS["triangle_material"]), picture.shape).astype(np.int32),
    }


def lengths(picture: Picture) -> dict[str, np.ndarray]:
    """What a pixel or texel spans, and how many of them an offset is; T of each channel."""
    one, both = ((*picture.shape, *axes) for axes in ((), (2,)))
    return {
        "translucency_by_channel": picture.mixed(picture.rng.exponential(size=(*picture.shape, 3)), [[0, 1, 65504]]),
        "curvature": picture.mixed(picture.rng.uniform(0, 0.5, one), [0, 0.5]),
        "mm_per_pixel": picture.mixed(picture.rng.exponential(size=one), LENGTHS),
        "pixels_per_offset": picture.mixed(picture.rng.exponential(size=one), SCALES),
        "mm_per_texel": picture.mixed(picture.rng.exponential(size=both), [[0, 0], [1e30, 1e-30], [-1, 2]]),
        "texels_per_offset": picture.mixed(picture.rng.exponential(size=both), [[0, 0], [4096, 1], [0.5, 3]]),
    }


def inside(picture: Picture) -> dict[str, np.ndarray]:
    """A body inside another one, behind the outer surface or before it, and the shadow map of the one around."""
    rng = picture.rng
    position = rng.uniform([-1.2, -1.2, -2], [1.2, 1.2, 0.2], (*picture.shape, 3))
    return {
        "light_around": picture.color(),
        "inner_lit": picture.color(),
        "inner_position_world": picture.mixed(position, POSITIONS),
        "inner_coverage": picture.truth(0.7),
        "around_distance": rng.uniform(0.3, 3, (MAP_HEIGHT, MAP_WIDTH)).astype(np.float32),
        "around_triangle": rng.choice(np.array([-1, 0, 5], np.int32), (MAP_HEIGHT, MAP_WIDTH)),
    }


def detail(picture: Picture) -> dict[str, np.ndarray]:
    """Tangents, and what is mapped along them; some texels of the normal map have no direction."""
    rng = picture.rng
    return {
        "fragment_tangent": picture.mixed(rng.normal(size=(*picture.shape, 4)), TANGENTS),
        "normal_map": rng.choice(np.float32([0, 0.5, 1]), (MAP_HEIGHT, MAP_WIDTH, 3)),
        "specular_map": np.repeat(rng.random((MAP_HEIGHT, MAP_WIDTH, 1)).astype(np.float32), 3, axis=2),
    }
