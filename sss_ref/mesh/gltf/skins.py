"""Skinned meshes at rest: each vertex moved by the joints it hangs on, as the nodes place them (glTF 2.0, 3.7.3)."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.gltf.accessors import AccessorForm, Accessors, Numbers
from sss_ref.mesh.gltf.gltf_document import GltfDocument, GltfSkin
from sss_ref.mesh.gltf.gltf_primitives import GltfSurface
from sss_ref.mesh.gltf.hierarchy import Hierarchy
from sss_ref.view.matrices import product

JOINTS = AccessorForm("VEC4", ("unsigned byte", "unsigned short"))
WEIGHTS = AccessorForm("VEC4", ("float", "unsigned byte normalized", "unsigned short normalized"))
INVERSE_BIND = AccessorForm("MAT4", ("float",), tight=True)

SUM_TOLERANCE = 0.01  # of a vertex's weights from 1; what is left by rounding is divided out

Matrices = NDArray[np.float64]  # (N, 3, 4), the rows of affine matrices


class Skins:
    """The skins of a file."""

    def __init__(self, document: GltfDocument, accessors: Accessors, hierarchy: Hierarchy) -> None:
        self._document, self._accessors, self._hierarchy = document, accessors, hierarchy
        self._matrices: dict[int, Matrices] = {}

    def posed(self, surface: GltfSurface, number: int, user: str) -> GltfSurface:
        """A surface in world space; the transform of its own node has no part in that. user: the node's `skin`."""
        if number not in self._matrices:
            self._matrices[number] = self._joint_matrices(number, user)
        matrices = self._weighted(surface, self._matrices[number])
        mirrored = _determinants(matrices) < 0
        if mirrored.any() and not mirrored.all():
            raise self._document.refused(surface.place, "joints that all mirror or none", "both")
        normals = surface.normals
        return replace(
            surface,
            positions=_transformed(matrices, surface.positions, 1.0),
            normals=None if normals is None else _transformed(_for_normals(matrices), normals, 0.0),
            triangles=surface.triangles[:, ::-1] if mirrored.any() else surface.triangles,
        )

    def _joint_matrices(self, number: int, user: str) -> Matrices:
        """world_from_joint * the inverse bind matrix, of each joint."""
        skin, place = self._document.entry(GltfSkin, number, user), f"skins[{number}]"
        self._accessors.spend(len(skin.joints))
        binds = np.broadcast_to(np.eye(4), (len(skin.joints), 4, 4))
        if skin.inverseBindMatrices is not None:
            user = f"{place}.inverseBindMatrices"
            columns = self._accessors.numbers(skin.inverseBindMatrices, INVERSE_BIND, user)
            binds = columns.reshape(-1, 4, 4).transpose(0, 2, 1)
        if len(binds) < len(skin.joints):
            expected = f"a matrix for each of {len(skin.joints)} joints"
            raise self._document.refused(f"{place}.inverseBindMatrices", expected, str(len(binds)))
        if not np.isfinite(binds).all() or (binds[:, 3] != [0, 0, 0, 1]).any():
            expected = "finite matrices with the last row [0, 0, 0, 1]"
            raise self._document.refused(f"{place}.inverseBindMatrices", expected, "another")
        worlds = [self._world(joint, f"{place}.joints[{order}]") for order, joint in enumerate(skin.joints)]
        return np.stack([product(world, bind)[:3] for world, bind in zip(worlds, binds, strict=False)])

    def _world(self, joint: int, user: str) -> Matrices:
        if joint >= len(self._document.top.nodes):
            raise self._document.refused(user, "the number of one of the nodes", str(joint))
        return self._hierarchy.world(joint)

    def _weighted(self, surface: GltfSurface, joints: Matrices) -> Matrices:
        """Of each vertex, the sum of its joints' matrices by their weights (V, 3, 4)."""
        result = np.zeros((len(surface.positions), *joints.shape[1:]))
        total = np.zeros(len(surface.positions))
        for numbers, weights in self._influences(surface, len(joints)):
            result += weights[:, np.newaxis, np.newaxis] * joints[numbers]
            total += weights
        if (np.abs(total - 1) > SUM_TOLERANCE).any():
            vertex = int(np.argmax(np.abs(total - 1) > SUM_TOLERANCE))
            came = f"{total[vertex]:g} at vertex {vertex}"
            raise self._document.refused(f"{surface.place}.attributes", "weights that sum to 1", came)
        return result / total[:, np.newaxis, np.newaxis]

    def _influences(self, surface: GltfSurface, joints: int) -> Iterator[tuple[NDArray[np.int64], Numbers]]:
        """One joint of each vertex and its weight, (V,) each, four times for each set that there is."""
        attributes, count = surface.primitive.attributes, len(surface.positions)
        sets = sorted(name.removeprefix("JOINTS_") for name in attributes if name.startswith("JOINTS_"))
        if not sets:
            raise self._document.refused(surface.place, "JOINTS_0, as its node has a skin", "none")
        for name in sets:
            if f"WEIGHTS_{name}" not in attributes:
                raise self._document.refused(surface.place, f"WEIGHTS_{name} for its JOINTS_{name}", "none")
            place = f"{surface.place}.attributes."
            self._accessors.spend(8 * count)
            numbers = self._accessors.integers(attributes[f"JOINTS_{name}"], JOINTS, f"{place}JOINTS_{name}", count)
            weights = self._accessors.numbers(attributes[f"WEIGHTS_{name}"], WEIGHTS, f"{place}WEIGHTS_{name}", count)
            if not (np.isfinite(weights).all() and (weights >= 0).all()):
                raise self._document.refused(f"{place}WEIGHTS_{name}", "finite weights >= 0", "others")
            bad = (weights > 0) & (numbers >= joints)
            if bad.any():
                came = f"{numbers[bad][0]} at vertex {np.argmax(bad.any(axis=1))}"
                raise self._document.refused(f"{place}JOINTS_{name}", f"joints from 0 to {joints - 1}", came)
            used = np.where(weights > 0, numbers, 0).astype(np.int64)
            yield from ((used[:, column], weights[:, column]) for column in range(4))


