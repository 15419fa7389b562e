"""What the techniques beside the paper's two methods read of the body: the uniforms of the table [diffusion]."""

from collections.abc import Callable, Mapping
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.curvature import over_triangles, unit_rows, vertex_curvatures
from sss_ref.mesh.triangles import Mesh
from sss_ref.numerics.elementary import exp_array
from sss_ref.scene.burley_samples import burley_samples
from sss_ref.scene.projected_kernel import projected_kernel
from sss_ref.scene.ring_table import ring_table
from sss_ref.scene_file.diffusion import Diffusion
from sss_ref.scene_file.settings import SceneFile
from sss_ref.view.matrices import Matrix, normal_matrix, transformed


def of_separable(diffusion: Diffusion) -> dict[str, Any]:
    """The taps along a line, and how long that is."""
    place, weight = projected_kernel(diffusion)
    return {**on_axes("kernel", place), "kernel_weight": weight, "reach_mm": diffusion.reach_mm}


def on_axes(name: str, places: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Places along a line (N,) as offsets (N, 2) along the rows and along the columns."""
    beside = np.zeros_like(places)
    return {
        f"{name}_rows": np.stack([places, beside], axis=1),
        f"{name}_columns": np.stack([beside, places], axis=1),
    }


def of_burley(diffusion: Diffusion) -> dict[str, Any]:
    """The samples around a point, and how far away the last one is."""
    distance, place, radius, area = burley_samples(diffusion)
    return {
        "scatter_distance": distance,
        "sample_place": place,
        "sample_radius": radius,
        "sample_area": area,
        "reach_mm": radius[-1],
    }


def of_preintegrated(diffusion: Diffusion) -> dict[str, Any]:
    """The table over N.L and curvature, and the curvature where it ends."""
    return {"diffusion_table": ring_table(diffusion), "sharpest_curvature": diffusion.sharpest_curvature}


def of_gaussian_texture(diffusion: Diffusion) -> dict[str, Any]:
    """The six Gaussians, and how much each is wider than the one before, mm; the taps of a Gaussian."""
    from sss_ref.methods.gaussian_texture import GAUSSIANS  # no other method needs its stages

    rows = np.array(diffusion.gaussians, np.float64)
    wider = np.sqrt(rows[:, 0] - np.concatenate([[0.0], rows[:-1, 0]]))
    places = np.arange(-3.0, 4.0)
    tap = exp_array(np.array([-4.5, -2.0, -0.5, 0.0, -0.5, -2.0, -4.5], np.float32)).astype(np.float64)
    return {
        **{f"spread_{letter}_mm": width for letter, width in zip(GAUSSIANS, wider, strict=True)},
        **on_axes("gaussian", places),
        "spread_weight": tap / reduce(np.add, tap),
        "profile_variance": rows[:, 0],
        "profile_weight": rows[:, 1:] / reduce(np.add, rows[:, 1:]),
    }


SPREADING: Mapping[str, Callable[[Diffusion], dict[str, Any]]] = {
    "separable": of_separable,
    "burley": of_burley,
    "preintegrated": of_preintegrated,
    "gaussian_texture": of_gaussian_texture,
}


def spreading_of(settings: SceneFile) -> dict[str, Any]:
    """The uniforms of a scene's technique by name, not yet rounded; none with the paper's methods."""
    return SPREADING[settings.method](settings.diffusion) if settings.method in SPREADING else {}


def curvatures_of(settings: SceneFile, world_from_model: Matrix, mesh: Mesh) -> dict[str, NDArray[np.float32]]:
    """`triangle_curvature`, which only pre-integrated skin reads: g and c of each triangle, float32 (T, 4)."""
    if settings.method != "preintegrated":
        return {}
    points = transformed(world_from_model, mesh.positions)
    turned = np.concatenate([normal_matrix(world_from_model), np.zeros((3, 1))], axis=1)
    normals = unit_rows(transformed(turned, mesh.normals))
    values = vertex_curvatures(mesh.positions, points, normals, mesh.triangles)
    return {"triangle_curvature": over_triangles(values, points, mesh.triangles).astype(np.float32)}
