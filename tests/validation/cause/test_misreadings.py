"""Every way in which a stage is often misread: what it is asked with then, by hand, or what it gives, in float64."""

import numpy as np
import pytest

from sss_ref.language import Array, Texture, ivec2, vec2, vec3
from sss_ref.validation.cause.misreadings import misread

FLOAT32 = 1e-6  # relative: what is compared was worked out in float64


class Asked:
    """A stage that keeps what it was asked with last, by name, and gives some results."""

    def __init__(self, given, results):
        """given: parameter -> value."""
        self.parameters, self.results, self.asked = list(given), results, None

    def __call__(self, *inputs):
        self.asked = dict(zip(self.parameters, inputs, strict=True))
        return self.results


def misread_as(start, output, given, results):
    """The stage, and what it gives for an output as it is misread in words that start so."""
    stage = Asked(given, results)
    for charge, value in misread(stage, output, given):
        if charge.text.startswith(start):
            return stage, value
    raise AssertionError(f"nothing starts with {start}")


def one(output, start, given, *results):
    """What is given for an output, where the stage itself would give some results."""
    return misread_as(start, output, given, results)[1]


def asked(output, start, given):
    """What the stage itself is asked with instead; its first result is taken as it is."""
    stage, value = misread_as(start, output, given, (vector(1, 2, 3), vector(4, 5, 6)))
    assert value is stage.results[0]
    return stage.asked


def numbers(value):
    """The components of a vector."""
    return np.array([*value], np.float64).tolist()


def vector(*parts):
    return vec3(*map(np.float32, parts))


SHADED = {
    "position_world": vector(1, 2, 3),
    "normal_world": vector(0, 0, 1),
    "albedo": vector(0.5, 0.25, 1),
    "light_position": vector(5, 2, 6),  # to the light (4, 0, 3) / 5
    "camera_position": vector(-2, 2, 7),  # to the eye (-3, 0, 4) / 5
    "incident_light": vector(2, 1, 3),
    "ambient": np.float32(0.3),
    "diffuse": np.float32(0.7),
    "specular": np.float32(0.6),
    "shininess": np.float32(3),
    "light_count": np.float32(2),
}
BELOW = SHADED | {"light_position": vector(5, 2, 0)}  # (4, 0, -3) / 5
GRAZING = SHADED | {"light_position": vector(5, 2, 3)}  # (1, 0, 0)


def shaded(given, lambert, shine, tinted=True):
    """Phong's sum with these cosines, float64."""
    light, albedo = (np.array(numbers(given[name])) for name in ("incident_light", "albedo"))
    gloss = (light if tinted else np.ones(3)) * 0.6 * shine
    return (0.3 / 2 + light * 0.7 * lambert + gloss) * albedo


MIRRORED = 0.96**3  # (V.R)^shininess: R is (-4, 0, 3) / 5
BLINN = (0.7 / np.sqrt(0.5)) ** 3  # H is (1, 0, 7) / 5, made unit
FROM_THE_ORIGIN = (29 / (5 * np.sqrt(57))) ** 3  # V is (-2, 2, 7), made unit


@pytest.mark.parametrize(
    ("start", "given", "expected"),
    [
        ("the highlight is not tinted", SHADED, (0.6, MIRRORED, False)),
        ("the highlight is not tinted", BELOW, (0, 0, False)),
        ("it is Blinn's", SHADED, (0.6, BLINN)),
        ("it is Blinn's", BELOW, (0, 0)),
        ("it is Blinn's", GRAZING, (0, 0)),
        ("N.L wraps round", SHADED, (0.8, MIRRORED)),
        ("N.L wraps round", BELOW, (0.2, 0)),
        ("it is half Lambert", SHADED, (0.64, MIRRORED)),
        ("it is half Lambert", BELOW, (0.04, 0)),
        ("V is normalize(camera_position)", SHADED, (0.6, FROM_THE_ORIGIN)),
        ("V is normalize(camera_position)", BELOW, (0, 0)),
    ],
)
def test_shading_otherwise(start, given, expected):
    assert np.allclose(numbers(one("phong", start, given)), shaded(given, *expected), rtol=FLOAT32, atol=0)


