"""Writes data/golden.json: the hashes that every machine must find. Run it only when bits are meant to move.

Every shipped scene in every preset, 128^2 pixels and texels, all buffers. Preset `published` overrules what a scene has
of its own where its passes are fixed; scenes with several lights, layers or parallel rays, which it does not allow,
are left out there. Beside them some scenes with settings that no shipped one has: maps that are not square, bilinear
lookup, targets beside the mesh's centre.
"""

import json
from pathlib import Path
from typing import Any

import sss_ref
from sss_ref.rules import RULES_VERSION
from sss_ref.scene import scene_names
from sss_ref.scene_file.presets import FIXED

GOLDEN = Path(__file__).parents[1] / "golden.json"
SMALL = {f"{table}.{side}": 128 for table in ("camera", "shadow_map") for side in ("width", "height")}

TALL = {"shadow_map.width": 96, "shadow_map.height": 160, "lights.0.target": [0.3, -0.2, 0.1]}
WIDE = {"shadow_map.width": 160, "shadow_map.height": 96, "camera.width": 97, "camera.height": 61}
OTHERS = {
    "sphere, tall bilinear map, target beside the centre": ("sphere", {**TALL, "shadow_map.filter": "bilinear"}),
    "sphere_directional, tall map, target beside the centre": ("sphere_directional", TALL),
    "default, wide bilinear map": ("default", {**WIDE, "shadow_map.filter": "bilinear"}),
    "figure5, wide maps": (
        "figure5",
        {**WIDE, "irradiance_map.width": 160, "irradiance_map.height": 96, "shadow_map.filter": "bilinear"},
    ),
    "figure3_with, separable": ("figure3_with", {"method": "separable"}),
    "figure3_with, burley": ("figure3_with", {"method": "burley"}),
    "figure3_with, preintegrated": ("figure3_with", {"method": "preintegrated"}),
    "figure3_with, gaussian_texture": (
        "figure3_with",
        {"method": "gaussian_texture", "irradiance_map.width": 128, "irradiance_map.height": 128},
    ),
    "wedge, literal test, wide map": ("wedge", {**WIDE, "shadow_map.test": "literal", "shadow_map.filter": "bilinear"}),
}


def asked() -> dict[str, tuple[str, dict[str, Any]]]:
    """Name, of scene and preset, -> the scene and what is set in it."""
    found = {}
    for scene in scene_names():
        presets = {"paper": {}, "robust": {}, "published": FIXED}
        loaded = sss_ref.load_scene(scene, **SMALL)
        views = (loaded.camera, *(light.view for light in loaded.lights))
        if len(loaded.lights) > 1 or loaded.settings.layers or any(view.lens.is_parallel for view in views):
            del presets["published"]
        for preset, fixed in presets.items():
            found[f"{scene} {preset}"] = scene, {"preset": preset, **SMALL, **fixed}
    return found | {name: (scene, {**SMALL, **settings}) for name, (scene, settings) in OTHERS.items()}


def hashes(scene: str, settings: dict[str, Any]) -> dict[str, str]:
    """Buffer -> SHA-256."""
    return sss_ref.render(sss_ref.load_scene(scene, **settings)).hashes


if __name__ == "__main__":
    made = {name: hashes(*each) for name, each in asked().items()}
    text = json.dumps({"rules_version": RULES_VERSION, "scenes": made}, indent=1)
    GOLDEN.write_text(text + "\n", encoding="utf-8")
