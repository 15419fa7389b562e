"""Whole renderings held against geometry: nothing here was computed by the package before."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from scenes import around, sphere, wall, wedge, written

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.kernels import KERNELS

MAP, PICTURE = 64, 128
WEDGE_VIEWS = {
    "lights": [{"position": [0.0, 0.0, 0.0], "target": [0.0, 0.0, -1.0], "fov_y": 90, "near": 0.5, "far": 8.0}],
    "shadow_map": {"width": MAP, "height": MAP},
    "camera": {
        "type": "look_at",
        "eye": [0.0, 0.0, -6.0],
        "target": [0.0, 0.0, 0.0],
        "fov_y": 90,
        "width": PICTURE,
        "height": PICTURE,
    },
}


@pytest.fixture(scope="module")
def lit_wedge(tmp_path_factory):
    """A wedge between the light at the origin, whose map its upper face fills exactly, and a camera below it.

    Fields of view of 90 degrees and corners on whole pixels make clip space, snap and edge functions exact, so each
    interpolated coordinate is the true one rounded once.
    """
    path = written(tmp_path_factory.mktemp("wedge") / "wedge.obj", *wedge(), flat=True)
    return render(load_scene({"mesh": {"path": path}, **WEDGE_VIEWS}))


def centre(index, size):
    """The coordinate of a pixel centre, -1 to 1 across the picture, exactly."""
    return Fraction(2 * index + 1 - size, size)


def distance(point):
    """The length of an exact vector, at 50 digits."""
    with mpmath.workdps(50):
        return mpmath.sqrt(sum(mpmath.mpf(c.numerator) ** 2 / mpmath.mpf(c.denominator) ** 2 for c in point))


def rear_point(row, column):
    """Where the ray through a pixel's centre meets the wedge's rear face z = -3 - x, exactly.

    The camera at (0, 0, -6) looks along +Z, so its right is -X: the ray is (-nx*s, ny*s, s - 6), and s = 3/(1 - nx).
    """
    nx, ny = centre(column, PICTURE), centre(row, PICTURE)
    s = 3 / (1 - nx)
    return -nx * s, ny * s, s - 6


def front_point(point):
    """The point of the wedge's upper face z = -1 that the shadow map's texel of a point holds, exactly."""
    ndc = (point[0] / -point[2], point[1] / -point[2])
    column, row = (math.floor((c + 1) / 2 * MAP) for c in ndc)
    return centre(column, MAP), centre(row, MAP), Fraction(-1)


def test_the_shadow_map_of_a_plane_is_exact(lit_wedge):
    q = [centre(index, MAP) for index in range(MAP)]
    expected = [[np.float32(distance((x, y, Fraction(-1)))) for x in q] for y in q]
    assert (lit_wedge["light_distance"] == expected).all()


def test_the_rear_face_of_the_wedge_is_where_it_should_be(lit_wedge):
    covered = lit_wedge["coverage"] == 1
    assert covered.sum() > 2000
    for row, column in np.ndindex(covered.shape):
        x, y, z = rear_point(row, column)
        if covered[row, column]:
            expected = [np.float32(float(c)) for c in (x, y, z)]
            assert lit_wedge["position_world"][row, column].tolist() == expected
            assert abs(x) <= 1 and abs(y) <= 1
        else:
            assert abs(x) >= 1 or abs(y) >= 1


def test_the_thickness_of_the_wedge_is_within_4_ulp_at_every_pixel(lit_wedge):
    """d = |P| - |Q|, with P on the rear face and Q on the upper one, both exact; the light is the origin.

    Q lies on the ray of the texel, not of P: that is the method, not an error. 4 ulp because P is rounded (half an
    ulp of a distance up to 4 d), then direction, B = direction*t, P - B and its length round about one ulp each.
    """
    largest = 0.0
    for row, column in np.argwhere(lit_wedge["coverage"]).tolist():
        point = rear_point(row, column)
        true = distance(point) - distance(front_point(point))
        thickness = lit_wedge["thickness"][row, column]
        largest = max(largest, abs(float(thickness - true)) / np.spacing(np.float32(float(true))))
    assert largest <= 4


def test_no_light_reaches_the_rear_of_the_wedge(lit_wedge):
    covered = lit_wedge["coverage"] == 1
    assert (lit_wedge["shadow_valid"][covered] == 1).all()
    assert not lit_wedge["directly_lit"].any()


def test_all_of_the_face_that_the_light_sees_is_lit(tmp_path):
    """Seen from the light itself, every pixel is lit, and no thicker than the bias lets a lit fragment be."""
    path = written(tmp_path / "wedge.obj", *wedge(), flat=True)
    views = WEDGE_VIEWS | {"camera": WEDGE_VIEWS["camera"] | {"eye": [0.0, 0.0, 0.0], "target": [0.0, 0.0, -1.0]}}
    result = render(load_scene({"mesh": {"path": path}, **views}))
    assert (result["coverage"] == 1).all()
    assert (result["directly_lit"] == 1).all()
    texel = 2 / MAP
    assert 0 < result["thickness"].max() <= texel / 2  # a quarter texel on each axis, at 45 degrees at most


# --- a sphere of radius 1 about the origin, lit from LIGHT, tessellated inside it ---

STACKS = 96
SPHERE_LIGHT = [2.0, 1.5, 2.5]
TO_LIGHT = math.sqrt(12.5)


@pytest.fixture(scope="module")
def lit_sphere(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("sphere") / "sphere.obj", *sphere(STACKS))
    scene = around(path, lights=[{"position": SPHERE_LIGHT}], shadow_map={"width": 256, "height": 256})
    return render(load_scene(scene))


def inner_radius():
    """The radius of the largest sphere inside the tessellated one: the nearest plane of a triangle."""
    positions, triangles, _ = sphere(STACKS)
    a, b, c = np.moveaxis(positions[triangles], 1, 0)
    normal = np.cross(b - a, c - a)
    return float((np.sum(normal * a, axis=1) / np.linalg.norm(normal, axis=1)).min()) - 1e-6  # float32 corners


def ends(radius, angle):
    """Where a ray that leaves the light at an angle to the centre enters and leaves a sphere about the origin."""
    middle, half = TO_LIGHT * np.cos(angle), np.sqrt(radius**2 - (TO_LIGHT * np.sin(angle)) ** 2)
    return middle - half, middle + half


def map_angles(result):
    """The angle of each texel's ray to the map's axis, which goes through the centre, and a texel's size there."""
    texel = float(result.scene.lights[0].view.pixel_size)
    x = (np.arange(256) + 0.5 - 128) * texel
    return np.arctan(np.hypot(x, x[:, np.newaxis])), texel


