"""The stretch of a layout, worked by hand."""

import numpy as np

from sss_ref.mesh.stretch import LONGEST, stretch_of


def stretch(points, uvs):
    return stretch_of(np.float64(points), np.float32(uvs), np.array([[0, 1, 2]]))[0].tolist()


SURFACE = [(1, 1, 1), (4, 1, 5), (1, 3, 1)]  # from the first corner (3, 0, 4), of length 5, and (0, 2, 0)


def test_along_the_axes():
    assert stretch(SURFACE, [(0.5, 0), (1, 0), (0.5, 0.25)]) == [10, 8]
    assert stretch(SURFACE, [(0.5, 0.5), (0, 0.5), (0.5, 0.25)]) == [10, 8]  # turned by 180 degrees
    assert stretch(SURFACE, [(0, 0), (0, 0.5), (0.25, 0)]) == [8, 10]  # mirrored


def test_askew():
    # e1 = dP/du/2 and e2 = (dP/du + dP/dv)/2: dP/du = 2 e1, dP/dv = 2 (e2 - e1) = (-6, 4, -8).
    assert stretch(SURFACE, [(0, 0), (0.5, 0), (0.5, 0.5)]) == [10, np.sqrt(116)]


def test_without_area():
    assert stretch(SURFACE, [(0, 0), (0.5, 0.5), (1, 1)]) == [0, 0]
    assert stretch([(0, 0, 0), (0, 0, 0), (0, 2, 0)], [(0, 0), (1, 0), (0, 1)]) == [0, 2]
    assert stretch([(0, 0, 0), (1e30, 0, 0), (0, 2, 0)], [(0, 0), (1e-9, 0), (0, 1)]) == [LONGEST, 2]


def test_the_bits_are_those_of_the_formula():
    """One triangle after the other, with Python's numbers; the last has no area on the map."""
    random = np.random.default_rng(9)
    points, uvs = random.normal(size=(63, 3)), np.float32(random.random((63, 2)))
    uvs[-3:] = uvs[-1]
    triangles = np.arange(63).reshape(21, 3)
    with np.errstate(all="raise"):
        found = stretch_of(points, uvs, triangles)
    assert found[-1].tolist() == [0, 0]
    for steps, (p0, p1, p2), corners in zip(
        found[:-1], points[triangles].tolist(), uvs[triangles].tolist(), strict=False
    ):
        e1, e2 = ([y - x for x, y in zip(p0, end, strict=True)] for end in (p1, p2))
        (a1, b1), (a2, b2) = ([y - x for x, y in zip(corners[0], end, strict=True)] for end in corners[1:])
        det = a1 * b2 - a2 * b1
        along_u = [(p * b2 - q * b1) / det for p, q in zip(e1, e2, strict=True)]
        along_v = [(q * a1 - p * a2) / det for p, q in zip(e1, e2, strict=True)]
        assert steps.tolist() == [np.sqrt((x * x + y * y) + z * z) for x, y, z in (along_u, along_v)]
