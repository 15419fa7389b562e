"""The package equals the naive rasterizer in every bit, on random triangles."""

from collections import Counter
from functools import partial
from multiprocessing import get_context

import numpy as np
import pytest
from raster_proof import check_primitives, check_scene, draw_naively
from soups import soup

from sss_ref.raster.primitives import assemble
from sss_ref.raster.viewport import Viewport

VIEWPORTS = (Viewport(8, 8), Viewport(16, 8, subpixel_bits=4), Viewport(8, 16), Viewport(16, 16))


def check_soup(seed, count):
    viewport = VIEWPORTS[seed % len(VIEWPORTS)]
    return check_scene(soup(seed, count, viewport), viewport)


def test_five_thousand_triangles():
    counts = sum((check_soup(seed, 250) for seed in range(20)), Counter())
    assert counts["triangles"] == 5000
    assert min(counts[key] for key in ("on_edge", *range(6))) > 500


@pytest.mark.full
def test_a_million_triangles(capsys):
    with get_context("spawn").Pool(2) as pool:
        counts = sum(pool.imap_unordered(partial(check_soup, count=500), range(1000, 3200)), Counter())
    with capsys.disabled():
        print(f"\n{dict(counts)}")
    assert counts["triangles"] >= 1_000_000
    assert min(counts[key] for key in ("on_edge", *range(6))) >= 100_000


def test_the_comparison_sees_a_single_bit():
    viewport = VIEWPORTS[0]
    scene = soup(7, 30, viewport)
    primitives, drawn = assemble(*scene, viewport), draw_naively(scene, viewport)
    check_primitives(primitives, drawn)
    vertex = primitives.corners[0, 0]
    primitives.depth[vertex] = np.nextafter(primitives.depth[vertex], np.float32(1))
    with pytest.raises(AssertionError):
        check_primitives(primitives, drawn)
