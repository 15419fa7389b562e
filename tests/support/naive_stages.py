"""Every stage as the rules state it, for one fragment: the values its buffers get, in order.

Imports nothing of the package; numbers are as in naive_language. A stage of the package has its namesake here, with
the same parameters.
"""

import gmpy2
import numpy as np
from naive_language import (
    F,
    added,
    between_centres,
    bilinear,
    correctly_rounded,
    cross,
    dot,
    fetch,
    four_texels,
    length,
    maximum,
    minimum,
    minus,
    mix,
    nearest,
    negative,
    normalize,
    power,
    reflect,
    scaled,
    split,
    times,
    transform,
)

# The mesh, and the surface that the camera sees


def mesh_vertex(position, normal, uv, world_from_model, normal_from_model, clip_from_model):
    model = [*position, F(1)]
    return (
        transform(clip_from_model, model),
        transform(world_from_model, model)[:3],
        transform(normal_from_model, normal),
        uv,
    )


def layout_vertex(position, normal, uv, world_from_model, normal_from_model):
    flat = [v * F(2) - F(1) for v in uv]
    world = transform(world_from_model, [*position, F(1)])[:3]
    return [*flat, F(0), F(1)], world, transform(normal_from_model, normal), uv


def tangent_vertex(position, normal, uv, tangent, world_from_model, normal_from_model, handedness, clip_from_model):
    along = transform(world_from_model, [*tangent[:3], F(0)])[:3]
    seen = mesh_vertex(position, normal, uv, world_from_model, normal_from_model, clip_from_model)
    return *seen, [*along, tangent[3] * handedness]


def tangent_layout_vertex(position, normal, uv, tangent, world_from_model, normal_from_model, handedness):
    along = transform(world_from_model, [*tangent[:3], F(0)])[:3]
    return *layout_vertex(position, normal, uv, world_from_model, normal_from_model), [*along, tangent[3] * handedness]


def surface(fragment_position, fragment_normal, fragment_uv):
    return fragment_position, normalize(fragment_normal), fragment_uv


def albedo_constant(mesh_color):
    return (mesh_color,)


def _repeated(picture, uv):
    corner, t = between_centres(picture, [v - np.floor(v) for v in uv])
    framed = np.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="wrap")  # what repeats stands around the picture
    return bilinear(framed, [k + 1 for k in corner], t)


def albedo_textured(uv, albedo_map):
    return (_repeated(albedo_map, uv),)


def albedo_by_material(triangle, triangle_material, material_color):
    return (material_color[triangle_material[triangle]],)


def normal_mapped(unmapped_normal_world, fragment_tangent, uv, normal_map, normal_scale):
    n, tangent = unmapped_normal_world, fragment_tangent[:3]
    x, y, z = (v * F(2) - F(1) for v in _repeated(normal_map, uv))
    along = normalize(minus(tangent, scaled(n, dot(n, tangent))))
    if not dot(along, along) > 0:
        return (n,)
    across = scaled(cross(n, along), F(-1) if fragment_tangent[3] < 0 else F(1))
    sideways = added(scaled(along, x * normal_scale[0]), scaled(across, y * normal_scale[1]))
    return (normalize(added(sideways, scaled(n, z))),)


def specular_mapped(uv, specular_map, specular):
    return (specular * _repeated(specular_map, uv)[0],)


# Shadow map


def distance_to_light(fragment_position, light_position):
    return (length(minus(fragment_position, light_position)),)


def uv_at_light(fragment_uv):
    return (fragment_uv,)


def _shadow_uv(position, clip_from_world, lookup_inset):
    """Where a position falls on the shadow map, or None behind the light or outside its map."""
    x, y, _, w = transform(clip_from_world, [*position, F(1)])
    if w <= 0:
        return None
    uv = [((v / w) * lookup_inset + F(1)) * F(0.5) for v in (x, y)]
    return uv if all(0 <= v <= 1 for v in uv) else None


def shadow_lookup_nearest(
    position_world, light_position, light_clip_from_world, lookup_inset, light_distance, light_triangle
):
    own_distance = length(minus(position_world, light_position))
    uv = _shadow_uv(position_world, light_clip_from_world, lookup_inset)
    if uv is None:
        return [F(-1), F(-1)], False, own_distance
    if nearest(light_triangle, uv)[0] < 0:
        return uv, False, own_distance
    return uv, True, nearest(light_distance, uv)[0]


