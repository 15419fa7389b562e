"""Texture space: both interpreters, what each pass makes of the one before, the UV layout, and several lights."""

import re
from pathlib import Path

import naive_stages
import numpy as np
import pytest
from one_stage import Inputs, assert_same_bits, run, run_naively
from scenes import LIGHT, around, sphere, wall, written

from sss_ref.errors import MeshError
from sss_ref.interpret import arrays
from sss_ref.passes import blur, irradiance, texture_image
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.kernels import KERNELS

MAP = 64  # texels of the irradiance map, across and down
SUFFIXES = ["_1", "_2", "_3"]
BACKGROUND = (0.25, 0.5, 2.0)
LIGHTS = [
    {"position": LIGHT, "intensity": 0.5},
    {"position": [-3.0, 0.5, 1.0], "color": [1.0, 0.5, 0.25], "falloff": "inverse_square"},
    {"position": [0.0, 3.5, -1.0], "color": [0.25, 0.5, 1.0], "intensity": 0.75},
]

# Each alternative of the scene file that matters here occurs at least once; few, since each is compiled.
CASES = {
    "paper": {"preset": "paper"},
    "robust": {"preset": "robust", "lights": LIGHTS, "translucency.combine": "transmit", "shadow_map.test": "slope"},
    "wrapped": {"preset": "robust"},
    "distance": {
        "irradiance_map": {"mode": "distance", "dilate": 0, "overlap": "last"},
        "blur.mask": "none",
        "shadow_map": {"filter": "bilinear", "test": "literal", "bias_abs": 0.03},
    },
    "product": {"irradiance_map": {"image": "product", "dilate": 1}, "lights.0.falloff": "inverse_square"},
}

# Name -> channels, type, background (None: written everywhere); an independent copy of the table of buffers.
LIGHT_CLEAR = "twice the light's far plane"
BUFFERS = {
    "light_triangle": (1, "<i4", -1),
    "light_depth": (1, "<f4", 1),
    "light_distance": (1, "<f4", LIGHT_CLEAR),
    "light_uv": (2, "<f4", -1),
    "irradiance_mask": (1, "|u1", 0),
    "irradiance": (3, "<f4", 0),
    "irradiance_filled": (3, "<f4", None),
    "irradiance_filled_mask": (1, "|u1", None),
    "scattered_irradiance": (3, "<f4", None),
    "triangle": (1, "<i4", -1),
    "depth": (1, "<f4", 1),
    "coverage": (1, "|u1", 0),
    "position_world": (3, "<f4", 0),
    "normal_world": (3, "<f4", 0),
    "uv": (2, "<f4", 0),
    "albedo": (3, "<f4", 0),
    "shadow_uv": (2, "<f4", -1),
    "shadow_valid": (1, "|u1", 0),
    "stored_distance": (1, "<f4", 0),
    "entry_point": (3, "<f4", 0),
    "thickness": (1, "<f4", 0),
    "directly_lit": (1, "|u1", 0),
    "incident_light": (3, "<f4", 0),
    "phong": (3, "<f4", 0),
    "translucency": (1, "<f4", 0),
    "irradiance_uv": (2, "<f4", -1),
    "irradiance_used": (3, "<f4", 0),
    "image": (3, "<f4", BACKGROUND),
}
OF_THE_LAYOUT = ("irradiance", "irradiance_mask", "irradiance_filled", "irradiance_filled_mask", "scattered_irradiance")
OF_ALL_LIGHTS = {
    "irradiance_mask",
    "triangle",
    "depth",
    "coverage",
    "position_world",
    "normal_world",
    "uv",
    "albedo",
    "phong",
    "irradiance_used",
    "image",
}


def scene_of(path, map_size=MAP, **overrides):
    """A small scene in texture space."""
    tables = {"method": "texture_space", "irradiance_map": {"width": map_size, "height": map_size}}
    return load_scene(around(path, size=48, **tables), **overrides)


def by_array(path, keep="all", **overrides):
    """The rendering of such a scene by array code, which needs no compiling."""
    return render(scene_of(path, **overrides), keep=keep, interpreter="arrays")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("unwrapped")


@pytest.fixture(scope="module")
def bodies(folder):
    """A sphere with a margin around its chart, and one whose chart is folded: nearly every texel is covered twice."""
    positions, triangles, uvs = sphere(12)
    folded = np.abs(uvs - (0.5, 0.0)) * (2, 1)
    return {
        "ball": written(folder / "ball.obj", positions, triangles, uvs * 0.6 + 0.2),
        "folded": written(folder / "folded.obj", positions, triangles, folded),
    }