def test_a_thickness_with_its_sign():
    given = {
        "position_world": vector(1, 2, 3),
        "light_position": vector(5, 2, 6),
        "stored_distance": np.float32([4, 7]),
    }
    assert one("thickness", "the thickness is D - t", given).tolist() == [1, -2]


def test_a_depth_along_the_lights_axis():
    given = {"fragment_position": vector(2, 3, 5), "light_position": vector(1, 2, 2)}
    assert one("light_distance", "it is the depth along", given) == -3  # (1, 1, 3) . (-1, -2, -2) / 3
    given = {"fragment_position": vector(0, 3, 3), "light_position": vector(2, -1, 2)}
    assert one("light_distance", "it is the depth along", given) == 2  # (-2, 4, 1) . (-2, 1, -2) / 3


def test_hard_edges():
    given = {"light_visible": vector(0, 0.25, 1), "phong": vector(1, 2, 3)}
    changed = asked("lit", "the shadow has hard edges", given)
    assert numbers(changed["light_visible"]) == [0, 1, 1] and changed["phong"] is given["phong"]


@pytest.mark.parametrize("output", ["lit", "irradiance_used"])
def test_a_wrap_that_is_not_divided(output):
    given = {"translucency_scale": np.float32(0.5), "wrap": np.float32(0.25)}
    changed = asked(output, "what wraps round is not divided", given)
    assert changed == {"translucency_scale": 0.625, "wrap": 0.25}


def test_nothing_fades():
    given = {"lit": vector(1, 2, 3), "inner_lit": vector(0.5, 0.25, 4)}
    assert numbers(one("seen", "nothing fades", given)) == [1.5, 2.25, 7]


@pytest.mark.parametrize(("start", "variances"), [("the Gaussians are e^(-d", [1, 6]), ("v is a stand", [0.25, 9])])
def test_other_variances(start, variances):
    given = {"gaussian_variance": Array(np.float32([0.5, 3])), "thickness": np.float32(1)}
    changed = asked("translucency", start, given)
    assert changed["gaussian_variance"].data.tolist() == variances and changed["thickness"] == 1


WEIGHTS = np.float32([[1, 2, 3], [4, 5, 6]])


@pytest.mark.parametrize(
    ("output", "name"),
    [("translucency", "gaussian_weight"), ("scattered", "tap_weight"), ("scattered_irradiance", "tap_weight")],
)
def test_the_weights_of_red_for_all(output, name):
    changed = asked(output, "all channels have the weights of red", {name: Array(WEIGHTS)})
    assert changed[name].data.tolist() == [[1, 1, 1], [4, 4, 4]]


def test_one_tap_less():
    assert asked("scattered", "the last tap", {"tap_count": 13}) == {"tap_count": 12}


def test_a_blur_in_gamma_space():
    lit = np.float32([[[0.25, 1, 0], [-1, 4, 0.5]]])
    stage, value = misread_as("it is blurred in gamma", "scattered", {"lit": Texture(lit)}, (vector(-1, 0.5, 2), None))
    assert np.allclose(numbers(value), [0, 0.5**2.2, 2**2.2], rtol=FLOAT32, atol=0)
    encoded = [[[0.25 ** (1 / 2.2), 1, 0], [0, 4 ** (1 / 2.2), 0.5 ** (1 / 2.2)]]]
    assert np.allclose(stage.asked["lit"].data, encoded, rtol=FLOAT32, atol=0)