def shadow_lookup_bilinear(
    position_world, light_position, light_clip_from_world, lookup_inset, light_distance, light_triangle
):
    uv, valid, stored = shadow_lookup_nearest(
        position_world, light_position, light_clip_from_world, lookup_inset, light_distance, light_triangle
    )
    if valid:
        corner, t = between_centres(light_distance, uv)
        if all(triangle[0] >= 0 for triangle in four_texels(light_triangle, corner)):
            stored = bilinear(light_distance, corner, t)[0]
    return uv, valid, stored


def back_point(position_world, light_position, stored_distance, shadow_valid):
    if not shadow_valid:
        return position_world, F(0)
    direction = normalize(minus(position_world, light_position))
    entry_point = added(light_position, scaled(direction, stored_distance))
    return entry_point, length(minus(position_world, entry_point))


def back_point_parallel(position_world, light_position, light_direction, stored_distance, shadow_valid):
    if not shadow_valid:
        return position_world, F(0)
    inside = dot(minus(position_world, light_position), light_direction) - stored_distance
    entry_point = minus(position_world, scaled(light_direction, inside))
    return entry_point, length(minus(position_world, entry_point))


def directly_lit_slope(
    position_world,
    normal_world,
    light_position,
    light_clip_from_world,
    light_texel_size,
    stored_distance,
    bias_abs,
    bias_slope,
):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    c = minimum(maximum(abs(facing), F(0.05)), F(1))
    w = transform(light_clip_from_world, [*position_world, F(1)])[3]
    texel = (w if F(0) < w else F(0)) * light_texel_size
    bias = bias_abs + bias_slope * (texel * (F(1) + np.sqrt(F(1) - c * c) / c))
    return (facing > 0 and length(minus(position_world, light_position)) - stored_distance <= bias,)


def directly_lit_literal(position_world, light_position, stored_distance, bias_abs):
    return (length(minus(position_world, light_position)) - stored_distance <= bias_abs,)


# Lengths


def pixel_length(position_world, camera_clip_from_world, camera_pixel_size, mm_per_unit):
    w = transform(camera_clip_from_world, [*position_world, F(1)])[3]
    return ((w * camera_pixel_size) * mm_per_unit,)


def texel_length(triangle, triangle_stretch, mm_per_unit):
    return (scaled(triangle_stretch[triangle], mm_per_unit),)


def offset_length(mm_per_pixel, mm_per_offset):
    """Of one length, or of each along two axes."""
    lengths = np.atleast_1d(mm_per_pixel)
    along = [minimum(mm_per_offset / maximum(v, F(1e-30)), F(4096)) for v in lengths]
    return (along if len(along) > 1 else along[0],)


# Phong


def light_constant(light_color, light_intensity):
    return (scaled(light_color, light_intensity),)


def light_inverse_square(position_world, light_position, light_color, light_intensity):
    distance = length(minus(position_world, light_position))
    falloff = F(1) / maximum(distance * distance, F(1e-8))
    return (scaled(light_color, light_intensity * falloff),)


def _highlight(position, normal, light_position, camera_position, shininess):
    to_light = normalize(minus(light_position, position))
    to_eye = normalize(minus(camera_position, position))
    mirrored = dot(to_eye, reflect(negative(to_light), normal))
    return F(0) if dot(normal, to_light) <= 0 or mirrored <= 0 else power(mirrored, shininess)


def phong_shading(
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
    light_count,
):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    s = _highlight(position_world, normal_world, light_position, camera_position, shininess)
    lambert = scaled(incident_light, diffuse * maximum(facing, F(0)))
    reflected = added([ambient / light_count + v for v in lambert], scaled(incident_light, specular * s))
    return (times(reflected, albedo),)


# Translucency


def _translucency(term, directly_lit, shadow_uv, neutral):
    return (neutral if directly_lit or shadow_uv[0] < 0 else minimum(term, F(65504)),)


def translucency_ratio(thickness, directly_lit, shadow_uv, x, y, exponent, d_min, translucency_neutral):
    term = power(x, y) / power(maximum(thickness, d_min), exponent)
    return _translucency(term, directly_lit, shadow_uv, translucency_neutral)


