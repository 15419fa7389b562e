"""Mistakes that ports of the methods have, each with a scene that shows it and the words that name it.

`PLANTED` is the fault table: benchmarks/causes.py tries all of it, the tests a part of it.
"""

import re
from dataclasses import dataclass, replace

import numpy as np
from devices import farthest, only, shifted
from ports import Mistake, Port

from sss_ref.language import (
    dot,
    ivec2,
    length,
    max,
    normalize,
    pow,
    select,
    size,
    texel,
    vec2,
    vec3,
)
from sss_ref.language.pipeline import ScreenDraw
from sss_ref.language.types import Texture
from sss_ref.passes import phong, shadow_map
from sss_ref.passes.blur import renormalized, scatter, tap_coverage, tap_inside
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

NUMBERS = ("triangle", "light_triangle", "light_triangle_1", "light_triangle_2")
BUST = {
    "camera.azimuth": 130.0,
    "lights.0.color": [1.0, 0.8, 0.6],
    "lights.0.intensity": 1.25,
    "mesh.rotate_degrees": [0.0, 20.0, 0.0],
    "mesh.scale": [1.0, 1.1, 0.9],
    "blur.unit": "pixel",
    "shadow_map.test": "slope",
}
HARD = {"shadow_map.test": "slope"}
SCENES = {
    "bust": ("figure3_with", BUST),
    "outline": ("figure3_with", BUST | {"preset": "paper"}),
    "close": ("figure3_with", BUST | {"preset": "paper", "camera.distance": 2.4}),
    "two lights": (
        "figure3_with",
        HARD | {"lights": [{"position": [2.4, 1.5, 1.5]}, {"position": [-2.0, 2.0, 1.5], "color": [0.5, 0.7, 1.0]}]},
    ),
    "texture space": ("figure5", HARD),
    "wax": ("wax", HARD),
}


@dataclass(frozen=True)
class Planted:
    """A mistake. says: a pattern of the words that name it. lacks: buffers that are not dumped."""

    name: str
    mistake: Mistake
    says: str
    scene: str = "bust"
    lacks: tuple[str, ...] = ()

    def is_named_by(self, text):
        return re.search(self.says, text) is not None

    def drawn(self, scene):
        """What the port dumps."""
        return {
            name: each for name, each in Port(scene, self.mistake).buffers_of_all().items() if name not in self.lacks
        }


def scene_of(name, side=64, changes=()):
    """One of SCENES, so many pixels wide and high, with other keys changed as well."""
    shipped, given = SCENES[name]
    overrides = given(side) if callable(given) else given
    sizes = {
        f"{table}.{axis}": side for table in ("camera", "shadow_map", "irradiance_map") for axis in ("width", "height")
    }
    return load_scene(shipped, **(sizes | overrides | dict(changes)))


def oracle_of(scene):
    return render(scene, "arrays", threads=1)


def scaled(factor):
    return lambda value: value * np.float64(factor)


def instead(value):
    return lambda _: value


def transposed(matrix):
    return matrix.T


def zoomed(degrees_factor):
    """A projection whose field of view is so many times as large, for small angles."""
    return lambda matrix: np.diag([1 / degrees_factor, 1 / degrees_factor, 1, 1]) @ matrix.astype(np.float64)


def moved_in_clip_space(x, y):
    """Moved by x and y in device coordinates, as a jitter is added to a projection."""
    return lambda matrix: np.array([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, 0], [0, 0, 0, 1.0]]) @ matrix


def half_depth(matrix):
    """Clip space from 0 to w, as Direct3D and Vulkan have it."""
    return np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0.5, 0.5], [0, 0, 0, 1.0]]) @ matrix


