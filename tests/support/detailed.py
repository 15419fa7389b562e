"""A body with pictures over it: a sphere whose map is mirrored, with bumps and with dull patches."""

import numpy as np
from PIL import Image
from scenes import around, sphere, written


def bumpy(folder, size=32, **tables):
    """A scene on a sphere under a normal map and a specular map, whose files lie in `folder`."""
    positions, triangles, uvs = sphere(8)
    uvs[:, 0] = np.abs(2 * uvs[:, 0] - 1)  # the front half mirrors the back one
    path = written(folder / "mirrored.obj", positions, triangles, uvs)
    rng = np.random.default_rng(5)
    codes = np.concatenate([rng.integers(64, 192, (16, 24, 2)), rng.integers(200, 256, (16, 24, 1))], axis=2)
    Image.fromarray(codes.astype(np.uint8)).save(folder / "bumps.png")
    Image.fromarray(rng.integers(0, 256, (8, 8)).astype(np.uint8)).save(folder / "dull.png")
    maps = {"normal_map": str(folder / "bumps.png"), "specular_map": str(folder / "dull.png")}
    return around(path, size, **{**tables, "mesh": {"path": path, **maps, **tables.get("mesh", {})}})