def translucency_exponent(thickness, directly_lit, shadow_uv, x, y, exponent, d_min, translucency_neutral):
    term = power(x, y / power(maximum(thickness, d_min), exponent))
    return _translucency(term, directly_lit, shadow_uv, translucency_neutral)


def translucency_beer(thickness, directly_lit, shadow_uv, x, translucency_neutral):
    term = correctly_rounded(gmpy2.exp, -x * thickness)
    return _translucency(term, directly_lit, shadow_uv, translucency_neutral)


def translucency_gaussians(
    thickness,
    directly_lit,
    shadow_uv,
    gaussian_weight,
    gaussian_variance,
    gaussian_count,
    mm_per_unit,
    translucency_neutral,
):
    depth, total = thickness * mm_per_unit, [F(0)] * 3
    for weight, variance in list(zip(gaussian_weight, gaussian_variance, strict=True))[:gaussian_count]:
        total = added(total, scaled(weight, correctly_rounded(gmpy2.exp, -(depth * depth) / variance)))
    return ([_translucency(term, directly_lit, shadow_uv, translucency_neutral)[0] for term in total],)


def light_inside(
    light_around, shadow_uv, stored_distance, around_distance, around_triangle, extinction_per_mm, mm_per_unit
):
    (entered,), way = nearest(around_distance, shadow_uv), F(0)
    if shadow_uv[0] >= 0 and nearest(around_triangle, shadow_uv)[0] >= 0:
        way = maximum(stored_distance - entered, F(0))
    return (_passed(light_around, way * mm_per_unit, extinction_per_mm),)


def seen_through(
    lit,
    position_world,
    inner_lit,
    inner_position_world,
    inner_coverage,
    camera_position,
    extinction_per_mm,
    mm_per_unit,
):
    outer, inner = (length(minus(point, camera_position)) for point in (position_world, inner_position_world))
    way = maximum(inner - outer, F(0)) * mm_per_unit if inner_coverage else F(0)
    return way, added(lit, _passed(inner_lit, way, extinction_per_mm))


def _passed(light, way, extinction_per_mm):
    return [v * correctly_rounded(gmpy2.exp, -k * way) for v, k in zip(light, extinction_per_mm, strict=True)]


def lit_multiply(phong, directly_lit, translucency):
    return (phong if directly_lit else scaled(phong, translucency),)


def lit_add(phong, albedo, translucency, position_world, normal_world, light_position, translucency_scale):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    factor = (translucency * translucency_scale) * (F(1) - maximum(facing, F(0)))
    return (added(phong, scaled(albedo, factor)),)


def lit_transmit(
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
    light_count,
):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    reflected = phong if directly_lit else scaled(albedo, ambient / light_count)
    factor = (translucency * translucency_scale) * maximum(-facing, F(0))
    return (added(reflected, scaled(times(albedo, incident_light), factor)),)


# Light from behind that goes round the terminator


def below_surface(position_world, normal_world, light_clip_from_world, light_texel_size, lookup_depth):
    w = transform(light_clip_from_world, [*position_world, F(1)])[3]
    return (minus(position_world, scaled(normal_world, lookup_depth * (maximum(w, F(0)) * light_texel_size))),)


def translucency_ratio_throughout(thickness, shadow_uv, x, y, exponent, d_min, translucency_neutral):
    return translucency_ratio(thickness, False, shadow_uv, x, y, exponent, d_min, translucency_neutral)


def translucency_exponent_throughout(thickness, shadow_uv, x, y, exponent, d_min, translucency_neutral):
    return translucency_exponent(thickness, False, shadow_uv, x, y, exponent, d_min, translucency_neutral)


def translucency_beer_throughout(thickness, shadow_uv, x, translucency_neutral):
    return translucency_beer(thickness, False, shadow_uv, x, translucency_neutral)


def translucency_gaussians_throughout(
    thickness, shadow_uv, gaussian_weight, gaussian_variance, gaussian_count, mm_per_unit, translucency_neutral
):
    terms = gaussian_weight, gaussian_variance, gaussian_count
    return translucency_gaussians(thickness, False, shadow_uv, *terms, mm_per_unit, translucency_neutral)


def _wrapped(position_world, normal_world, light_position, wrap):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    return maximum(wrap - facing, F(0)) / (F(1) + wrap)