def test_pictures_that_repeat():
    lit, coverage = np.arange(18, dtype=np.float32).reshape(2, 3, 3), np.uint8([[1, 0, 0], [0, 1, 1]])
    given = {
        "lit": Texture(lit),
        "coverage": Texture(coverage),
        "pixel": ivec2(np.int32([0, 2]), np.int32([1, 0])),
        "pixel_scale": np.float32(2),
    }
    changed = asked("light_visible", "the texture repeats", given)
    (columns, rows), scale = changed["pixel"], changed["pixel_scale"]
    assert (columns - 64).tolist() == [0, 2] and (rows - 64).tolist() == [1, 0] and scale == 2
    for name, picture in (("lit", lit), ("coverage", coverage)):
        wide = changed[name].data
        assert wide.shape[:2] == (2 + 128, 3 + 128)
        for row in (-64, -1, 0, 1, 2, 65):
            for column in (-64, -1, 0, 2, 3, 66):
                assert np.array_equal(wide[64 + row, 64 + column], picture[row % 2, column % 3])


LOOKED_UP = {
    "light_distance": Texture(np.arange(32, dtype=np.float32).reshape(4, 8)),
    "position_world": vector(0, 0, 0),
}


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ("upside down", 20),
        ("half a texel too far up and right", 20),
        ("half a texel too far up and left", 19),
        ("half a texel too far down and right", 12),
        ("half a texel too far down and left", 11),
    ],
)
def test_a_map_read_beside_its_place(words, found):
    """The middle of its 4 rows and 8 columns lies between texels; above it for the one that counts from the top."""
    v = 0.3 if words == "upside down" else 0.5
    uv, valid = vec2(np.float32([0.5, 0.5]), np.float32([v, v])), np.array([True, False])
    value = one("stored_distance", f"the shadow map is read {words}", LOOKED_UP, uv, valid, np.float32([99, 99]))
    assert value.tolist() == [found, 99]


TEXELS = np.float32([[[0, 0.04, 0.5]], [[1, 0.0405, 0.2]]])
DECODED = [  # IEC 61966-2-1
    [[0, 0.04 / 12.92, (0.555 / 1.055) ** 2.4]],
    [[1, (0.0955 / 1.055) ** 2.4, (0.255 / 1.055) ** 2.4]],
]


@pytest.mark.parametrize(("name", "output"), [("normal_map", "normal_world"), ("specular_map", "mapped_specular")])
def test_a_map_read_as_srgb(name, output):
    words = name.replace("_", " ")
    texels = asked(output, f"the {words} is read as sRGB", {name: Texture(TEXELS)})[name].data
    assert texels.dtype == np.float32 and np.allclose(texels, DECODED, rtol=FLOAT32, atol=0)


@pytest.mark.parametrize(
    ("words", "name", "output"),
    [
        ("texture", "albedo_map", "albedo"),
        ("normal map", "normal_map", "normal_world"),
        ("specular map", "specular_map", "mapped_specular"),
    ],
)
def test_a_map_read_upside_down(words, name, output):
    texels = asked(output, f"the {words} is read upside down", {name: Texture(TEXELS)})[name].data
    assert np.array_equal(texels, [TEXELS[1], TEXELS[0]])


def test_normals_read_otherwise():
    given = {
        "normal_map": Texture(TEXELS),
        "normal_scale": vec2(np.float32(2), np.float32(3)),
        "unmapped_normal_world": vector(0, 0, 1),
    }
    assert numbers(asked("normal_world", "the normal map's green", given)["normal_scale"]) == [2, -3]
    assert one("normal_world", "there is no normal map", given) is given["unmapped_normal_world"]
    half = asked("normal_world", "the normal map is taken from 0 to 1", given)["normal_map"].data
    assert np.array_equal(half, TEXELS * 0.5 + np.float32(0.5))
    swapped = asked("normal_world", "tangent and bitangent", given)["normal_map"].data
    assert np.array_equal(swapped, TEXELS[..., [1, 0, 2]])


def test_what_needs_other_inputs_is_left_out_and_so_are_other_outputs():
    given = {"wrap": np.float32(1), "translucency_scale": np.float32(1)}
    (found,) = misread(Asked(given, [None]), "lit", given)
    assert found[0].text == "what wraps round is not divided by 1 + wrap"
    assert not [*misread(Asked(SHADED, [None]), "image", SHADED)]
