"""Random scenes in clip space for the rasterizer's tests: (clip_position, attributes, triangles), seeded."""

import numpy as np

ATTRIBUTES = 3


def grid_triangles(rng, count, viewport):
    """Corners on half pixels of a picture whose sides are powers of two: many samples lie exactly on an edge."""
    size = np.array([viewport.width, viewport.height])
    centre = rng.integers(0, 2 * size, (count, 1, 2))
    window = np.clip(centre + rng.integers(-5, 6, (count, 3, 2)), 0, 2 * size) / 2
    ndc = np.concatenate([window * 2 / size - 1, rng.uniform(-1, 1, (count, 3, 1)), np.ones((count, 3, 1))], axis=2)
    w = 2.0 ** rng.integers(-3, 4, (count, 3, 1))
    return (ndc * w).astype(np.float32)


def large_triangles(rng, count, viewport):
    """Corners in front of the eye, behind it and on both sides of every plane."""
    spread = 2.0 ** rng.integers(-6, 12, (count, 1, 1))
    position = rng.normal(size=(count, 3, 4)) * spread * (1, 1, 2, 1)
    position[..., 3] += 0.7 * spread[..., 0]
    return position.astype(np.float32)


def small_triangles(rng, count, viewport):
    """Small triangles anywhere in and around the view volume."""
    w = 2.0 ** rng.uniform(-4, 4, (count, 3, 1))
    ndc = rng.uniform(-1.3, 1.3, (count, 1, 3)) + rng.normal(size=(count, 3, 3)) * 0.25
    return (np.concatenate([ndc, np.ones((count, 3, 1))], axis=2) * w).astype(np.float32)


def soup(seed, count, viewport):
    """`count` unconnected triangles of all three kinds, shuffled, with attributes of very different size."""
    rng = np.random.default_rng(seed)
    share = count // 3
    kinds = [grid_triangles(rng, share, viewport), small_triangles(rng, share, viewport)]
    kinds.append(large_triangles(rng, count - 2 * share, viewport))
    position = rng.permutation(np.concatenate(kinds)).reshape(-1, 4)
    attributes = rng.normal(size=(3 * count, ATTRIBUTES)) * 10.0 ** rng.integers(-3, 4, (3 * count, 1))
    triangles = np.arange(3 * count, dtype=np.int32).reshape(-1, 3)
    return position, attributes.astype(np.float32), triangles
