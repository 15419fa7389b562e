"""The whole screen-space method on one page of plain NumPy: shadow map, camera, blur, composite (paper 2.1, 3.2).

Every buffer has the bits that `sss_ref.render` gives. Of the package the page takes what reads a scene, what writes a
picture, and a correctly rounded pow. It draws what the presets `paper` and `robust` ask for, with one light, one
colour, hard shadows and the kernel in pixels. Nothing is cut at the border of a view. Triangles are a loop, pixels are
arrays (H, W) or (H, W, C), fragments (N,) or (N, C); all are float32, row 0 at the bottom, lengths in scene units.

    python one_page.py figure3_with 256         # a shipped scene, and the pixels a side of picture and shadow map
"""

import sys
from pathlib import Path

import numpy as np

import sss_ref
from sss_ref.numerics.elementary import pow_array as pow
from sss_ref.pictures.png_file import write_png
from sss_ref.view.matrices import normal_matrix

SUBPIXEL = 256  # window positions are snapped to this part of a pixel
NO_SURFACE = -1
DRAWN = ("constant", "nearest", "slope", "ratio", "pixel")  # colour, shadow map's filter and test, form of T, unit
HARD = {"shadow_map.test": "slope", "blur.unit": "pixel"}  # preset robust has soft shadows, and the kernel in mm
LARGEST_HALF = 65504.0  # bounds T, so that a buffer of half floats can hold it

# The words of a shader, in float32: each operation rounds once, sums go from left to right.


def dot(a, b):
    return (a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1]) + a[..., 2] * b[..., 2]


def length(v):
    return np.sqrt(dot(v, v))


def normalize(v):
    size = length(v)[..., None]
    return np.divide(v, size, out=np.zeros_like(v), where=size != 0)


def reflect(incident, normal):
    return incident - normal * (2 * dot(normal, incident))[..., None]


def at_least(floor, value):
    return np.where(value < floor, np.float32(floor), value)  # max(value, floor) in GLSL: of two zeros it keeps value


def transform(matrix, v):
    """Matrix * column vector; of a 4 x 4 matrix a position with w = 1."""
    x, y, z, *translation = matrix.astype(np.float32).T
    total = (x * v[:, 0:1] + y * v[:, 1:2]) + z * v[:, 2:3]
    return total + translation[0] if translation else total


def texel(picture, column, row):
    """The texel, or the nearest one on the edge."""
    height, width = picture.shape[:2]
    return picture[np.clip(row, 0, height - 1), np.clip(column, 0, width - 1)]


def moved(picture, offset):
    """What each pixel finds at an offset (x, y) in pixels: four texels, mixed along x first, then along y."""
    row, column = np.indices(picture.shape[:2])
    column, row = column + int(np.floor(offset[0])), row + int(np.floor(offset[1]))
    right, up = offset - np.floor(offset)
    lower = texel(picture, column, row) * (1 - right) + texel(picture, column + 1, row) * right
    upper = texel(picture, column, row + 1) * (1 - right) + texel(picture, column + 1, row + 1) * right
    return lower * (1 - up) + upper * up


# The rasterizer: coverage in exact integers, depth in float64, attributes in float32.