@pytest.mark.parametrize("body", ["ball", "folded"])
@pytest.mark.parametrize("case", CASES)
def test_both_interpreters_give_the_same_bits(bodies, body, case):
    scene = scene_of(bodies[body], **CASES[case])
    compiled, expected = render(scene), render(scene, interpreter="arrays")
    assert list(compiled.buffers) == list(expected.buffers)
    assert not [name for name in compiled.buffers if compiled[name].tobytes() != expected[name].tobytes()]
    overlaps = [note for note in compiled.notes if not note.startswith("image: ")]
    assert compiled.notes == expected.notes and bool(overlaps) == (body == "folded")
    assert all(np.isfinite(buffer).all() for buffer in compiled.buffers.values())
    covered, suffix = compiled["coverage"] == 1, "" if len(scene.lights) == 1 else "_1"
    lit, valid = (compiled[name + suffix] == 1 for name in ("directly_lit", "shadow_valid"))
    assert (lit & covered).any() and (~lit & valid & covered).any() and not covered.all()


# Buffers


def test_with_one_light_buffers_have_no_number(bodies):
    assert set(by_array(bodies["ball"], **CASES["paper"]).buffers) == set(BUFFERS)


def test_with_three_lights_what_belongs_to_a_light_has_its_number(bodies):
    numbered = {name + suffix for name in set(BUFFERS) - OF_ALL_LIGHTS | {"phong"} for suffix in SUFFIXES}
    assert set(by_array(bodies["ball"], **CASES["robust"]).buffers) == OF_ALL_LIGHTS | numbered


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_every_buffer_has_its_shape_type_and_background(bodies, suffix):
    result = by_array(bodies["ball"], **CASES["robust"], **{"output.background": list(BACKGROUND)})
    far = result.scene.lights[SUFFIXES.index(suffix)].view.far
    drawn = {
        "light": result["light_triangle" + suffix] >= 0,
        "layout": result["irradiance_mask"] == 1,
        "camera": result["coverage"] == 1,
    }
    assert all(where.any() and not where.all() for where in drawn.values())
    for name, (channels, dtype, background) in BUFFERS.items():
        where = drawn["light" if name.startswith("light_") else "layout" if name in OF_THE_LAYOUT else "camera"]
        buffer = result[name if name in OF_ALL_LIGHTS else name + suffix]
        assert buffer.shape == (where.shape if channels == 1 else (*where.shape, channels)), name
        assert buffer.dtype.str == dtype, name
        expected = np.float32(2 * far) if background == LIGHT_CLEAR else background
        assert background is None or (buffer[~where] == np.array(expected, dtype)).all(), name


# What each pass makes of the one before


def of_light(values, suffix):
    """The values, those of one light also under their names without its number."""
    return {**values, **{name.removesuffix(suffix): value for name, value in values.items() if name.endswith(suffix)}}


def redo(result, stage, suffix="", **given):
    """The one buffer, or the first, that a stage makes of the buffers of a rendering, run by itself."""
    buffers = of_light(result.buffers, suffix) | given
    height, width = buffers[next(name for name in stage.parameters if name in buffers)].shape[:2]
    inputs = Inputs(width, height, buffers, of_light(result.scene.uniforms, suffix))
    return next(iter(run(arrays, stage, inputs).values()))


def in_order(parts):
    """Their sum, starting with the first."""
    total = parts[0]
    for part in parts[1:]:
        total = total + part
    return total


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("case", ["robust", "distance"])
def test_each_light_has_its_own_blurred_irradiance_and_entry_points(bodies, case, suffix):
    result = by_array(bodies["ball"], **{**CASES[case], "lights": LIGHTS})
    filled, mask = result["irradiance_filled" + suffix], result["irradiance_filled_mask" + suffix]
    stage = blur.scatter_inside if case == "robust" else blur.scatter
    scattered = redo(result, stage, lit=filled, coverage=mask)
    entered = redo(result, texture_image.irradiance_lookup, suffix)
    covered = result["coverage"] == 1
    assert_same_bits({"": result["scattered_irradiance" + suffix]}, {"": scattered})
    assert_same_bits({"": result["irradiance_uv" + suffix][covered]}, {"": entered[covered]})
    others = [result["irradiance" + other] for other in SUFFIXES if other != suffix]
    assert not any((other == result["irradiance" + suffix]).all() for other in others)


@pytest.mark.parametrize("case", ["robust", "distance"])
def test_the_picture_sums_the_lights_in_order(bodies, case):
    result = by_array(bodies["ball"], **{**CASES[case], "lights": LIGHTS})
    product, covered = case == "robust", result["coverage"] == 1
    stage = texture_image.irradiance_added if product else texture_image.irradiance_replaced
    used = in_order([redo(result, stage, suffix) for suffix in SUFFIXES])
    assert_same_bits({"": result["irradiance_used"][covered]}, {"": used[covered]})
    if product:
        gloss = in_order([redo(result, texture_image.gloss_where_lit, suffix) for suffix in SUFFIXES])
        image = redo(result, texture_image.image_product, gloss=gloss)
    else:
        image = redo(result, texture_image.image_sqrt)
    assert_same_bits({"": result.image[covered]}, {"": image[covered]})


