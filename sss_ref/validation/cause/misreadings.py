"""How stages are often misread: whole stages done otherwise, each in the words that a report says of it."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.dump.srgb import srgb_decoded
from sss_ref.language import Array, Texture, dot, ivec2, length, max, nearest_texel, normalize, pow, select, size, texel
from sss_ref.language.stage import Stage
from sss_ref.language.types import vec2, vec3
from sss_ref.passes import phong
from sss_ref.validation.cause.hypothesis import INPUT, SETTING, SOURCE, Charge

Given = Mapping[str, Any]  # parameter of a stage -> value
HALF, ONE, ZERO = np.float32(0.5), np.float32(1), np.float32(0)
GAMMA = 2.2
EDGE = 64  # texels by which a picture is repeated beyond its edge


@dataclass(frozen=True)
class Misreading:
    """What is done instead by stages that write `output`: a function of the right stage and of what it is given.

    blames: as a charge has it.
    """

    text: str
    output: str
    compute: Callable[[Any, Given], Any]
    blames: str = SOURCE


def _terms(given: Given) -> tuple[Any, Any, Any]:
    """N.L, and the directions to the light and to the eye."""
    to_light = normalize(given["light_position"] - given["position_world"])
    to_eye = normalize(given["camera_position"] - given["position_world"])
    return dot(given["normal_world"], to_light), to_light, to_eye


def _phong(given: Given, lambert: Any, shine: Any, tinted: bool = True) -> Any:
    light, mirror = given["incident_light"], given["specular"] * shine
    gloss = light * mirror if tinted else vec3(mirror, mirror, mirror)
    ambient = given["ambient"] / given["light_count"]
    return ((ambient + light * (given["diffuse"] * lambert)) + gloss) * given["albedo"]


def _mirrored(given: Given, to_light: Any, to_eye: Any) -> Any:
    return phong.highlight(given["normal_world"], to_light, to_eye, given["shininess"])


def _blinn(right: Any, given: Given) -> Any:
    cosine, to_light, to_eye = _terms(given)
    towards_half: Any = dot(given["normal_world"], normalize(to_light + to_eye))
    half = max(towards_half, ZERO)
    shine = select(cosine > 0, pow(half, given["shininess"]), ZERO)
    return _phong(given, max(cosine, ZERO), shine)


def _untinted(right: Any, given: Given) -> Any:
    cosine, to_light, to_eye = _terms(given)
    return _phong(given, max(cosine, ZERO), _mirrored(given, to_light, to_eye), tinted=False)


def _wrapped(power: int) -> Callable[[Any, Given], Any]:
    def compute(right: Any, given: Given) -> Any:
        cosine, to_light, to_eye = _terms(given)
        lambert = cosine * HALF + HALF
        return _phong(given, lambert * lambert if power == 2 else lambert, _mirrored(given, to_light, to_eye))

    return compute


def _eye_as_direction(right: Any, given: Given) -> Any:
    cosine, to_light, _ = _terms(given)
    return _phong(given, max(cosine, ZERO), _mirrored(given, to_light, normalize(given["camera_position"])))


def _difference(right: Any, given: Given) -> Any:
    return length(given["position_world"] - given["light_position"]) - given["stored_distance"]


def _along_axis(right: Any, given: Given) -> Any:
    at = given["light_position"]
    return dot(given["fragment_position"] - at, normalize(vec3(-at.x, -at.y, -at.z)))


def _hard_edges(right: Any, given: Given) -> Any:
    seen = given["light_visible"]
    any_light = vec3(*(np.where(part > 0, ONE, ZERO) for part in (seen.x, seen.y, seen.z)))
    return right({**given, "light_visible": any_light})[0]


def _undivided_wrap(right: Any, given: Given) -> Any:
    return right({**given, "translucency_scale": given["translucency_scale"] * (ONE + given["wrap"])})[0]


def _unfaded(right: Any, given: Given) -> Any:
    return given["lit"] + given["inner_lit"]


def _lookup(change: Callable[[Any, Any], Any]) -> Callable[[Any, Given], Any]:
    """What the shadow map holds beside the place that a fragment falls on."""

    def compute(right: Any, given: Given) -> Any:
        uv, valid, stored = right(given)
        there = nearest_texel(size(given["light_distance"]), change(uv, given["light_distance"].data.shape))
        return select(valid, texel(given["light_distance"], there), stored)

    return compute


def _beside(x: float, y: float) -> Callable[[Any, Any], Any]:
    def change(uv: Any, shape: tuple[int, ...]) -> Any:
        return vec2(uv.x + np.float32(x / shape[1]), uv.y + np.float32(y / shape[0]))

    return change


def _fewer_taps(right: Any, given: Given) -> Any:
    return right({**given, "tap_count": given["tap_count"] - 1})[0]


def _other_variances(change: Callable[[np.ndarray], np.ndarray]) -> Callable[[Any, Given], Any]:
    """T of a sum of Gaussians if their variances were others."""

    def compute(right: Any, given: Given) -> Any:
        return right({**given, "gaussian_variance": Array(change(given["gaussian_variance"].data))})[0]

    return compute


def _red_for_all(weights: str) -> Callable[[Any, Given], Any]:
    """What a stage gives if all channels had the weights of red."""

    def compute(right: Any, given: Given) -> Any:
        red = np.repeat(given[weights].data[:, :1], 3, axis=1)
        return right({**given, weights: Array(np.ascontiguousarray(red))})[0]

    return compute


def _in_gamma_space(right: Any, given: Given) -> Any:
    encoded = np.maximum(given["lit"].data, 0).astype(np.float64) ** (1 / GAMMA)
    blurred = right({**given, "lit": Texture(encoded.astype(np.float32))})[0]
    return vec3(*(np.maximum(part, ZERO) ** np.float32(GAMMA) for part in (blurred.x, blurred.y, blurred.z)))


def _repeated(right: Any, given: Given) -> Any:
    beyond = ((EDGE, EDGE), (EDGE, EDGE))
    wide: dict[str, Any] = {
        name: Texture(np.pad(value.data, beyond + ((0, 0),) * (value.data.ndim - 2), mode="wrap"))
        for name, value in given.items()
        if isinstance(value, Texture)
    }
    at = given["pixel"]
    return right({**given, **wide, "pixel": ivec2(at.x + np.int32(EDGE), at.y + np.int32(EDGE))})[0]


def _other_texels(picture: str, change: Callable[[np.ndarray], np.ndarray]) -> Callable[[Any, Given], Any]:
    """What a stage gives if the texels of its picture were others."""

    def compute(right: Any, given: Given) -> Any:
        return right({**given, picture: Texture(np.ascontiguousarray(change(given[picture].data)))})[0]

    return compute


def _decoded(texels: np.ndarray) -> np.ndarray:
    """Numbers from 0 to 1 taken for codes of sRGB."""
    return srgb_decoded(texels).astype(np.float32)


def _green_down(right: Any, given: Given) -> Any:
    scale = given["normal_scale"]
    return right({**given, "normal_scale": vec2(scale.x, -scale.y)})[0]


def _unmapped(right: Any, given: Given) -> Any:
    return given["unmapped_normal_world"]


MISREADINGS = (
    Misreading("the normal map's green is upside down", "normal_world", _green_down, INPUT),
    Misreading("the normal map is read as sRGB", "normal_world", _other_texels("normal_map", _decoded), SETTING),
    Misreading(
        "the normal map is taken from 0 to 1, not from -1 to 1",
        "normal_world",
        _other_texels("normal_map", lambda texels: texels * HALF + HALF),
    ),
    Misreading(
        "tangent and bitangent have changed places",
        "normal_world",
        _other_texels("normal_map", lambda texels: texels[..., [1, 0, 2]]),
    ),
    Misreading("there is no normal map", "normal_world", _unmapped, INPUT),
    Misreading("the specular map is read as sRGB", "mapped_specular", _other_texels("specular_map", _decoded), SETTING),
    *(
        Misreading(
            f"the {picture} is read upside down", output, _other_texels(name, lambda texels: texels[::-1]), INPUT
        )
        for picture, name, output in (
            ("texture", "albedo_map", "albedo"),
            ("normal map", "normal_map", "normal_world"),
            ("specular map", "specular_map", "mapped_specular"),
        )
    ),
    Misreading("the highlight is not tinted: it lacks the light's colour", "phong", _untinted),
    Misreading("it is Blinn's highlight, (N.H)^shininess, not Phong's (V.R)^shininess", "phong", _blinn),
    Misreading("N.L wraps round: N.L * 0.5 + 0.5", "phong", _wrapped(1)),
    Misreading("it is half Lambert: (N.L * 0.5 + 0.5)^2", "phong", _wrapped(2)),
    Misreading("V is normalize(camera_position), as if the eye were a direction", "phong", _eye_as_direction),
    Misreading("the thickness is D - t, with its sign, not |P - B|", "thickness", _difference),
    Misreading("the shadow has hard edges: it is lit where any light is seen", "lit", _hard_edges),
    Misreading("what wraps round is not divided by 1 + wrap", "lit", _undivided_wrap),
    Misreading("what wraps round is not divided by 1 + wrap", "irradiance_used", _undivided_wrap),
    Misreading("nothing fades between the two bodies", "seen", _unfaded),
    Misreading("the Gaussians are e^(-d^2/(2*v))", "translucency", _other_variances(lambda v: v + v), INPUT),
    Misreading("v is a standard deviation: e^(-d^2/(v*v))", "translucency", _other_variances(lambda v: v * v), INPUT),
    Misreading("all channels have the weights of red", "translucency", _red_for_all("gaussian_weight"), INPUT),
    Misreading("it is the depth along the light's axis, not the distance |P - L|", "light_distance", _along_axis),
    Misreading(
        "the shadow map is read upside down: v counts from the top",
        "stored_distance",
        _lookup(lambda uv, shape: vec2(uv.x, ONE - uv.y)),
    ),
    *(
        Misreading(
            f"the shadow map is read half a texel too far {y} and {x}", "stored_distance", _lookup(_beside(dx, dy))
        )
        for y, dy in (("up", 0.5), ("down", -0.5))
        for x, dx in (("right", 0.5), ("left", -0.5))
    ),
    *(
        misreading
        for output in ("scattered", "scattered_irradiance", "light_visible")
        for misreading in (
            Misreading("the last tap is left out", output, _fewer_taps, INPUT),
            Misreading("it is blurred in gamma space", output, _in_gamma_space, SETTING),
            Misreading("all channels have the weights of red", output, _red_for_all("tap_weight"), INPUT),
            Misreading("the texture repeats beyond its edge (REPEAT for CLAMP)", output, _repeated, SETTING),
        )
    ),
)


def misread(stage: Stage, output: str, given: Given) -> Iterator[tuple[Charge, Any]]:
    """What a stage gives for one of its outputs if it is misread: the charge, and the value.

    given: parameter -> value. Left out is what needs other inputs than the stage has.
    """

    def right(given: Given) -> Any:
        return stage(*(given[own] for own in stage.parameters))

    for each in (each for each in MISREADINGS if each.output == output):
        with np.errstate(all="ignore"), suppress(KeyError, IndexError):
            yield Charge(each.text, each.blames), each.compute(right, given)
