"""The techniques beside the paper's two methods: small scenes of each, and a mistake in each with where it is."""

from sss_ref.scene.load import load_scene
from sss_ref.scene_file.profiles import SKIN

MAPS = {f"{table}.{side}": 48 for table in ("shadow_map", "irradiance_map") for side in ("width", "height")}
SIDES = {**MAPS, "camera.width": 48, "camera.height": 48}
TWO_LIGHTS = [{"position": [2.4, 1.5, 1.5]}, {"type": "directional", "position": [-4.0, 3.0, 2.0]}]
SCENES = {  # technique -> what its scene has of its own
    "separable": {"diffusion.taps": 9},
    "burley": {"diffusion.samples": 16},
    "gaussian_texture": {},
    "preintegrated": {"diffusion.sharpest_curvature": 0.1},
}
MISTAKES = {  # technique -> keys of a scene that computes something else, and the stage where it first does
    "separable": ({"diffusion.profile": "milk"}, "scatter_along"),
    "gaussian_texture": ({"diffusion.profile": [*SKIN[:-1], (5.0, *SKIN[-1][1:])]}, "gaussian_along"),
    "preintegrated": ({"diffusion.profile": "milk"}, "phong_preintegrated"),
    "burley": ({"diffusion.mean_free_path_mm": [0.907, 0.3, 0.517]}, "scatter_burley"),
}


def of(technique, **given):
    """The bust, small, by a technique."""
    sizes = MAPS if "camera" in given else SIDES
    return load_scene(
        "figure3_with", **{"method": technique, "preset": "robust", **sizes, **SCENES[technique], **given}
    )
