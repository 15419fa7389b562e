"""The exercises of lesson 2: the shadow map."""

import itertools
from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called
from sss_ref.course.checks.fragments import COUNT, fragments
from sss_ref.course.checks.kinds import YES_OR_NO
from sss_ref.course.checks.written_shaders import compared_glsl
from sss_ref.course.checks.written_stages import compared
from sss_ref.passes.shadow_map import directly_lit_literal
from sss_ref.raster.coverage import EdgeFunction, at, edge_function, owns_its_samples


def cover_once(answer: Any) -> None:
    """A line: a fill rule under which two triangles that share an edge cover each sample of their square once.

    The square has its corners on samples 0 and 4, its triangles meet on the diagonal. Samples on its right and upper
    border belong to whatever may lie beyond.
    """
    corners = (0, 0), (4, 0), (4, 4), (0, 4)
    triangles = [_edges(*(corners[k] for k in chosen)) for chosen in ((0, 1, 2), (0, 2, 3))]
    owned = [[bool(owns_its_samples(edge)) for edge in edges] for edges in triangles]
    for column, row in itertools.product(range(5), repeat=2):
        given = [([at(edge, column, row) for edge in edges], own) for edges, own in zip(triangles, owned, strict=True)]
        count = sum(called(answer, YES_OR_NO, *each) for each in given)
        expected = int(column < 4 and row < 4)
        if count != expected:
            where = "on their common edge" if column == row else "elsewhere"
            raise NotYet(
                f"sample ({column}, {row}), {where}, is drawn {count} times, not {expected}. "
                "What tells the two triangles apart where an edge function is 0?"
            )


def _edges(a: tuple[int, int], b: tuple[int, int], c: tuple[int, int]) -> list[EdgeFunction]:
    """The edges of a counter-clockwise triangle with its corners on samples."""
    return [edge_function(start, end, 1, 1) for start, end in ((a, b), (b, c), (c, a))]


def lit_within_a_bias(answer: Any) -> None:
    """A stage: whether the light reaches a fragment, by what its shadow map stores, with room for a bias."""
    hint = "Lit is what lies no further from the light than the stored surface, give or take the bias."
    compared(answer, directly_lit_literal, fragments(2), hint)


def map_coordinates_in_glsl(answer: Any) -> None:
    """A shader: from clip space to the texture coordinates of the shadow map."""
    clip = np.random.default_rng(2).uniform([-1, -1, -1, 2], [1, 1, 1, 4], (COUNT, 4))
    expected = (clip[:, :2] / clip[:, 3:] + 1) / 2
    hint = "Perspective comes first; then the range -1 to 1 becomes 0 to 1."
    compared_glsl(answer, "vec2 map_coordinates(vec4 clip)", {"clip": clip}, expected, hint)
