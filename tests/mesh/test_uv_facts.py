"""The facts of a UV layout: counted by hand on small ones, recorded of the assets, signs held against fractions."""

from fractions import Fraction

import numpy as np
import pytest
from bodies import body

from sss_ref.errors import MeshError
from sss_ref.mesh.uv_facts import UvFacts, area_signs, uv_facts
from sss_ref.scene import load_mesh

F = np.float32

# Two triangles side by side; the edge between them runs from (1, 0) to (0, 1) of the square.
SQUARE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"


def facts(folder, uvs, faces):
    path = folder / "a.obj"
    path.write_text(SQUARE + "".join(f"vt {u} {v}\n" for u, v in uvs) + "".join(f"f {face}\n" for face in faces))
    return uv_facts(load_mesh(path))


def test_a_plain_square(tmp_path):
    found = facts(tmp_path, [(0, 0), (1, 0), (0, 1), (1, 1)], ["1/1 2/2 3/3", "2/2 4/4 3/3"])
    assert found == UvFacts(shifted=0, mirrored=0, zero_area=0, out_of_range=0, seams=0, bounds=(0, 0, 1, 1))


def test_everything_at_once(tmp_path):
    uvs = [(0, 0), (1, 0), (0, 1), (-0.5, 0.25), (0.5, 1.5), (0.25, -0.125)]
    found = facts(tmp_path, uvs, ["1/1 3/3 2/2", "2/4 4/5 3/6", "1/1 2/2 4/1"])
    # Two triangles are clockwise, the second reaches out with all corners, the third has two corners in one place.
    assert (found.mirrored, found.zero_area, found.out_of_range) == (2, 1, 3)
    assert found.bounds == (-0.5, -0.125, 1, 1.5)
    # Edge 2-3 has (1, 0)-(0, 1) and (-.5, .25)-(.25, -.125), edge 2-4 (-.5, .25)-(.5, 1.5) and (1, 0)-(0, 0).
    assert found.seams == 2


def test_shifted_triangles_are_counted_and_judged_where_they_are_now(tmp_path):
    found = facts(tmp_path, [(1, 0), (2, 0), (1, 1), (2, 1)], ["1/1 2/2 3/3", "2/2 4/4 3/3"])
    assert (found.shifted, found.out_of_range, found.bounds) == (2, 0, (0, 0, 1, 1))


def test_a_seam_needs_one_end_to_differ_and_minus_zero_does_not(tmp_path):
    uvs = [(0, 0), (1, 0), (0, 1), (1, 1), (1, "-0.0"), (0, 0.5)]
    assert facts(tmp_path, uvs, ["1/1 2/2 3/3", "2/5 4/4 3/3"]).seams == 0
    assert facts(tmp_path, uvs, ["1/1 2/2 3/3", "2/2 4/4 3/6"]).seams == 1


def exact_sign(corners):
    (u0, v0), (u1, v1), (u2, v2) = [[Fraction(float(x)) for x in corner] for corner in corners]
    area = (u1 - u0) * (v2 - v0) - (u2 - u0) * (v1 - v0)
    return (area > 0) - (area < 0)


def test_signs_are_exact():
    """Thin triangles, whose area in float64 is rounding error: a corner on the line of two others, then one ulp off."""
    rng = np.random.default_rng(31)
    a, b = rng.random((2, 2000, 2)).astype(F)
    middle = ((a.astype(float) + b) / 2).astype(F)
    corners = np.stack([a, b, np.nextafter(middle, rng.choice(F([-1, 2]), middle.shape))], axis=1)
    corners[::7, 2] = corners[::7, 1]
    corners[1::7] *= F(1e-30)
    corners[2::7] *= F(1e12)
    signs = area_signs(corners)
    assert signs.tolist() == [exact_sign(each) for each in corners]
    assert set(signs) == {-1, 0, 1}


def test_signs_that_float64_gets_wrong():
    """2^24 + 1 ulp steps: the products differ in their last bits only, so the plain sum is 0 or of the other sign."""
    e = 2.0**-23
    corners = F([[(1 + e, 1 + 2 * e), (1 + 3 * e, 1 + 4 * e), (2 - e, 2 - e / 2)]])
    assert area_signs(corners).tolist() == [exact_sign(corners[0])]


def test_where_nothing_was_moved_nothing_is_said_to_be():
    mesh = body([(0, 0, 0), (1, 0, 0), (0, 1, 0)], uvs=[(0, 0), (1, 0), (0, 1)])
    assert uv_facts(mesh) == UvFacts(shifted=0, mirrored=0, zero_area=0, out_of_range=0, seams=0, bounds=(0, 0, 1, 1))


def test_no_uvs(tmp_path):
    path = tmp_path / "a.obj"
    path.write_text(SQUARE + "f 1 2 3\n")
    with pytest.raises(MeshError, match=r"^a\.obj: expected UVs, got none; set mesh\.unwrap = true in the scene$"):
        uv_facts(load_mesh(path))


@pytest.mark.parametrize(
    ("path", "mirrored", "zero_area", "out_of_range", "seams"),
    [
        ("blub/blub_triangulated.obj", 0, 0, 0, 208),
        ("head_lps/leeperrysmith.obj", 665, 16, 0, 385),
        ("head_lps/leeperrysmith_283k.glb", 10640, 256, 0, 1540),
        ("gltf/AlphaBlendModeTest.glb", 0, 0, 0, 23),
        ("spot/spot_triangulated.obj", 177, 0, 4, 288),
    ],
)
def test_asset(asset, path, mirrored, zero_area, out_of_range, seams):
    found = uv_facts(load_mesh(asset(path)))
    assert (found.mirrored, found.zero_area, found.out_of_range, found.seams) == (
        mirrored,
        zero_area,
        out_of_range,
        seams,
    )