@pytest.mark.parametrize("method", ["texture_space", "screen_space"])
def test_phong_is_the_sum_of_the_lights_in_order(bodies, method):
    result = by_array(bodies["ball"], **CASES["robust"], method=method)
    parts = [result["phong" + suffix] for suffix in SUFFIXES]
    assert_same_bits({"": result["phong"]}, {"": in_order(parts)})
    assert (in_order(parts) != in_order(parts[::-1])).any()  # else the order would not show


@pytest.mark.parametrize("rounds", [0, 1, 3])
def test_the_charts_grow_as_by_a_naive_loop(bodies, rounds):
    names = ["irradiance", "irradiance_mask", "irradiance_filled", "irradiance_filled_mask"]
    result = by_array(bodies["ball"], names, map_size=32, **{"irradiance_map.dilate": rounds})
    grown = {name: result[name] for name in ("irradiance", "irradiance_mask")}
    for _ in range(rounds):
        filled = run_naively(naive_stages.dilate, irradiance.dilate, Inputs(32, 32, grown, {}))
        grown = dict(zip(grown, filled.values(), strict=True))
    assert_same_bits({name: result[name] for name in names[2:]}, dict(zip(names[2:], grown.values(), strict=True)))
    assert (grown["irradiance_mask"].sum() > result["irradiance_mask"].sum()) == (rounds > 0)


# Two lights in the place of one


def of_two(path, first, second):
    """The irradiance of one white light, and the two parts when its intensity is shared by two at its place."""
    lights = [{"position": LIGHT, "intensity": intensity} for intensity in (first, second)]
    options = {"irradiance_map.mode": "lambert"}
    whole = by_array(path, "irradiance", **options)
    shared = by_array(path, ["irradiance_1", "irradiance_2"], **options, lights=lights)
    return whole["irradiance"], shared["irradiance_1"], shared["irradiance_2"]


def test_two_lights_of_half_the_intensity_give_half_the_irradiance_each(bodies):
    whole, first, second = of_two(bodies["ball"], 0.5, 0.5)
    # Halving is exact, so here nothing rounds differently.
    assert_same_bits({"": first}, {"": second})
    assert_same_bits({"": whole}, {"": first + second})


def test_two_lights_of_unequal_intensity_add_up_to_one(bodies):
    whole, first, second = of_two(bodies["ball"], 0.3, 0.7)
    # Not the same bits: both intensities, both products with N.L, their sum and the whole are rounded, each by at most
    # half an ulp of the whole.
    assert (np.abs((first + second) - whole) <= 3 * np.spacing(whole)).all()
    assert (first + second != whole).any() and whole.any()


# The UV layout

OVERLAPPING = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (1.0, 0.5)]  # the wall's second triangle lies upon its first


def wall_with(folder, name, uvs, which=slice(None)):
    positions, triangles = wall()
    return written(folder / name, positions, triangles[which], np.asarray(uvs))


def layout_of(path, overlap):
    """The distance to the light laid out flat; every view is given, so none depends on which triangles there are."""
    lights = [{"position": [1.0, 2.0, 9.0], "fov_y": 90, "near": 1.0, "far": 40.0}]
    options = {"irradiance_map": {"mode": "distance", "overlap": overlap}, "lights": lights}
    return by_array(path, ["irradiance", "irradiance_mask"], **options)


@pytest.mark.parametrize(("overlap", "above", "below"), [("first", 0, 1), ("last", 1, 0)])
def test_the_policy_decides_which_triangle_owns_a_texel(folder, overlap, above, below):
    both = layout_of(wall_with(folder, "both.obj", OVERLAPPING), overlap)
    alone = [layout_of(wall_with(folder, f"{k}.obj", OVERLAPPING, slice(k, k + 1)), "error") for k in (0, 1)]
    masks = [one["irradiance_mask"] for one in alone]
    expected = np.where(masks[above][..., None] == 1, alone[above]["irradiance"], alone[below]["irradiance"])
    assert_same_bits({"": both["irradiance"]}, {"": expected})
    assert_same_bits({"": both["irradiance_mask"]}, {"": masks[0] | masks[1]})
    twice, once = int((masks[0] & masks[1]).sum()), int((masks[0] | masks[1]).sum())
    assert twice > 100
    note = f"irradiance map: {twice} of {once} texels are covered more than once; the {overlap} triangle counts"
    assert both.notes == (note,)
    assert alone[0].notes == ()