def test_the_tessellated_sphere_is_a_close_one():
    assert 0.9997 < inner_radius() < 1


def test_the_light_distance_of_a_sphere_is_within_the_tessellation_bound(lit_sphere):
    """The surface lies between the spheres of radius r = inner_radius() and 1, and the distance grows with the angle.

    So a texel at the angle a holds a distance between D_1(a - s) and D_r(a + s), D(a) = q*cos a - sqrt(r^2 -
    (q*sin a)^2). s: corners snap to 1/256 pixel, so the surface is shifted by up to 1/512 pixel on each axis.
    """
    angle, texel = map_angles(lit_sphere)
    shift = texel * math.sqrt(2) / 512 + 1e-6
    hits = angle + shift < math.asin(inner_radius() / TO_LIGHT)
    low, _ = ends(1.0, np.maximum(angle[hits] - shift, 0))
    high, _ = ends(inner_radius(), angle[hits] + shift)
    stored = lit_sphere["light_distance"][hits].astype(np.float64)
    assert hits.sum() > 40_000 and np.median(high - low) < 6e-4
    assert ((low - 1e-6 <= stored) & (stored <= high + 1e-6)).all()  # float32 of distances up to 4


def test_the_thickness_of_a_sphere_is_within_the_tessellation_bound(lit_sphere):
    """A fragment on the ray at the angle a leaves the body at F(a) and reads a texel at most half a diagonal away.

    So d lies between F_r(a) - D_r(a + s) and F_1(a) - D_1(a - s), with s = (1/2 + 1/512)*sqrt(2) texels.
    """
    _, texel = map_angles(lit_sphere)
    shift = texel * math.sqrt(2) * (1 / 2 + 1 / 512) + 1e-6
    light = np.array(SPHERE_LIGHT)
    ray = lit_sphere["position_world"].astype(np.float64) - light
    angle = np.arccos(np.sum(ray * -light, axis=2) / (np.linalg.norm(ray, axis=2) * TO_LIGHT))
    grazing = angle + shift >= math.asin(inner_radius() / TO_LIGHT)
    rear = (np.linalg.norm(ray, axis=2) > TO_LIGHT) & (lit_sphere["coverage"] == 1) & ~grazing
    low = ends(inner_radius(), angle[rear])[1] - ends(inner_radius(), angle[rear] + shift)[0]
    high = ends(1.0, angle[rear])[1] - ends(1.0, np.maximum(angle[rear] - shift, 0))[0]
    thickness = lit_sphere["thickness"][rear].astype(np.float64)
    assert rear.sum() > 3_000 and np.median(high - low) < 0.02
    assert ((low - 1e-6 <= thickness) & (thickness <= high + 1e-6)).all()


@pytest.mark.parametrize("kernel", KERNELS)
def test_a_picture_of_one_colour_is_scaled_by_the_kernels_sums(tmp_path, kernel):
    """A wall lit by ambient light alone fills the view: every tap reads the same colour, whatever its offset.

    Thirteen products and twelve sums of positive terms round once each: within 13 ulp of colour * sum.
    """
    scene = around(written(tmp_path / "wall.obj", *wall()), size=48, lights=[{"position": [0.0, 1.0, 16.0]}])
    scene["camera"]["azimuth"] = 0
    result = render(
        load_scene(scene, **{"phong.ambient": 1.0, "phong.diffuse": 0.0, "phong.specular": 0.0, "blur.kernel": kernel})
    )
    colour = np.float32([0.7, 0.4, 0.4])
    assert (result["lit"] == colour).all()
    sums = np.sum(np.float32(KERNELS[kernel])[:, 2:].astype(np.float64), axis=0)
    ulps = np.abs(result["scattered"] - colour * sums) / np.spacing((colour * sums).astype(np.float32))
    assert ulps.max() <= 13