def turned(degrees):
    """A camera that stood elsewhere: turned about the vertical through the origin."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return lambda matrix: matrix @ np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1.0]])


def as_the_model(normal_from_model):
    """The model matrix for the normals: the inverse transpose of its inverse transpose."""
    return np.linalg.inv(normal_from_model.astype(np.float64)).T


def smaller_viewport(factor):
    """Draws into the lower left part of the target, as a viewport of another pass does."""

    def changed(primitives, placed, viewport):
        half = viewport.step // 2
        snapped = np.rint((primitives.snapped + half) * factor - half).astype(np.int32)
        return primitives._replace(snapped=np.ascontiguousarray(snapped))

    return changed


def stored_as(dtype):
    return lambda buffer: buffer.astype(dtype).astype(np.float32)


def srgb8(buffer):
    v = np.clip(buffer.astype(np.float64), 0, 1)
    encoded = np.rint(np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055) * 255) / 255
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


def packed_floats(buffer):
    """R11G11B10F, rounded to nearest."""

    def of_bits(values, bits):
        _, exponent = np.frexp(values)
        step = np.ldexp(1.0, np.maximum(exponent - 1, -14) - bits)
        return np.rint(values / step) * step

    v = np.clip(buffer.astype(np.float64), 0, None)
    return np.stack([of_bits(v[..., 0], 6), of_bits(v[..., 1], 6), of_bits(v[..., 2], 5)], axis=-1)


def rgb10(buffer):
    return np.rint(np.clip(buffer, 0, 1).astype(np.float64) * 1023) / 1023


def shared_exponent(buffer):
    v = np.clip(buffer.astype(np.float64), 0, 65408)
    _, exponent = np.frexp(v.max(axis=-1, keepdims=True))
    step = np.ldexp(1.0, np.maximum(exponent, -15) - 9)
    step = np.where(np.rint(v.max(axis=-1, keepdims=True) / step) == 512, 2 * step, step)
    return np.rint(v / step) * step


def cleared_to(value):
    """Cleared to another number than the largest, which is what stands where nothing is drawn."""
    return lambda buffer: np.where(buffer == buffer.max(), np.float32(value), buffer)


def back_point_as_difference(position_world, light_position, stored_distance, shadow_valid):
    right = shadow_map.back_point(position_world, light_position, stored_distance, shadow_valid)
    return right._replace(thickness=length(position_world - light_position) - stored_distance)


def phong_with(lambert=None, mirror=None, tint=True, eye=None):
    """Phong's model with one of its parts done otherwise."""

    def wrong(
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
        to_light = normalize(light_position - position_world)
        to_eye = normalize(eye(camera_position, position_world) if eye else camera_position - position_world)
        cosine = dot(normal_world, to_light)
        own = lambert(cosine) if lambert else max(cosine, np.float32(0))
        shine = specular * (mirror or phong.highlight)(normal_world, to_light, to_eye, shininess)
        lit = ambient / light_count + incident_light * (diffuse * own)
        return phong.Phong((lit + (incident_light * shine if tint else vec3(shine, shine, shine))) * albedo)

    return wrong


def blinn(normal, to_light, to_eye, shininess):
    half = normalize(to_light + to_eye)
    return select(dot(normal, to_light) > 0, pow(max(dot(normal, half), np.float32(0)), shininess), np.float32(0))


def scatter_inside_with(sample=tap_inside, taps=lambda count: count, finish=lambda v: v):
    def wrong(lit, coverage, pixel, tap_offset, tap_weight, tap_count, pixel_scale):
        zero = np.float32(0)
        total, kept, every = (vec3(zero, zero, zero) for _ in range(3))
        for tap in range(taps(tap_count)):
            offset, weight = tap_offset[tap] * pixel_scale, tap_weight[tap]
            total = total + sample(lit, coverage, pixel, offset) * weight
            kept = kept + weight * tap_coverage(coverage, pixel, offset)
            every = every + weight
        return (finish(renormalized(total, kept, every, texel(lit, pixel))),)

    return wrong


def decoded(v):
    return type(v)(*((np.maximum(part, 0) ** 2.2).astype(np.float32) for part in (v.x, v.y, v.z)))


def in_gamma_space(lit, coverage, pixel, tap_offset, tap_weight, tap_count, pixel_scale):
    bright = Texture((np.maximum(lit.data, 0).astype(np.float64) ** (1 / 2.2)).astype(np.float32))
    return scatter_inside_with(finish=decoded)(bright, coverage, pixel, tap_offset, tap_weight, tap_count, pixel_scale)


def scatter_with(wrap):
    """The blur of the preset `paper` with the texture repeated."""

    def wrong(lit, pixel, tap_offset, tap_weight, tap_count, pixel_scale):
        pad = 16
        wide = Texture(np.pad(lit.data, ((pad, pad), (pad, pad), (0, 0)), mode=wrap))
        at = ivec2(pixel.x + np.int32(pad), pixel.y + np.int32(pad))
        return scatter.python(wide, at, tap_offset, tap_weight, tap_count, pixel_scale)

    return wrong


def looked_up(change):
    """A shadow lookup that reads beside the place it should."""

    def wrong(position_world, light_position, light_clip_from_world, lookup_inset, light_distance, light_triangle):
        right = shadow_map.shadow_lookup_nearest.python
        uv, valid, _ = right(
            position_world, light_position, light_clip_from_world, lookup_inset, light_distance, light_triangle
        )
        there = change(uv, size(light_distance))
        stored = texel(light_distance, shadow_map.nearest_texel(size(light_distance), there))
        return shadow_map.ShadowLookup(uv, valid, select(valid, stored, length(position_world - light_position)))

    return wrong


def depth_along_axis(fragment_position, light_position):
    away = fragment_position - light_position
    axis = normalize(vec3(*(np.float32(-part) for part in (light_position.x, light_position.y, light_position.z))))
    return (dot(away, axis),)


def literal_test(
    position_world,
    normal_world,
    light_position,
    light_clip_from_world,
    light_texel_size,
    stored_distance,
    bias_abs,
    bias_slope,
):
    return (length(position_world - light_position) - stored_distance <= bias_abs,)


def camera_pass_stages(**functions):
    return Mistake("camera", stages=functions)


def vertex(name, change, where="camera"):
    return Mistake(where, uniforms={name: change})


CAMERA, LIGHT = "camera_clip_from_model", "light_clip_from_model"
JITTER = moved_in_clip_space(0.62 / 48, -0.34 / 48)  # of 48 pixels 0.31 and 0.17
JITTERED = "pixels too far right and .* pixels too far down.* left in"
IDENTITY = np.eye(4)

PLANTED = [
    Planted("camera matrix transposed", vertex(CAMERA, transposed), f"{CAMERA} is transposed"),
    Planted(
        "light matrix of the lookup transposed",
        vertex("light_clip_from_world", transposed),
        "light_clip_from_world is transposed",
    ),
    Planted("light matrix of the draw transposed", vertex(LIGHT, transposed, "shadow_map"), f"{LIGHT} is transposed"),
    Planted(
        "light 1's map for light 2",
        Mistake("camera", reads={"light_distance_2": "light_distance_1", "light_triangle_2": "light_triangle_1"}),
        "light_distance_1",
        "two lights",
    ),
    Planted(
        "light 1's matrix for light 2",
        Mistake("camera", uniforms={"light_clip_from_world_2": "light_clip_from_world_1"}),
        "light_clip_from_world_1",
        "two lights",
    ),
    Planted(
        "light 1's position for light 2",
        Mistake("camera", uniforms={"light_position_2": "light_position_1"}),
        "light_position_1",
        "two lights",
    ),
    Planted(
        "light 1's view for light 2's map",
        Mistake("shadow_map_2", uniforms={"light_clip_from_model_2": "light_clip_from_model_1"}),
        "light_clip_from_model_1",
        "two lights",
        NUMBERS,
    ),
    Planted("model matrix left out", vertex("world_from_model", instead(IDENTITY)), "world_from_model is the identity"),
    Planted(
        "model matrix left out of the map",
        vertex("world_from_model", instead(IDENTITY), "shadow_map"),
        "world_from_model is the identity",
        lacks=NUMBERS,
    ),
    Planted(
        "normals turned by the model matrix",
        vertex("normal_from_model", as_the_model),
        "normal_from_model is .*world_from_model",
        lacks=NUMBERS,
    ),
    Planted("normals not turned", vertex("normal_from_model", instead(np.eye(3))), "normal_from_model is the identity"),
    Planted("camera of the frame before", vertex(CAMERA, turned(0.5)), f"{CAMERA} .*turned|turned by 0\\.5"),
    Planted("camera's field of view 1 % off", vertex(CAMERA, zoomed(1.01)), "field of view"),
    Planted("light's field of view 1 % off", vertex(LIGHT, zoomed(1.01), "shadow_map"), "field of view", lacks=NUMBERS),
    Planted(
        "light position x 1.0005",
        vertex("light_position", scaled(1.0005), "shadow_map"),
        "light_position is .*1\\.0005",
    ),
    Planted("light position x 1.0005 in Phong's model", vertex("light_position", scaled(1.0005)), "light_position is"),
    Planted("camera one pixel off", Mistake("camera", pieces=shifted(1, 0)), "(1|one) pixel.* right", lacks=NUMBERS),
    Planted("map one pixel off", Mistake("shadow_map", pieces=shifted(0, 1)), "(1|one) pixel.* up", lacks=NUMBERS),
    Planted(
        "map in a viewport half as large",
        Mistake("shadow_map", pieces=smaller_viewport(0.5)),
        "viewport",
        lacks=NUMBERS,
    ),
    Planted("jitter left in", vertex(CAMERA, JITTER), f"{JITTERED} {CAMERA}", lacks=NUMBERS),
    Planted("jitter left in, with numbers", vertex(CAMERA, JITTER), f"{JITTERED} {CAMERA}"),
    Planted("jitter left in the map", vertex(LIGHT, JITTER, "shadow_map"), f"{JITTERED} {LIGHT}", lacks=NUMBERS),
    Planted("jitter left in the map, with numbers", vertex(LIGHT, JITTER, "shadow_map"), f"{JITTERED} {LIGHT}"),
    Planted("light's field of view 1.3 % off", vertex(LIGHT, zoomed(1.013), "shadow_map"), r"tan\(fov_y/2\) is 1\.013"),
    Planted(
        "map's depth of the other convention", vertex(LIGHT, half_depth, "shadow_map"), "0 to 1|0 to w", lacks=NUMBERS
    ),
    Planted("depth of the other convention", vertex(CAMERA, half_depth), "0 to 1|0 to w"),
    Planted(
        "front faces culled in the map",
        Mistake("shadow_map", pieces=only(lambda turn: turn < 0)),
        "front faces.* culled",
        lacks=NUMBERS,
    ),
    Planted("the wrong faces culled", Mistake("camera", pieces=only(lambda turn: turn < 0)), "front faces.* culled"),
    Planted(
        "depth test the wrong way round", Mistake("shadow_map", pieces=farthest), "keeps the farthest", lacks=NUMBERS
    ),
    Planted("REPEAT for CLAMP", Mistake("blur", stages={"scatter": scatter_with("wrap")}), "repeat", "close"),
    Planted(
        "bilinear for nearest",
        Mistake("camera", stages={"shadow_lookup_nearest": shadow_map.shadow_lookup_bilinear.python}),
        "shadow_lookup_bilinear",
    ),
    Planted(
        "half a texel beside the map's",
        camera_pass_stages(
            shadow_lookup_nearest=looked_up(
                lambda uv, texels: vec2(uv.x + np.float32(0.5 / texels.x), uv.y + np.float32(0.5 / texels.y))
            )
        ),
        "half a texel",
    ),
    Planted(
        "the map read upside down",
        camera_pass_stages(shadow_lookup_nearest=looked_up(lambda uv, s: vec2(uv.x, 1 - uv.y))),
        "upside down|from the top",
    ),
    Planted(
        "12 of 13 taps",
        Mistake("blur", stages={"scatter_inside": scatter_inside_with(taps=lambda count: count - 1)}),
        "12 of (the )?13 taps|last tap",
    ),
    Planted("blur in gamma space", Mistake("blur", stages={"scatter_inside": in_gamma_space}), "gamma"),
    Planted(
        "kernel's x and y swapped",
        Mistake("blur", uniforms={"tap_offset": lambda taps: taps[:, ::-1]}),
        "x and y of the taps are swapped",
    ),
    Planted(
        "the paper's kernel", Mistake("blur", uniforms={"pixel_scale": scaled(0.5)}), "pixel_scale is 1 instead of 2"
    ),
    Planted(
        "blur outside the stencil",
        Mistake("blur", draws=lambda one: replace(one, draw=ScreenDraw())),
        "stencil|where nothing is drawn",
        "outline",
    ),
    Planted(
        "highlight not tinted",
        camera_pass_stages(phong_shading=phong_with(tint=False)),
        "highlight.* not tinted|without the light's colour",
    ),
    Planted(
        "V = normalize(eye)",
        camera_pass_stages(phong_shading=phong_with(eye=lambda eye, p: eye)),
        "normalize\\(camera_position\\)",
    ),
    Planted("Blinn for Phong", camera_pass_stages(phong_shading=phong_with(mirror=blinn)), "Blinn"),
    Planted("d = D - t", camera_pass_stages(back_point=back_point_as_difference), "D - t"),
    Planted(
        "N.L wrapped",
        camera_pass_stages(phong_shading=phong_with(lambert=lambda c: c * np.float32(0.5) + np.float32(0.5))),
        "wrap",
    ),
    Planted(
        "half Lambert",
        camera_pass_stages(phong_shading=phong_with(lambert=lambda c: (c * np.float32(0.5) + np.float32(0.5)) ** 2)),
        "[Hh]alf Lambert",
    ),
    Planted(
        "e^(-d^2/(2*v))",
        Mistake("camera", uniforms={"gaussian_variance": scaled(2)}),
        r"Gaussians are e\^\(-d\^2/\(2\*v\)\)",
        "wax",
    ),
    Planted(
        "Gaussians in scene units",
        Mistake("camera", uniforms={"mm_per_unit": instead(1)}),
        "mm_per_unit is 1 instead of 24|`depth = thickness` for",
        "wax",
    ),
    Planted("exponent .751", vertex("exponent", instead(0.751)), "exponent is 0.751"),
    Planted("no slope in the bias", camera_pass_stages(directly_lit_slope=literal_test), "bias|directly_lit_literal"),
    Planted(
        "depth for the distance", Mistake("shadow_map", stages={"distance_to_light": depth_along_axis}), "depth along"
    ),
    Planted(
        "map cleared to 0",
        Mistake("shadow_map", writes={"light_distance": cleared_to(0)}),
        "cleared to 0|where nothing is drawn",
    ),
    Planted(
        "irradiance map not dilated",
        Mistake("irradiance_fill", draws=lambda one: replace(one, rounds=0)),
        "used as drawn, without dilation",
        "texture space",
    ),
    Planted(
        "one round of dilation",
        Mistake("irradiance_fill", draws=lambda one: replace(one, rounds=1)),
        "irradiance_fill runs 1 round instead of 8",
        "texture space",
    ),
    Planted(
        "the map before its dilation is blurred",
        Mistake(
            "irradiance_blur", reads={"irradiance_filled": "irradiance", "irradiance_filled_mask": "irradiance_mask"}
        ),
        "used as drawn, without dilation",
        "texture space",
    ),
    Planted("halves", Mistake("camera", writes={"lit": stored_as(np.float16)}), "half|float16"),
    Planted("sRGB8", Mistake("camera", writes={"lit": srgb8}), "srgb8|sRGB8"),
    Planted("R11G11B10F", Mistake("camera", writes={"lit": packed_floats}), "R11G11B10F"),
    Planted("RGB10A2", Mistake("camera", writes={"lit": rgb10}), "RGB10A2"),
    Planted("RGB9E5", Mistake("camera", writes={"lit": shared_exponent}), "RGB9E5"),
]
