"""Writes data/golden.json: the hashes that every machine must find. Run it only when bits are meant to move.

Every shipped scene in every preset, 128^2 pixels and texels, all buffers. Preset `published` overrules what a scene has
of its own where its passes are fixed; scenes with several lights, layers or parallel rays, which it does not allow,
are left out there.
"""

import json
from pathlib import Path

import sss_ref
from sss_ref.rules import RULES_VERSION
from sss_ref.scene import scene_names
from sss_ref.scene_file.presets import FIXED

GOLDEN = Path(__file__).parents[1] / "golden.json"
SMALL = {f"{table}.{side}": 128 for table in ("camera", "shadow_map") for side in ("width", "height")}


def hashes() -> dict[str, dict[str, str]]:
    """Scene and preset -> buffer -> SHA-256."""
    made = {}
    for scene in scene_names():
        presets = {"paper": {}, "robust": {}, "published": FIXED}
        loaded = sss_ref.load_scene(scene, **SMALL)
        views = (loaded.camera, *(light.view for light in loaded.lights))
        if len(loaded.lights) > 1 or loaded.settings.layers or any(view.lens.is_parallel for view in views):
            del presets["published"]
        for preset, fixed in presets.items():
            made[f"{scene} {preset}"] = sss_ref.render(
                sss_ref.load_scene(scene, preset=preset, **SMALL, **fixed)
            ).hashes
    return made


if __name__ == "__main__":
    text = json.dumps({"rules_version": RULES_VERSION, "scenes": hashes()}, indent=1)
    GOLDEN.write_text(text + "\n", encoding="utf-8")
