"""The numbers of the page on mathematics are those that the package computes."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

from sss_ref.view.matrices import cross, dot, length, look_at, perspective, product, transformed

PAGE = " ".join((Path(__file__).parents[1] / "docs" / "mathematics.md").read_text(encoding="utf-8").split())
LIGHT, TARGET, POINT = (np.array(each, float) for each in ((0, 3, 4), (0, 0, 0), (1, 1, 0)))
UP = np.array([0.0, 1.0, 0.0])
VIEW, PROJECTION = look_at(LIGHT, TARGET, UP), perspective(90.0, 1.0, 1.0, 9.0)


def matrix(letter):
    """The numbers of the matrix that the page writes behind `letter =`, or last of several."""
    (found,) = re.findall(rf"\$\$ ?{letter} = (.*?)\$\$", PAGE)
    rows = re.findall(r"\\begin\{pmatrix\}(.*?)\\end\{pmatrix\}", found)[-1].split(r"\\")
    return np.array([[float(cell) for cell in row.split("&")] for row in rows])


def numbers(behind):
    """The numbers in the brackets behind a text of the page."""
    found = PAGE.partition(behind)[2]
    return [eval(each.replace(r"\;", ""), {}) for each in found[found.index("(") + 1 : found.index(")")].split(",")]


def test_the_matrices():
    assert np.allclose(matrix("V"), VIEW, atol=1e-15)
    assert np.allclose(matrix("C"), PROJECTION, atol=1e-15)


def test_the_axes():
    ahead = (TARGET - LIGHT) / length(TARGET - LIGHT)
    assert np.allclose(numbers("*ahead* is $f ="), ahead)
    right = cross(ahead, UP)
    assert np.allclose(numbers("made unit: $r ="), right / length(right))
    assert np.allclose(numbers(r"is $r \times f ="), cross(right / length(right), ahead))


def test_the_point_in_each_space():
    assert np.allclose(numbers("V P ="), transformed(VIEW, POINT[None])[0])
    clip = product(PROJECTION, VIEW) @ [*POINT, 1]
    assert np.allclose(numbers(r"C\,V P ="), clip)
    assert np.allclose(numbers("3.25/4.4) ="), clip[:3] / clip[3], atol=5e-5)


def test_the_texel():
    clip = product(PROJECTION, VIEW) @ [*POINT, 1]
    u, v = (clip[:2] / clip[3] + 1) / 2
    assert f"= {u:.4f}$" in PAGE and f"= {v:.4f}$" in PAGE
    assert f"column {int(1000 * u)}, row {int(1000 * v)}" in PAGE


@pytest.mark.parametrize(("near", "where"), [(1.0, -1.0), (9.0, 1.0)])
def test_near_and_far_are_where_the_page_says(near, where):
    clip = PROJECTION @ [0, 0, -near, 1]
    assert clip[2] / clip[3] == pytest.approx(where, abs=1e-15)


def test_lengths_and_products():
    assert dot(np.array([1.0, 2, 2]), np.array([2.0, 1, -2])) == 0 and length(np.array([1.0, 2, 2])) == 3
    assert f"{length(POINT - LIGHT):.4f}" == f"{math.sqrt(21):.4f}" and f"= {math.sqrt(21):.4f}," in PAGE