def lit_transmit_wrapped(
    phong,
    albedo,
    directly_lit,
    translucency,
    incident_light,
    position_world,
    normal_world,
    light_position,
    translucency_scale,
    wrap,
    ambient,
    light_count,
):
    reflected = phong if directly_lit else scaled(albedo, ambient / light_count)
    factor = (translucency * translucency_scale) * _wrapped(position_world, normal_world, light_position, wrap)
    return (added(reflected, scaled(times(albedo, incident_light), factor)),)


# Soft shadows


def _is_seen(beside, light_position, light_clip_from_world, lookup_inset, light_distance, light_triangle, bias):
    uv = _shadow_uv(beside, light_clip_from_world, lookup_inset)
    if uv is None or nearest(light_triangle, uv)[0] < 0:
        return F(1)
    nearer = length(minus(beside, light_position)) - bias
    return F(1) if nearest(light_distance, uv)[0] >= nearer else F(0)


def light_visible_kernel(
    position_world,
    normal_world,
    light_position,
    light_clip_from_world,
    light_texel_size,
    lookup_inset,
    light_distance,
    light_triangle,
    tap_offset,
    tap_weight,
    tap_count,
    kernel_scale,
    bias_abs,
    bias_slope,
):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    if not facing > 0:
        return ([F(0)] * 3,)
    c = minimum(maximum(abs(facing), F(0.05)), F(1))
    falls = F(1) + np.sqrt(F(1) - c * c) / c
    texel = maximum(transform(light_clip_from_world, [*position_world, F(1)])[3], F(0)) * light_texel_size
    row = [transform(light_clip_from_world, [F(k == axis) for k in range(4)])[0] for axis in range(3)]
    across = normalize(minus(row, scaled(normal_world, dot(normal_world, row))))
    along = cross(normal_world, across)
    total, whole = [F(0)] * 3, [F(0)] * 3
    for tap in range(tap_count):
        x, y = (v * kernel_scale for v in tap_offset[tap])
        beside = added(position_world, scaled(added(scaled(across, x), scaled(along, y)), texel))
        bias = bias_abs + bias_slope * (texel * ((F(1) + F(0.125) * np.sqrt(x * x + y * y)) * falls))
        at = beside, light_position, light_clip_from_world, lookup_inset, light_distance, light_triangle
        total = added(total, scaled(tap_weight[tap], _is_seen(*at, bias)))
        whole = added(whole, list(tap_weight[tap]))
    return ([F(1) if w == 0 else minimum(maximum(t / w, F(0)), F(1)) for t, w in zip(total, whole, strict=True)],)


def _blended(shaded, bright, visible):
    return added(times(shaded, minus([F(1)] * 3, visible)), times(bright, visible))


def lit_multiply_soft(phong, light_visible, translucency):
    return (_blended(scaled(phong, translucency), phong, light_visible),)


def _soft(phong, albedo, light_visible, ambient, light_count):
    return _blended(scaled(albedo, ambient / light_count), phong, light_visible)


def lit_transmit_soft(
    phong,
    albedo,
    light_visible,
    translucency,
    incident_light,
    position_world,
    normal_world,
    light_position,
    translucency_scale,
    ambient,
    light_count,
):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    factor = (translucency * translucency_scale) * maximum(-facing, F(0))
    reflected = _soft(phong, albedo, light_visible, ambient, light_count)
    return (added(reflected, scaled(times(albedo, incident_light), factor)),)


def lit_transmit_wrapped_soft(
    phong,
    albedo,
    light_visible,
    translucency,
    incident_light,
    position_world,
    normal_world,
    light_position,
    translucency_scale,
    wrap,
    ambient,
    light_count,
):
    factor = (translucency * translucency_scale) * _wrapped(position_world, normal_world, light_position, wrap)
    reflected = _soft(phong, albedo, light_visible, ambient, light_count)
    return (added(reflected, scaled(times(albedo, incident_light), factor)),)


def irradiance_lambert_soft(position_world, normal_world, light_position, incident_light, light_visible):
    facing = maximum(dot(normal_world, normalize(minus(light_position, position_world))), F(0))
    return (scaled(times(incident_light, light_visible), facing),)


def gloss_soft(
    position_world,
    normal_world,
    light_position,
    camera_position,
    incident_light,
    light_visible,
    specular,
    shininess,
):
    shine = specular * _highlight(position_world, normal_world, light_position, camera_position, shininess)
    return (scaled(times(incident_light, light_visible), shine),)


