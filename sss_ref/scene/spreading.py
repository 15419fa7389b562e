"""What the techniques beside the paper's two methods read of the body: the uniforms of the table [diffusion]."""

from collections.abc import Callable, Mapping
from typing import Any

from sss_ref.scene.burley_samples import burley_samples
from sss_ref.scene.projected_kernel import projected_kernel
from sss_ref.scene_file.diffusion import Diffusion
from sss_ref.scene_file.settings import SceneFile


def of_separable(diffusion: Diffusion) -> dict[str, Any]:
    """The taps along a line, and how long that is."""
    place, weight = projected_kernel(diffusion)
    return {"kernel_place": place, "kernel_weight": weight, "reach_mm": diffusion.reach_mm}


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


SPREADING: Mapping[str, Callable[[Diffusion], dict[str, Any]]] = {"separable": of_separable, "burley": of_burley}


def spreading_of(settings: SceneFile) -> dict[str, Any]:
    """The uniforms of a scene's technique by name, not yet rounded; none with the paper's methods."""
    return SPREADING[settings.method](settings.diffusion) if settings.method in SPREADING else {}
