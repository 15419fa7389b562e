"""Small bodies whose geometry is known in closed form, and scenes around them, for the tests that render."""

import math

import numpy as np

from sss_ref.scene_file.layers import filled, overridden
from sss_ref.scene_file.settings import SceneFile

LIGHT = [2.0, 1.5, 2.5]


def cube():
    """The cube [-1, 1]^3, triangles counter-clockwise seen from outside."""
    return _prism(front=1.0, back=lambda x: -1.0)


def wedge():
    """A prism below the origin: its upper face is z = -1, its lower face z = -3 - x, and |x|, |y| <= 1."""
    return _prism(front=-1.0, back=lambda x: -3.0 - x)


def two_slabs():
    """Two thin plates behind each other with air between, the second one wider, so that the first shades it."""
    near, triangles = _prism(front=0.8, back=lambda x: 0.5)
    far, _ = _prism(front=-0.4, back=lambda x: -0.7)
    return np.concatenate([near, far * (1.5, 1.5, 1.0)]), np.concatenate([triangles, triangles + len(near)])


def two_squares():
    """Two squares, one behind the other, with the same UVs: positions, triangles, uvs."""
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], np.float64)
    positions = np.concatenate([np.c_[square, np.full(4, z)] for z in (0.5, -0.5)])
    triangles = np.array([(0, 1, 2), (0, 2, 3), (4, 5, 6), (4, 6, 7)])
    return positions, triangles, np.tile((square + 1) / 2, (2, 1))


def wall():
    """A square of half width 8 in the plane z = 0 that faces +Z: it fills the view of a camera near it."""
    return np.array([(-8, -8, 0), (8, -8, 0), (8, 8, 0), (-8, 8, 0)], np.float64), np.array([(0, 1, 2), (0, 2, 3)])


def sphere(stacks):
    """The unit sphere about the origin as `stacks` rings of 2 * stacks quads, with its UVs: positions, triangles, uvs.

    All vertices lie on the sphere, so the surface lies inside it.
    """
    slices = 2 * stacks
    rows = [(math.sin(math.pi * i / stacks), math.cos(math.pi * i / stacks)) for i in range(stacks + 1)]
    turns = [(math.sin(math.pi * j / stacks), math.cos(math.pi * j / stacks)) for j in range(slices + 1)]
    positions = [(ring * sine, height, ring * cosine) for ring, height in rows for sine, cosine in turns]
    uvs = [(j / slices, 1 - i / stacks) for i in range(stacks + 1) for j in range(slices + 1)]
    triangles = []
    for i in range(stacks):
        for j in range(slices):
            upper, lower = i * (slices + 1) + j, (i + 1) * (slices + 1) + j
            triangles += [(upper, lower, lower + 1)] * (i < stacks - 1) + [(upper, lower + 1, upper + 1)] * (i > 0)
    return np.array(positions), np.array(triangles), np.array(uvs)


def written(path, positions, triangles, uvs=None, flat=False):
    """The path of an OBJ file with these arrays, each number in full; flat: with the normals of the triangles."""
    positions = np.asarray(positions, np.float64)
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in positions.tolist()]
    lines += [f"vt {u!r} {v!r}" for u, v in ([] if uvs is None else uvs.tolist())]
    a, b, c = np.moveaxis(positions[triangles], 1, 0)
    lines += [f"vn {x!r} {y!r} {z!r}" for x, y, z in (np.cross(b - a, c - a).tolist() if flat else [])]
    corner = "{0}//{1}" if flat else "{0}" if uvs is None else "{0}/{0}"
    for number, triangle in enumerate(triangles.tolist(), 1):
        lines.append("f " + " ".join(corner.format(index + 1, number) for index in triangle))
    path.write_text("\n".join(lines) + "\n")
    return str(path)


def around(path, size=128, **tables):
    """A scene that sees a body of about unit size from one side and lights it from another."""
    return {
        "mesh": {"path": path},
        "camera": {
            "type": "orbit",
            "distance": 4.5,
            "azimuth": 160,
            "elevation": 12,
            "fov_y": 40,
            "width": size,
            "height": size,
        },
        "lights": [{"position": LIGHT}],
        "shadow_map": {"width": size, "height": size},
        **tables,
    }


def settings_with(overrides):
    """The settings of `around` with some keys changed, on a mesh that is never opened."""
    data, misplaced = overridden(around("any"), overrides)
    assert not misplaced
    return SceneFile.model_validate(filled(data))


def _prism(front, back):
    """A box |x|, |y| <= 1 between the plane z = front and the surface z = back(x), which must lie behind it."""
    square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
    positions = [(x, y, front) for x, y in square] + [(x, y, back(x)) for x, y in square]
    quads = [(0, 1, 2, 3), (7, 6, 5, 4), *((k, k + 4, (k + 1) % 4 + 4, (k + 1) % 4) for k in range(4))]
    return np.array(positions), np.array([half for a, b, c, d in quads for half in ((a, b, c), (a, c, d))])
