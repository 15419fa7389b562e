"""Solutions of lesson 13."""

import numpy as np


def dot(a, b):
    """Of vectors (H, W, 3)."""
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def length(v):
    """Of vectors (H, W, 3)."""
    return np.sqrt(dot(v, v))


def unit(v):
    """Vectors of length 1; 0 stays 0."""
    return v / np.maximum(length(v), np.float32(1e-20))[..., None]


def clip_of(position, matrix):
    """Positions in the light's clip space (H, W, 4)."""
    return position @ matrix[:, :3].T + matrix[:, 3]


def own_stored_distance(
    position_world, light_position, light_clip_from_world, lookup_inset, light_distance, light_triangle
):
    """The nearest texel; the fragment's own distance where the map has none."""
    clip = clip_of(position_world, light_clip_from_world)
    uv = (clip[..., :2] / clip[..., 3:] * lookup_inset + 1) / 2
    inside = (clip[..., 3] > 0) & (uv >= 0).all(axis=-1) & (uv <= 1).all(axis=-1)
    side = np.array(light_distance.shape[::-1])
    column, row = np.moveaxis(np.clip(np.floor(uv * side), 0, side - 1).astype(int), -1, 0)
    valid = inside & (light_triangle[row, column] >= 0)
    return np.where(valid, light_distance[row, column], length(position_world - light_position))


def own_directly_lit(
    position_world,
    normal_world,
    light_position,
    light_clip_from_world,
    light_texel_size,
    stored_distance,
    bias_abs,
    bias_slope,
):
    """It faces the light, and lies no further behind than a texel's footprint."""
    facing = dot(normal_world, unit(light_position - position_world))
    cosine = np.clip(np.abs(facing), 0.05, 1)
    texel = np.maximum(clip_of(position_world, light_clip_from_world)[..., 3], 0) * light_texel_size
    bias = bias_abs + bias_slope * texel * (1 + np.sqrt(1 - cosine * cosine) / cosine)
    return (facing > 0) & (length(position_world - light_position) - stored_distance <= bias)


def own_phong(
    position_world,
    normal_world,
    albedo,
    light_position,
    camera_position,
    incident_light,
    ambient,
    diffuse,
    specular,
    shininess,
):
    """Ambient, diffuse, specular."""
    to_light, to_eye = unit(light_position - position_world), unit(camera_position - position_world)
    facing = dot(normal_world, to_light)
    mirrored = dot(2 * facing[..., None] * normal_world - to_light, to_eye)
    shine = np.where((facing > 0) & (mirrored > 0), np.maximum(mirrored, 0) ** shininess, 0)
    strength = diffuse * np.maximum(facing, 0) + specular * shine
    return (ambient + incident_light * strength[..., None]) * albedo


def own_thickness(position_world, light_position, stored_distance, shadow_valid):
    """From the entry point to the fragment."""
    entry = light_position + unit(position_world - light_position) * stored_distance[..., None]
    return np.where(shadow_valid != 0, length(position_world - entry), 0)


def own_translucency(thickness, directly_lit, shadow_uv, x, y, exponent, d_min, translucency_neutral):
    """x^y / d^exponent where light may come through."""
    term = x**y / np.maximum(thickness, d_min) ** exponent
    return np.where((directly_lit == 0) & (shadow_uv[..., 0] >= 0), term, translucency_neutral)


def own_lit(
    phong,
    albedo,
    directly_lit,
    translucency,
    incident_light,
    position_world,
    normal_world,
    light_position,
    translucency_scale,
    ambient,
):
    """Phong or the ambient term, and what enters from behind."""
    from_behind = np.maximum(-dot(normal_world, unit(light_position - position_world)), 0)
    reflected = np.where(directly_lit[..., None] != 0, phong, ambient * albedo)
    return reflected + albedo * incident_light * (translucency * translucency_scale * from_behind)[..., None]


def own_scattered(lit, coverage, tap_offset, tap_weight, pixel_scale):
    """Taps between four pixels each, clamped to the border; written where the model is."""
    height, width = coverage.shape
    rows, columns = np.indices((height, width))
    total = np.zeros_like(lit)
    for (x, y), weight in zip(tap_offset * pixel_scale, tap_weight, strict=True):
        left, down = int(np.floor(x)), int(np.floor(y))
        for right, share_x in ((0, 1 - (x - left)), (1, x - left)):
            for up, share_y in ((0, 1 - (y - down)), (1, y - down)):
                row = np.clip(rows + down + up, 0, height - 1)
                column = np.clip(columns + left + right, 0, width - 1)
                total += lit[row, column] * (share_x * share_y) * weight
    return np.where(coverage[..., None] != 0, total, 0)


def own_image(scattered, coverage, background):
    """The model where it is."""
    return np.where(coverage[..., None] != 0, scattered, background)
