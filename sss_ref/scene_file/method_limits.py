"""What does not go with a method: presets, layers, shadow tests and profiles that it has no passes for."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from sss_ref.errors.wording import unmet, unmet_at
from sss_ref.scene_file.diffusion import Diffusion

PRINTED = ("screen_space", "texture_space")  # the methods that the paper has
ON_SURFACE = ("texture_space", "gaussian_texture")  # those that need UVs
GAUSSIANS = 6


def limit_preset(method: str, preset: str) -> None:
    """Preset `published` has passes for the paper's methods alone."""
    if preset == "published" and method not in PRINTED:
        remedy = f"choose another, or a method that the paper has figures of ({' or '.join(PRINTED)})"
        raise unmet(f'"paper" or "robust" with method = "{method}"', remedy)


def limit_layers(method: str, layers: Sequence[Any]) -> None:
    """A body inside the mesh is seen on the picture, not on a map of the surface."""
    if layers and method in ON_SURFACE:
        remedy = 'remove them or set method = "screen_space"'
        raise unmet(f'no layers with method = "{method}"', remedy, str(len(layers)))


def limit_shadow_map(method: str, shadow_map: Any) -> None:
    """Light that goes round a bend has one shadow test of its own. shadow_map: the table, read."""
    if method == "preintegrated" and shadow_map.test != "slope":
        expected, remedy = '"slope" with method = "preintegrated"', "choose it or another method"
        raise unmet_at(("shadow_map", "test"), expected, f'"{shadow_map.test}"', remedy)


def limit_diffusion(method: str, diffusion: Diffusion) -> None:
    """Six Gaussians are blurred one after the other, each wider than the one before."""
    variances = [row[0] for row in diffusion.gaussians]
    if method == "gaussian_texture" and (len(variances) != GAUSSIANS or variances != sorted(variances)):
        expected = 'six rows, v rising, with method = "gaussian_texture"'
        came, remedy = f"v = {variances}", "give such rows or choose another method"
        raise unmet_at(("diffusion", "profile"), expected, came, remedy)


LIMITS: Mapping[str, Callable[[str, Any], None]] = {  # key of the scene file -> what raises where it does not go
    "preset": limit_preset,
    "layers": limit_layers,
    "shadow_map": limit_shadow_map,
    "diffusion": limit_diffusion,
}
