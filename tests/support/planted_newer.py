"""Mistakes in the newer stages, in vertex stages, and where little was dumped; `NEWER` continues `PLANTED`."""

from dataclasses import replace

import numpy as np
from planted import CAMERA, LIGHT, NUMBERS, SCENES, Planted, blinn, instead, phong_with, scaled, vertex
from ports import Count, Mistake, mistaken

from sss_ref.language import dot, max, normalize, select, vec3, vec4
from sss_ref.passes import lengths, seen_through, shadow_map, soft_shadow, transmittance
from sss_ref.passes.blur import scatter_inside
from sss_ref.view.lenses import Perspective

F = np.float32
BUST = SCENES["bust"][1] | {"blur.unit": "mm"}
SCENES |= {
    "soft": ("figure3_with", BUST | {"shadow_map.test": "kernel"}),
    "in mm": ("figure3_with", BUST),
    "moved": ("figure3_with", BUST | {"mesh.translate": [0.2, 0.1, -0.1]}),
    "wide": ("figure3_with", lambda side: BUST | {"camera.height": side // 2}),
    "layers": ("teeth_layers", {"mm_per_unit": 1.25}),
}
LIT_ALONE = ("lit", "scattered", "image")


def stages_of(where="camera", **functions):
    return Mistake(where, stages=functions)


def of_vertices(change, where="camera"):
    """A mistake in the vertex stage: change is a function of its right results and of what it is given, by name."""

    def drawn(one):
        right = one.draw.vertex

        def wrong(*inputs):
            results = right.python(*inputs)
            return results._replace(**change(results, dict(zip(right.parameters, inputs, strict=True))))

        return replace(one, draw=replace(one.draw, vertex=mistaken(right, {right.name: wrong})))

    return Mistake(where, draws=drawn)


def undivided(results, given):
    clip = results.clip_position
    return {"clip_position": vec4(clip.x, clip.y, clip.z, F(1))}


def divided_in_the_shader(results, given):
    clip = results.clip_position
    return {"clip_position": vec4(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w, F(1))}


def normal_of_a_point(results, given):
    model = given["normal"]
    return {"fragment_normal": (given["world_from_model"] * vec4(model.x, model.y, model.z, F(1))).xyz}


def position_of_a_direction(results, given):
    model = given["position"]
    return {"fragment_position": (given["world_from_model"] * vec4(model.x, model.y, model.z, F(0))).xyz}


def with_planes(near, far, ours):
    """The projection with other planes in the place of ours, the matrix being (projection * view) * model."""

    def changed(matrix):
        right = matrix.astype(np.float64)
        lens = Perspective(30.0)
        view_depth = right[3] / lens.projection(1.0, *ours)[3, 2]
        other = lens.projection(1.0, near, far)[2]
        right[2] = other[2] * view_depth + np.array([0, 0, 0, other[3]])
        return right

    return changed


def vertex_count(more):
    """A loop over another number of taps."""
    return Mistake("camera", uniforms={"tap_count": lambda count: Count(count + more)})


def without_aspect(matrix):
    return np.diag([2.0, 1, 1, 1]) @ matrix


def without_wrap_divisor(cosine, wrap):
    return max(wrap - cosine, F(0))


def transmitted_with(from_behind):
    """`lit_transmit_wrapped` with another share of the light from behind."""

    def wrong(
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
        share = from_behind(dot(normal_world, normalize(light_position - position_world)), wrap)
        reflected = select(directly_lit, phong, (ambient / light_count) * albedo)
        light = (albedo * incident_light) * ((translucency * translucency_scale) * share)
        return (reflected + light,)

    return wrong


def hard_edges(
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
    """Lit wherever any light is seen."""
    share = transmittance.wrapped(dot(normal_world, normalize(light_position - position_world)), wrap)
    any_light = vec3(*(select(part > 0, F(1), F(0)) for part in (light_visible.x, light_visible.y, light_visible.z)))
    reflected = soft_shadow.blended((ambient / light_count) * albedo, phong, any_light)
    return (reflected + (albedo * incident_light) * ((translucency * translucency_scale) * share),)


def outwards(position_world, normal_world, light_clip_from_world, light_texel_size, lookup_depth):
    return transmittance.below_surface.python(
        position_world, normal_world, light_clip_from_world, light_texel_size, -lookup_depth
    )


def unmoved(position_world, normal_world, light_clip_from_world, light_texel_size, lookup_depth):
    return (position_world,)


def nothing_fades(
    lit,
    position_world,
    inner_lit,
    inner_position_world,
    inner_coverage,
    camera_position,
    extinction_per_mm,
    mm_per_unit,
):
    right = seen_through.seen_through.python(
        lit,
        position_world,
        inner_lit,
        inner_position_world,
        inner_coverage,
        camera_position,
        extinction_per_mm,
        mm_per_unit,
    )
    return right._replace(seen=lit + inner_lit)


def pixels_for_mm(mm_per_pixel, mm_per_offset):
    return (np.broadcast_to(F(mm_per_offset), np.shape(mm_per_pixel)),)


def blurred_through(lit, coverage, position_world, pixel, tap_offset, tap_weight, tap_count, pixel_scale, ahead):
    """`scatter_inside_surface` without looking how far before or behind a tap lies."""
    return scatter_inside.python(lit, coverage, pixel, tap_offset, tap_weight, tap_count, pixel_scale)


def only(given):
    """The buffers that are dumped, and no others."""
    return OnlyThese(given)


class OnlyThese(tuple):
    """In the place of the buffers that are not dumped: those that are."""

    def __contains__(self, name):
        return not super().__contains__(name)


NEWER = [
    Planted("w is not divided by", of_vertices(undivided), "not divided by w: its w is 1"),
    Planted(
        "divided in the vertex shader",
        of_vertices(divided_in_the_shader),
        "divided by w in the shader|w = |perspective",
    ),
    Planted("the normal moved like a point", of_vertices(normal_of_a_point), "moved like a point", "moved"),
    Planted(
        "the position turned like a direction",
        of_vertices(position_of_a_direction),
        "turned and not moved",
        "moved",
        NUMBERS,
    ),
    Planted(
        "near and far of the map", vertex(LIGHT, with_planes(0.5, 20.0, (1.0, 10.0)), "shadow_map"), "near .* and far"
    ),
    Planted("aspect of the camera", vertex(CAMERA, without_aspect), "aspect ratio: it is left out", "wide", NUMBERS),
    Planted(
        "shininess 33, the lit colour alone",
        vertex("shininess", instead(33.0)),
        "shininess is 33",
        lacks=only(LIT_ALONE),
    ),
    Planted(
        "exponent .7, the lit colour alone",
        vertex("exponent", instead(0.7)),
        r"exponent is 0\.7 ",
        lacks=only(LIT_ALONE),
    ),
    Planted(
        "light position x 1.01, the lit colour alone",
        vertex("light_position", scaled(1.01)),
        r"light_position is 1\.01 times as long",
        lacks=only((*LIT_ALONE, "light_distance", "light_triangle", "position_world", "normal_world")),
    ),
    Planted(
        "Blinn for Phong, the lit colour alone",
        stages_of(phong_shading=phong_with(mirror=blinn)),
        "Blinn",
        lacks=only(LIT_ALONE),
    ),
    Planted(
        "bilinear for nearest, the thickness alone",
        stages_of(shadow_lookup_nearest=shadow_map.shadow_lookup_bilinear.python),
        "shadow_lookup_bilinear",
        lacks=only(("light_distance", "light_triangle", "thickness", "position_world", "normal_world")),
    ),
    Planted(
        "the light in front for the one behind, the lit colour alone",
        stages_of(lit_transmit_wrapped=transmitted_with(lambda cosine, wrap: max(wrap + cosine, F(0)) / (1 + wrap))),
        r"wrap \+ cosine",
        lacks=only(LIT_ALONE),
    ),
    Planted("kernel_scale 2 for 1", vertex("kernel_scale", scaled(2)), "kernel_scale is 12 instead of 6", "soft"),
    Planted("soft shadow in red for all", vertex("tap_weight", lambda w: w[:, [0, 0, 0]]), "weights of red", "soft"),
    Planted("soft taps' x and y swapped", vertex("tap_offset", lambda t: t[:, ::-1]), "x and y of the taps", "soft"),
    Planted("12 of 13 taps, soft", vertex_count(-1), "last tap is left out", "soft"),
    Planted("soft shadow with hard edges", stages_of(lit_transmit_wrapped_soft=hard_edges), "hard edges", "soft"),
    Planted("bias without slope, soft", vertex("bias_slope", instead(0.0)), "bias_slope is 0 ", "soft"),
    Planted("wrap 0", vertex("wrap", instead(0.0)), "wrap is 0 "),
    Planted(
        "wrap term not divided",
        stages_of(lit_transmit_wrapped=transmitted_with(without_wrap_divisor)),
        r"not divided by 1 \+ wrap",
    ),
    Planted(
        "no wrap, light from behind alone",
        stages_of(lit_transmit_wrapped=transmitted_with(lambda cosine, wrap: max(-cosine, F(0)))),
        "wrap is 0 |lit_transmit",
    ),
    Planted("scale of T forgotten", vertex("translucency_scale", instead(1.0)), "translucency_scale is 1 "),
    Planted("inside point not moved", stages_of(below_surface=unmoved), "lookup_depth is 0 "),
    Planted("inside point moved outwards", stages_of(below_surface=outwards), r"position_world \+ normal_world"),
    Planted(
        "thickness of the surface itself",
        Mistake("camera", draws=lambda one: with_reads(one, "back_point", stored_distance="stored_distance")),
        "reads stored_distance",
    ),
    Planted(
        "entered from the surface's point",
        Mistake("camera", draws=lambda one: with_reads(one, "back_point", position_world="position_world")),
        "reads position_world",
    ),
    Planted("units for mm between the layers", vertex("mm_per_unit", instead(1.0)), "mm_per_unit is 1 ", "layers"),
    Planted("nothing fades on the way out", stages_of(seen_through=nothing_fades), "nothing fades", "layers"),
    Planted(
        "extinction of red for all",
        vertex("extinction_per_mm", lambda e: np.repeat(e[:1], 3)),
        r"extinction_per_mm is \((\S+), \1, \1\)",
        "layers",
    ),
    Planted("unit forgotten", vertex("mm_per_unit", instead(1.0)), "mm_per_unit is 1 ", "in mm"),
    Planted("pixels for millimetres", stages_of(offset_length=pixels_for_mm), "pixels", "in mm"),
    Planted(
        "follow_surface off",
        Mistake("blur", stages={"scatter_inside_surface": blurred_through}),
        "scatter_inside",
        "in mm",
    ),
    Planted(
        "variances as deviations", vertex("gaussian_variance", lambda v: v * v), "v is a standard deviation", "wax"
    ),
    Planted("Gaussians of red for all", vertex("gaussian_weight", lambda w: w[:, [0, 0, 0]]), "weights of red", "wax"),
    Planted(
        "blur's unit forgotten for wax",
        stages_of(pixel_length=lambda p, m, size, unit: lengths.pixel_length.python(p, m, size, F(1))),
        "mm_per_unit is 1 ",
        "wax",
    ),
]


def with_reads(one, name, **reads):
    """A pass in which a stage reads other buffers."""
    stages = (replace(each, reads={**each.reads, **reads}) if each.name == name else each for each in one.stages)
    return replace(one, stages=tuple(stages))
