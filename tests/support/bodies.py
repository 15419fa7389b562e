"""Meshes of a few vertices, made without a file."""

import numpy as np

from sss_ref.mesh.triangles import Mesh


def body(positions, triangles=((0, 1, 2),), uvs=None):
    """A mesh of these positions (V, 3) and triangles (T, 3), all normals along +Z."""
    positions = np.array(positions, np.float32)
    normals = np.tile(np.float32([0, 0, 1]), (len(positions), 1))
    corners = np.array(triangles, np.int32)
    uvs = None if uvs is None else np.array(uvs, np.float32)
    return Mesh("body.obj", positions, normals, uvs, corners, np.zeros(len(corners), np.int32), (), "computed")