# Light round a bend


def surface_curvature(triangle, position_world, triangle_curvature, sharpest_curvature, mm_per_unit):
    *gradient, constant = triangle_curvature[triangle]
    bent = (dot(gradient, position_world) + constant) / mm_per_unit
    return (minimum(maximum(bent, F(0)), sharpest_curvature),)


def directly_lit_round(
    position_world,
    normal_world,
    light_position,
    light_clip_from_world,
    light_texel_size,
    stored_distance,
    bias_abs,
    bias_slope,
):
    cosine = dot(normal_world, normalize(minus(light_position, position_world)))
    if cosine <= 0:
        return (True,)
    return directly_lit_slope(
        position_world,
        normal_world,
        light_position,
        light_clip_from_world,
        light_texel_size,
        stored_distance,
        bias_abs,
        bias_slope,
    )


def phong_preintegrated(
    position_world,
    normal_world,
    albedo,
    light_position,
    camera_position,
    incident_light,
    curvature,
    diffusion_table,
    sharpest_curvature,
    ambient,
    diffuse,
    specular,
    shininess,
    light_count,
):
    rows, columns = diffusion_table.shape[:2]
    cosine = dot(normal_world, normalize(minus(light_position, position_world)))
    across = minimum(maximum(cosine * F(0.5) + F(0.5), F(0)), F(1)) * F(columns - 1)
    around = bilinear(diffusion_table, *split([across, curvature / sharpest_curvature * F(rows - 1)]))
    shine = specular * _highlight(position_world, normal_world, light_position, camera_position, shininess)
    lit = [ambient / light_count + e * (r * diffuse) + e * shine for e, r in zip(incident_light, around, strict=True)]
    return (times(lit, albedo),)


# Blur


def _taps(pixel, tap_offset, tap_weight, tap_count, pixel_scale):
    """Per tap: lower left texel, fraction, weight of each channel. pixel_scale: of both axes, or of each."""
    across, up = np.broadcast_to(pixel_scale, 2)
    for k in range(tap_count):
        shift, t = split([tap_offset[k][0] * across, tap_offset[k][1] * up])
        yield [pixel[0] + shift[0], pixel[1] + shift[1]], t, list(tap_weight[k])


def _sum(terms):
    total = terms[0]
    for term in terms[1:]:
        total = added(total, term)
    return total


def scatter(lit, pixel, tap_offset, tap_weight, tap_count, pixel_scale):
    taps = _taps(pixel, tap_offset, tap_weight, tap_count, pixel_scale)
    return (_sum([times(bilinear(lit, corner, t), weight) for corner, t, weight in taps]),)


def single_tap(lit, pixel, offset, weight, pixel_scale):
    return scatter(lit, pixel, [offset], [weight], 1, pixel_scale)


def scatter_inside(lit, coverage, pixel, tap_offset, tap_weight, tap_count, pixel_scale):
    taps = list(_taps(pixel, tap_offset, tap_weight, tap_count, pixel_scale))
    inside = coverage.astype(np.float32)
    covered_lit = lit * inside[..., None]
    total = _sum([times(bilinear(covered_lit, corner, t), weight) for corner, t, weight in taps])
    kept = _sum([scaled(weight, bilinear(inside, corner, t)[0]) for corner, t, weight in taps])
    weights = _sum([weight for _, _, weight in taps])
    unblurred = lit[pixel[1], pixel[0]]
    return ([unblurred[k] if kept[k] == 0 else total[k] * (weights[k] / kept[k]) for k in range(3)],)


def _on_surface(coverage, position_world, pixel, ahead):
    """For every texel of the picture 1 where it shows the surface of the pixel, else 0."""
    here = position_world[pixel[1], pixel[0]]
    rows = [
        [F(bool(covered) and abs(dot(minus(at, here), ahead)) <= 1) for covered, at in zip(*row, strict=True)]
        for row in zip(coverage, position_world, strict=True)
    ]
    return np.array(rows, np.float32)


