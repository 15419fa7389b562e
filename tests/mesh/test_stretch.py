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