def test_overlap_can_be_an_error_that_names_two_triangles(folder):
    with pytest.raises(MeshError) as caught:
        layout_of(wall_with(folder, "both.obj", OVERLAPPING), "error")
    assert re.search(r"^both\.obj: .* without overlap, got \d+ texels .*, triangles 0 and 1 ", str(caught.value))


def test_of_many_overlapping_triangles_two_that_share_a_texel_are_named(bodies):
    with pytest.raises(MeshError) as caught:
        layout_of(bodies["folded"], "error")
    named = re.search(r"triangles (\d+) and (\d+) ", str(caught.value))
    _, triangles, uvs = sphere(12)
    first, second = np.float32(np.abs(uvs - (0.5, 0.0)) * (2, 1))[triangles[[int(named[1]), int(named[2])]]]
    assert named[1] != named[2]
    assert (first.min(axis=0) < second.max(axis=0)).all() and (second.min(axis=0) < first.max(axis=0)).all()


def test_uvs_that_cover_no_texel_are_an_error(folder):
    path = wall_with(folder, "point.obj", [(0.25, 0.75)] * 4)
    with pytest.raises(MeshError, match=r"^point\.obj: expected UVs .*, got none that cover a texel; export "):
        layout_of(path, "first")


# Closed forms


@pytest.mark.parametrize(
    ("preset", "scale"), [("paper", 1.0), ("robust", 0.5)], ids=["all of the map", "a chart with a gap around it"]
)
def test_constant_irradiance_is_weighted_with_the_sum_of_the_kernel(folder, preset, scale):
    """A wall whose light is so far above it that N.L rounds to 1 everywhere: its irradiance is 1."""
    corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1)]) * scale + (1 - scale) / 2
    path = wall_with(folder, f"{preset}.obj", corners)
    options = {"irradiance_map.mode": "lambert", "lights": [{"position": [0.0, 0.0, 1e5]}]}
    result = by_array(path, ["irradiance", "irradiance_mask", "scattered_irradiance"], preset=preset, **options)
    covered = result["irradiance_mask"] == 1
    assert covered.sum() == (MAP * scale) ** 2
    assert (result["irradiance"][covered] == 1).all()
    weights = np.float32(KERNELS[result.scene.settings.blur.kernel])[:, 2:]
    exact = weights.astype(np.float64).sum(axis=0)
    # Each of the 13 taps rounds its product and its sum, and half an ulp of the bilinear 1.
    got = result["scattered_irradiance"][covered].astype(np.float64)
    assert (np.abs(got - exact) <= 13 * np.spacing(exact.astype(np.float32))).all()


STACKS = 24
STEP = np.pi / STACKS  # between neighbouring vertices of the sphere, in latitude and in longitude


def smooth_ball(folder):
    """The sphere with its own normals, each equal to its position."""
    path = Path(written(folder / "smooth.obj", *sphere(STACKS)))
    normals = "".join(f"vn {x!r} {y!r} {z!r}\n" for x, y, z in sphere(STACKS)[0].tolist())
    path.write_text(normals + re.sub(r"(\d+)/\d+", r"\1/\1/\1", path.read_text()))
    return str(path)


def test_a_sphere_lit_from_far_has_the_irradiance_of_lamberts_law(folder):
    light = [300.0, 150.0, 200.0]
    options = {"irradiance_map.mode": "lambert", "lights": [{"position": light}]}
    result = by_array(smooth_ball(folder), ["irradiance", "irradiance_mask"], **options)
    row, column = np.nonzero(result["irradiance_mask"])
    polar, turn = np.pi * (1 - (row + 0.5) / MAP), 2 * np.pi * (column + 0.5) / MAP
    normal = np.stack([np.sin(polar) * np.sin(turn), np.cos(polar), np.sin(polar) * np.cos(turn)], axis=1)
    to_light = np.array(light) - normal
    facing = (normal * to_light).sum(axis=1) / np.sqrt((to_light**2).sum(axis=1))
    got = result["irradiance"][row, column, 0]
    # Linear interpolation across a right-angled triangle of legs h is off by at most |f''|/2 * h^2/2, here with
    # |f''| <= 1.2 for the sphere in latitude and longitude; normalizing at most doubles that. Rounding adds 1e-5.
    bound = 0.6 * STEP**2 + 1e-5
    close = np.abs(got - np.maximum(facing, 0)) <= bound
    # Facets face away from the light up to one step before the sphere does.
    shaded = (got == 0) & (facing < STEP)
    assert (close | shaded).all()
    assert close.mean() > 0.95 and (got > 0.5).mean() > 0.1
    assert len(row) > 0.9 * MAP**2