def scatter_on_surface(lit, coverage, position_world, pixel, tap_offset, tap_weight, tap_count, pixel_scale, ahead):
    there = _on_surface(coverage, position_world, pixel, ahead)
    seen, centre = lit * there[..., None], list(lit[pixel[1], pixel[0]])
    terms = []
    for corner, t, weight in _taps(pixel, tap_offset, tap_weight, tap_count, pixel_scale):
        away = F(1) - bilinear(there, corner, t)[0]
        terms.append(times(added(bilinear(seen, corner, t), scaled(centre, away)), weight))
    return (_sum(terms),)


def scatter_inside_surface(lit, coverage, position_world, pixel, tap_offset, tap_weight, tap_count, pixel_scale, ahead):
    there = _on_surface(coverage, position_world, pixel, ahead)
    return scatter_inside(lit, there, pixel, tap_offset, tap_weight, tap_count, pixel_scale)


def scatter_along(
    lit, coverage, position_world, pixel, kernel_offset, kernel_weight, kernel_count, pixels_per_offset, ahead
):
    here, centre = position_world[pixel[1], pixel[0]], list(lit[pixel[1], pixel[0]])
    near = np.zeros(coverage.shape, np.float32)
    for row, column in np.argwhere(coverage):
        near[row, column] = maximum(F(1) - abs(dot(minus(position_world[row, column], here), ahead)), F(0))
    seen, terms = lit * near[..., None], []
    for corner, t, weight in _taps(pixel, kernel_offset, kernel_weight, kernel_count, pixels_per_offset):
        away = F(1) - bilinear(near, corner, t)[0]
        terms.append(times(added(bilinear(seen, corner, t), scaled(centre, away)), weight))
    return (_sum(terms),)


def _normalized_diffusion(distance, d):
    third = correctly_rounded(gmpy2.exp, -distance / (F(3) * d))
    return (third * third * third + third) / (d * distance)


def scatter_burley(
    lit,
    coverage,
    position_world,
    pixel,
    sample_place,
    sample_radius,
    sample_area,
    sample_count,
    scatter_distance,
    reach_mm,
    pixels_per_offset,
    ahead,
):
    here, total, whole = position_world[pixel[1], pixel[0]], [F(-0.0)] * 3, [F(-0.0)] * 3
    for k in range(sample_count):
        column, row = (
            pixel[axis] + int(np.floor(sample_place[k][axis] * pixels_per_offset + F(0.5))) for axis in (0, 1)
        )
        depth = dot(minus(fetch(position_world, column, row), here), ahead) * reach_mm
        distance = np.sqrt(sample_radius[k] * sample_radius[k] + depth * depth)
        area = sample_area[k] * F(bool(fetch(coverage, column, row)[0]))
        weight = [_normalized_diffusion(distance, d) * area for d in scatter_distance]
        total = added(total, times(fetch(lit, column, row), weight))
        whole = added(whole, weight)
    own = lit[pixel[1], pixel[0]]
    return ([own[k] if whole[k] == 0 else total[k] / whole[k] for k in range(3)],)


# Composite


def over_background(scattered, coverage, background):
    return (scattered if coverage else background,)


def glow(scattered):
    return (scattered,)


# Irradiance in texture space


def irradiance_paper(position_world, normal_world, light_position, incident_light):
    distance = length(minus(position_world, light_position))
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    return (scaled(incident_light, distance * maximum(facing, F(0))),)


def irradiance_lambert(position_world, normal_world, light_position, incident_light, directly_lit, shadow_valid):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    in_shadow = shadow_valid and not directly_lit
    return (scaled(incident_light, F(0) if in_shadow else maximum(facing, F(0))),)


def irradiance_distance(position_world, light_position, incident_light):
    return (scaled(incident_light, length(minus(position_world, light_position))),)


def dilate(irradiance, irradiance_mask, pixel):
    """R8: itself, then left, right, below, above, then the corners, the lower ones first, each pair from the left."""
    column, row = pixel
    height, width = irradiance_mask.shape
    for x, y in [(0, 0), (-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)]:
        i, j = column + x, row + y
        if 0 <= i < width and 0 <= j < height and irradiance_mask[j, i]:
            return irradiance[j, i], True
    return irradiance[row, column], False


# The picture in texture space


def irradiance_lookup(uv, directly_lit, shadow_valid, shadow_uv, light_uv):
    return (nearest(light_uv, shadow_uv) if shadow_valid and not directly_lit else uv,)