def _transformed(matrices: Matrices, points: Numbers, w: float) -> Numbers:
    """Each point (V, 3) by its own matrix: ((m0*x + m1*y) + m2*z) + m3*w."""
    x, y, z = points.T[:, :, np.newaxis]
    m = matrices
    return ((m[:, :, 0] * x + m[:, :, 1] * y) + m[:, :, 2] * z) + m[:, :, 3] * w


def _cofactors(matrices: Matrices) -> Matrices:
    """Of the left 3 x 3 part of each matrix."""
    a, b, c = np.moveaxis(matrices[:, :, :3], 1, 0)
    return np.stack([_crossed(b, c), _crossed(c, a), _crossed(a, b)], axis=1)


def _crossed(a: Numbers, b: Numbers) -> Numbers:
    (x, y, z), (p, q, r) = a.T, b.T
    return np.stack([y * r - z * q, z * p - x * r, x * q - y * p], axis=1)


def _determinants(matrices: Matrices) -> Numbers:
    x, y, z = matrices[:, 0, :3].T
    p, q, r = _cofactors(matrices)[:, 0].T
    return (x * p + y * q) + z * r


def _for_normals(matrices: Matrices) -> Matrices:
    """The inverse transposes (V, 3, 4), 0 where there is none: such normals are then missing."""
    determinants = _determinants(matrices)[:, np.newaxis, np.newaxis]
    cofactors = np.where(determinants == 0, 0.0, _cofactors(matrices))
    inverse = cofactors / np.where(determinants == 0, 1.0, determinants)
    return np.concatenate([inverse, np.zeros((len(matrices), 3, 1))], axis=2)
