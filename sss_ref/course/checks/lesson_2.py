"""The exercises of lesson 2: the shadow map."""

import itertools
from collections.abc import Callable, Sequence

from sss_ref.course.checks.answers import NotYet
from sss_ref.raster.coverage import EdgeFunction, at, edge_function, owns_its_samples


def cover_once(answer: Callable[[Sequence[int], Sequence[bool]], bool]) -> None:
    """02: a fill rule under which two triangles that share an edge cover each sample of their square once.

    The square has its corners on samples 0 and 4, its triangles meet on the diagonal. Samples on its right and upper
    border belong to whatever may lie beyond.
    """
    corners = (0, 0), (4, 0), (4, 4), (0, 4)
    triangles = [_edges(*(corners[k] for k in chosen)) for chosen in ((0, 1, 2), (0, 2, 3))]
    for column, row in itertools.product(range(5), repeat=2):
        drawn = [answer([at(e, column, row) for e in edges], [*map(owns_its_samples, edges)]) for edges in triangles]
        count, expected = sum(map(bool, drawn)), int(column < 4 and row < 4)
        if count != expected:
            where = "on their common edge" if column == row else "elsewhere"
            raise NotYet(
                f"sample ({column}, {row}), {where}, is drawn {count} times, not {expected}. "
                "What tells the two triangles apart where an edge function is 0?"
            )


def _edges(a: tuple[int, int], b: tuple[int, int], c: tuple[int, int]) -> list[EdgeFunction]:
    """The edges of a counter-clockwise triangle with its corners on samples."""
    return [edge_function(start, end, 1, 1) for start, end in ((a, b), (b, c), (c, a))]