def fragments_of(corners, width, height):
    """Rows and columns of the pixels that a triangle covers, and there its three edge functions, exact, >= 0.

    corners: int64 (3, 2), in 1/SUBPIXEL pixel from the centre of pixel (0, 0).
    """
    first = np.maximum(-(-corners.min(axis=0) // SUBPIXEL), 0)
    last = np.minimum(corners.max(axis=0) // SUBPIXEL, (width - 1, height - 1))
    column, row = np.meshgrid(np.arange(first[0], last[0] + 1), np.arange(first[1], last[1] + 1))
    (ax, ay), (bx, by), (cx, cy) = corners
    turn = np.sign((bx - ax) * (cy - ay) - (cx - ax) * (by - ay))  # 0 for a triangle without an area
    covered, edges = np.full(column.shape, turn != 0), []
    for (px, py), (qx, qy) in (((bx, by), (cx, cy)), ((cx, cy), (ax, ay)), ((ax, ay), (bx, by))):
        dx, dy = turn * (qx - px), turn * (qy - py)
        edge = dx * (row * SUBPIXEL - py) - dy * (column * SUBPIXEL - px)
        owns_samples = dy < 0 or (dy == 0 and dx > 0)  # a left edge, or a horizontal one at the minimum row
        covered &= edge >= (0 if owns_samples else 1)
        edges.append(edge)
    return row[covered], column[covered], np.stack(edges)[:, covered]


def draw(clip, triangles, varyings, view):
    """The visible triangle and the window depth of each pixel, and the varyings (V, C) at the N that are covered."""
    (x, y, z, w), width, height = clip.T, view.width, view.height
    if not (np.abs([x, y, z]) <= w).all():
        raise ValueError("mesh: expected all of it within the view, got a vertex outside; move the eye back")
    inverse_w = 1 / w
    window = [(v * inverse_w) * (size / 2) + (size / 2) for v, size in ((x, width), (y, height))]
    snapped = np.rint((np.stack(window, axis=1) - 0.5) * SUBPIXEL).astype(np.int64)
    window_depth = (0.5 * (z * inverse_w) + 0.5).astype(np.float64)

    triangle, depth = np.full((height, width), NO_SURFACE, np.int32), np.ones((height, width), np.float32)
    edge = np.zeros((height, width, 3), np.int64)
    for number, corners in enumerate(triangles):
        row, column, (e0, e1, e2) = fragments_of(snapped[corners], width, height)
        z0, z1, z2 = window_depth[corners]
        here = np.clip(((z0 * e0 + z1 * e1) + z2 * e2) / (e0 + e1 + e2), 0, 1).astype(np.float32)
        nearer = here < depth[row, column]
        row, column = row[nearer], column[nearer]
        triangle[row, column], depth[row, column] = number, here[nearer]
        edge[row, column] = np.stack([e0, e1, e2], axis=1)[nearer]

    corners = triangles[triangle[triangle != NO_SURFACE]].T
    w0, w1, w2 = (edge[triangle != NO_SURFACE].T.astype(np.float32) * inverse_w[corners])[..., None]
    a0, a1, a2 = varyings[corners]
    return triangle, depth, ((a0 * w0 + a1 * w1) + a2 * w2) / ((w0 + w1) + w2)


def filled(covered, fragments, background=0):
    """A picture of fragments, and of the background where there are none."""
    picture = np.empty(covered.shape + fragments.shape[1:], fragments.dtype)
    picture[...] = background
    picture[covered] = fragments
    return picture


# The method. A Python number is rounded to float32 where it meets an array.


def render(scene):
    """Name -> buffer, as `sss_ref.render` has them."""
    settings, light, camera = scene.settings, scene.lights[0], scene.camera
    light_map, form = settings.shadow_map, settings.translucency.form
    asked = (settings.mesh.albedo, light_map.filter, light_map.test, form, settings.blur.unit)
    if asked != DRAWN or len(scene.lights) > 1 or light.falloff != "none" or settings.blur.mask == "none":
        raise ValueError(f"scene: expected what this page draws, got {scene.source}; take figure3_with or teaching")
    light_position, camera_position = light.position.astype(np.float32), camera.eye.astype(np.float32)
    light_clip_from_world = light.view.clip_from(np.eye(4))

    # Vertex shader: world coordinates pass from the vertices to the fragments.
    position, normal, uv = (scene.mesh.attributes[name] for name in ("position", "normal", "uv"))
    position_world = transform(scene.world_from_model, position)[:, :3]
    normal_world = transform(normal_matrix(scene.world_from_model), normal)
    varyings = np.concatenate([position_world, normal_world, uv], axis=1)

    # Shadow map: how far from the light the nearest surface lies; a distance, not a depth.
    clip = transform(light.view.clip_from(scene.world_from_model), position)
    light_triangle, light_depth, surface = draw(clip, scene.mesh.triangles, varyings, light.view)
    nearest = length(surface[:, :3] - light_position)
    light_distance = filled(light_triangle != NO_SURFACE, nearest, 2 * light.view.far)

    # Camera: the fragments, one for each pixel that shows the model.
    clip = transform(camera.clip_from(scene.world_from_model), position)
    triangle, depth, surface = draw(clip, scene.mesh.triangles, varyings, camera)
    coverage = triangle != NO_SURFACE
    position_world, normal_world, uv = surface[:, :3], normalize(surface[:, 3:6]), surface[:, 6:]
    albedo = np.full_like(position_world, settings.mesh.color)
    to_light, to_eye = normalize(light_position - position_world), normalize(camera_position - position_world)
    facing = dot(normal_world, to_light)

    # Shadow lookup: where the light's ray to a point meets the body for the first time.
    def looked_up(position_world):
        clip = transform(light_clip_from_world, position_world)
        shadow_uv = ((clip[:, :2] / clip[:, 3:]) * settings.shadow_map.lookup_inset + 1) * 0.5
        on_map = (clip[:, 3:] > 0) & (shadow_uv >= 0) & (shadow_uv <= 1)
        shadow_uv = np.where(on_map.all(axis=1)[:, None], shadow_uv, np.float32(-1))
        column, row = np.floor(shadow_uv * np.float32(light_triangle.shape[::-1])).astype(int).T
        shadow_valid = (shadow_uv[:, 0] >= 0) & (texel(light_triangle, column, row) != NO_SURFACE)
        distance = length(position_world - light_position)
        stored_distance = np.where(shadow_valid, texel(light_distance, column, row), distance)
        return shadow_uv, shadow_valid, stored_distance

    shadow_uv, shadow_valid, stored_distance = looked_up(position_world)
    distance = length(position_world - light_position)
    texel_width = at_least(0, transform(light_clip_from_world, position_world)[:, 3]) * light.view.pixel_size

    # Thickness: go from the light towards the fragment by the stored distance; the rest lies inside the body. Preset
    # robust asks for the thickness of a point below the surface.
    wraps = settings.translucency.combine == "transmit_wrapped"
    inside_point = position_world - normal_world * (settings.shadow_map.lookup_depth * texel_width)[:, None]
    point = inside_point if wraps else position_world
    point_uv, point_valid, point_distance = looked_up(point)
    entry_point = light_position + normalize(point - light_position) * point_distance[:, None]
    entry_point = np.where(point_valid[:, None], entry_point, point)
    thickness = length(point - entry_point)

    # Directly lit: no further behind the stored point than a texel of the map explains, the surface being tilted.
    cosine = np.clip(np.abs(facing), 0.05, 1)
    slope = texel_width * (1 + np.sqrt(1 - cosine * cosine) / cosine)
    bias = settings.shadow_map.bias_abs + settings.shadow_map.bias_slope * slope
    directly_lit = (facing > 0) & (distance - stored_distance <= bias)

    # Phong: the reflected light, as if there were no shadow and nothing below the surface.
    phong, light_color = settings.phong, light.color.astype(np.float32) * np.float32(light.intensity)
    mirrored = dot(to_eye, reflect(-to_light, normal_world))
    visible = (facing > 0) & (mirrored > 0)
    highlight = np.where(visible, pow(np.where(visible, mirrored, 1), np.float32(phong.shininess)), 0)
    lambert, mirror = phong.diffuse * at_least(0, facing), phong.specular * highlight
    incident_light = np.tile(light_color, (len(facing), 1))
    reflected = (phong.ambient + light_color * lambert[:, None]) + light_color * mirror[:, None]
    phong_color = reflected * albedo

    # Translucency: T = x^y / d^0.6 of the light comes through where the body stands in its way.
    skin = settings.translucency
    x, y, exponent = np.float32([skin.x, skin.y, skin.exponent])
    term = np.minimum(pow(x, y) / pow(at_least(skin.d_min, thickness), exponent), LARGEST_HALF)
    if wraps:  # preset robust: the light that enters from behind is added, and goes round the terminator
        translucency = np.where(point_uv[:, 0] < 0, np.float32(0), term)
        reflected = np.where(directly_lit[:, None], phong_color, phong.ambient * albedo)
        wrap = np.float32(skin.wrap)
        from_behind = (translucency * skin.scale) * (at_least(0, wrap - facing) / (1 + wrap))
        lit = reflected + (albedo * light_color) * from_behind[:, None]
    else:  # preset paper, its two cases
        translucency = np.where(directly_lit | (shadow_uv[:, 0] < 0), np.float32(1), term)
        lit = np.where(directly_lit[:, None], phong_color, phong_color * translucency[:, None])

    # Blur: light that scatters below the surface leaves beside where it entered. A tap beside the model counts in
    # preset paper as black; preset robust gives its weight to the others.
    lit, covered = filled(coverage, lit), coverage[..., None]
    total = kept = weights = np.float32(-0.0)  # -0 + x is x, whatever its sign
    for tap in np.array(settings.blur.taps, np.float32):
        offset, weight = tap[:2] * settings.blur.pixel_scale, tap[2:]
        total = total + moved(lit, offset) * weight
        kept, weights = kept + weight * moved(covered.astype(np.float32), offset), weights + weight
    if settings.blur.mask == "taps":
        total = np.where(kept == 0, lit, total * (weights / np.where(kept == 0, 1, kept)))
    scattered = np.where(covered, total, np.float32(0))

    # Composite: the model before its background.
    image = np.where(covered, scattered, np.float32(settings.output.background))

    fragments = {
        "position_world": position_world, "normal_world": normal_world, "uv": uv, "albedo": albedo,
        "shadow_valid": shadow_valid.astype(np.uint8), "stored_distance": stored_distance, "entry_point": entry_point,
        "thickness": thickness, "directly_lit": directly_lit.astype(np.uint8), "incident_light": incident_light,
        "phong": phong_color, "translucency": translucency,
    }  # fmt: skip
    below = {
        "inside_point": inside_point, "inside_shadow_uv": point_uv, "inside_shadow_valid": point_valid.astype(np.uint8),
        "inside_stored_distance": point_distance,
    }  # fmt: skip
    background = dict.fromkeys(("shadow_uv", "inside_shadow_uv"), -1)
    fragments |= {"shadow_uv": shadow_uv} | (below if wraps else {})
    return {name: filled(coverage, values, background.get(name, 0)) for name, values in fragments.items()} | {
        "light_triangle": light_triangle, "light_depth": light_depth, "light_distance": light_distance,
        "triangle": triangle, "depth": depth, "coverage": coverage.astype(np.uint8),
        "lit": lit, "scattered": scattered, "image": image,
    }  # fmt: skip


if __name__ == "__main__":
    name, size = [*sys.argv[1:], *("figure3_with", "256")[len(sys.argv) - 1 :]]
    sizes = dict.fromkeys(("camera.width", "camera.height", "shadow_map.width", "shadow_map.height"), int(size))
    buffers = render(sss_ref.load_scene(name, **sizes, **HARD))
    write_png(Path("one_page.png"), buffers["image"], buffers["coverage"])
    print("one_page.png")