def irradiance_lookup_throughout(uv, shadow_valid, shadow_uv, light_uv):
    return (nearest(light_uv, shadow_uv) if shadow_valid else uv,)


def _irradiance_at(scattered_irradiance, uv):
    on_map = [min(max(v, F(0)), F(1)) for v in uv]
    return bilinear(scattered_irradiance, *between_centres(scattered_irradiance, on_map))


def irradiance_replaced(uv, irradiance_uv, directly_lit, translucency, scattered_irradiance):
    if directly_lit:
        return (_irradiance_at(scattered_irradiance, uv),)
    return (scaled(_irradiance_at(scattered_irradiance, irradiance_uv), translucency),)


def irradiance_added(
    uv,
    irradiance_uv,
    translucency,
    translucency_scale,
    position_world,
    normal_world,
    light_position,
    scattered_irradiance,
):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    factor = (translucency * translucency_scale) * maximum(-facing, F(0))
    through = scaled(_irradiance_at(scattered_irradiance, irradiance_uv), factor)
    return (added(_irradiance_at(scattered_irradiance, uv), through),)


def irradiance_added_wrapped(
    uv,
    irradiance_uv,
    translucency,
    translucency_scale,
    wrap,
    position_world,
    normal_world,
    light_position,
    scattered_irradiance,
):
    factor = (translucency * translucency_scale) * _wrapped(position_world, normal_world, light_position, wrap)
    through = scaled(_irradiance_at(scattered_irradiance, irradiance_uv), factor)
    return (added(_irradiance_at(scattered_irradiance, uv), through),)


def gaussian_along(irradiance, irradiance_mask, pixel, spread_mm, spread_offset, spread_weight, texels_per_mm):
    inside = irradiance_mask.astype(np.float32)
    seen, terms = np.concatenate([irradiance * inside[..., None], inside[..., None]], axis=2), []
    for place, weight in zip(spread_offset, spread_weight, strict=True):
        shift, t = split(times(scaled(place, spread_mm), texels_per_mm))
        terms.append(scaled(bilinear(seen, [pixel[0] + shift[0], pixel[1] + shift[1]], t), weight))
    *total, whole = _sum(terms)
    return (fetch(irradiance, *pixel) if whole == 0 else [part / whole for part in total],)


def normal_at_light(fragment_normal):
    return (normalize(fragment_normal),)


def irradiance_of_gaussians(
    uv,
    irradiance_uv,
    shadow_uv,
    shadow_valid,
    light_normal,
    thickness,
    position_world,
    normal_world,
    light_position,
    mm_per_unit,
    profile_weight,
    profile_variance,
    **maps,
):
    away = -dot(normal_world, normalize(minus(light_position, position_world)))
    apart = thickness * mm_per_unit
    opposite = minimum(maximum(-dot(nearest(light_normal, shadow_uv), normal_world), F(0)), F(1))
    depth = mix([apart], [apart * maximum(away, F(0))], opposite)[0]
    terms = []
    for letter, weight, v in zip("abcdef", profile_weight, profile_variance, strict=True):
        near = minimum(apart / (F(6) * np.sqrt(v)), F(1))
        comes = correctly_rounded(gmpy2.exp, -(depth * depth) / (F(2) * v)) * near
        comes = F(bool(shadow_valid) and away > 0) * comes
        own, entered = (_irradiance_at(maps[f"spread_{letter}"], at) for at in (uv, irradiance_uv))
        terms.append(times(added(own, scaled(entered, comes)), list(weight)))
    a, b, c, d, e, f = terms
    return (added(added(added(a, b), c), added(added(d, e), f)),)


def image_sqrt(irradiance_used, phong):
    return ([np.sqrt(maximum(v, F(0))) for v in times(irradiance_used, phong)],)


def gloss_where_lit(
    position_world,
    normal_world,
    light_position,
    camera_position,
    incident_light,
    directly_lit,
    specular,
    shininess,
):
    s = _highlight(position_world, normal_world, light_position, camera_position, shininess)
    return (scaled(incident_light, specular * s) if directly_lit else [F(0)] * 3,)


def image_product(irradiance_used, gloss, ambient, albedo):
    return (times([(ambient + i) + g for i, g in zip(irradiance_used, gloss, strict=True)], albedo),)


# Several lights


def plus(first, second):
    return (added(first, second),)
