"""Flatten a disc-shaped piece of surface as rigidly as possible: the shape of one chart of a UV layout.

It starts from Tutte's embedding on a circle (bijective by his theorem) and is relaxed by the local/global
iteration of Liu et al. 2008, "A Local/Global Approach to Mesh Parameterization": fit a rotation to every triangle,
then solve one sparse system for the corners. For generation only.
"""

import numpy as np
from scipy.sparse import coo_matrix, csc_matrix
from scipy.sparse.linalg import splu

ITERATIONS = 200
LEAST_COTANGENT = 0.05  # keeps the system definite where an angle is obtuse
Corners = np.ndarray  # (3 corners, n, 2)


def flatten(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return uv (n, 2) of a disc-shaped chart, in the unit of `vertices` (n, 3); every triangle keeps its winding."""
    rest = corners_in_their_plane(vertices[faces])
    weights = cotangents(rest)
    solve = splu(pinned(laplacian(faces, weights, len(vertices)))).solve
    uv = tutte_embedding(faces, len(vertices)) * np.sqrt(signed_area(rest).sum() / np.pi)
    for _ in range(ITERATIONS):
        uv = solve(rotated_edges(faces, rest, weights, fitted_rotations(faces, rest, weights, uv), len(vertices)))
    return uv


def corners_in_their_plane(triangles: np.ndarray) -> Corners:
    """Lay every triangle (n, 3, 3) into the plane: the first corner at 0, the second on +x."""
    along, across = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    base = np.linalg.norm(along, axis=1)
    x = (along * across).sum(1) / base
    y = np.linalg.norm(np.cross(along, across), axis=1) / base
    zero = np.zeros_like(base)
    return np.stack([np.stack([zero, zero], 1), np.stack([base, zero], 1), np.stack([x, y], 1)])


def edge(corners: Corners, k: int) -> np.ndarray:
    """Return the edge opposite corner `k`, from corner k + 1 to corner k + 2, (n, 2)."""
    return corners[(k + 2) % 3] - corners[(k + 1) % 3]


def signed_area(corners: Corners) -> np.ndarray:
    """Return the area of every triangle, positive when counter-clockwise."""
    a, b = edge(corners, 2), edge(corners, 0)
    return (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2


def cotangents(corners: Corners) -> np.ndarray:
    """Return the cotangent of the angle at each corner, (3, n), at least LEAST_COTANGENT."""
    area = signed_area(corners)
    dots = [-(edge(corners, (k + 1) % 3) * edge(corners, (k + 2) % 3)).sum(1) for k in range(3)]
    return np.maximum(np.stack(dots) / (2 * area), LEAST_COTANGENT)


def laplacian(faces: np.ndarray, weights: np.ndarray, count: int) -> csc_matrix:
    """Return sum over edges of weight (e_i - e_j)(e_i - e_j)^T; `weights` (3, n) belong to the opposite edges."""
    start, end = faces[:, [1, 2, 0]].T.ravel(), faces[:, [2, 0, 1]].T.ravel()
    w = weights.ravel()
    rows, columns = np.concatenate([start, end, start, end]), np.concatenate([start, end, end, start])
    return coo_matrix((np.concatenate([w, w, -w, -w]), (rows, columns)), (count, count)).tocsc()


def pinned(matrix: csc_matrix) -> csc_matrix:
    """Hold the first vertex: the energy does not change under translation, so the system needs one anchor."""
    return (matrix + coo_matrix(([1.0], ([0], [0])), matrix.shape)).tocsc()


def fitted_rotations(faces: np.ndarray, rest: Corners, weights: np.ndarray, uv: np.ndarray) -> np.ndarray:
    """Local step: the unit complex number that turns each rest triangle best onto its image."""
    image = uv[faces].transpose(1, 0, 2)
    turn = sum(weights[k] * as_complex(edge(image, k)) * as_complex(edge(rest, k)).conj() for k in range(3))
    return turn / np.maximum(np.abs(turn), 1e-12)


def rotated_edges(faces: np.ndarray, rest: Corners, weights: np.ndarray, turn: np.ndarray, count: int) -> np.ndarray:
    """Right-hand side of the global step: each corner's share of its triangles' rotated edges, (count, 2)."""
    total = np.zeros(count, complex)
    for k in range(3):
        pull = weights[k] * turn * as_complex(edge(rest, k))
        np.add.at(total, faces[:, (k + 2) % 3], pull)
        np.add.at(total, faces[:, (k + 1) % 3], -pull)
    return np.stack([total.real, total.imag], 1)


def as_complex(plane: np.ndarray) -> np.ndarray:
    """Read (n, 2) as n complex numbers."""
    return plane[:, 0] + 1j * plane[:, 1]


def tutte_embedding(faces: np.ndarray, count: int) -> np.ndarray:
    """Return the embedding with the rim on the unit circle and each inner vertex at its neighbours' mean."""
    rim = boundary_loop(faces)
    angle = 2 * np.pi * np.arange(len(rim)) / len(rim)
    matrix = laplacian(faces, np.ones((3, len(faces))), count).tolil()
    target = np.zeros((count, 2))
    target[rim] = np.stack([np.cos(angle), np.sin(angle)], 1)
    matrix[rim] = 0
    matrix[rim, rim] = 1
    return splu(matrix.tocsc()).solve(target)


def boundary_loop(faces: np.ndarray) -> np.ndarray:
    """Return the vertices of the one boundary loop, walked with the chart on the left; ValueError if no disc."""
    directed = {(int(a), int(b)) for a, b in faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)}
    following = {a: b for a, b in directed if (b, a) not in directed}
    loop = [min(following)]
    while following[loop[-1]] != loop[0] and len(loop) <= len(following):
        loop.append(following[loop[-1]])
    edge_count = len(directed | {(b, a) for a, b in directed}) // 2
    if len(loop) != len(following) or faces.max() + 1 - edge_count + len(faces) != 1:
        raise ValueError("the chart is not a disc: expected one boundary loop and Euler number 1")
    return np.array(loop)
