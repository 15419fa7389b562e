"""Named sets of parameters: everything a scene file leaves out comes from its preset.

What every preset has in common (map sizes, Phong terms, bias) is the default of its field in `settings.py`;
here is only what tells the presets apart.
"""

from typing import Any

# The paper's text, literally.
PAPER: dict[str, Any] = {
    "translucency": {"form": "ratio", "combine": "multiply", "scale": 1.0, "x": 2.0, "y": -1.0, "d_min": 0.1},
    "blur": {"kernel": "table1", "mask": "output", "pixel_scale": 1.0},
    "irradiance_map": {"mode": "paper", "image": "sqrt", "dilate": 4},
}

# What looks right on a real mesh: light is added where it leaves the body, and no colour bleeds over silhouettes.
ROBUST: dict[str, Any] = {
    "translucency": {"form": "ratio", "combine": "transmit", "scale": 0.2, "x": 2.0, "y": 0.5, "d_min": 0.1},
    "blur": {"kernel": "hbh09", "mask": "taps", "pixel_scale": 2.0},
    "irradiance_map": {"mode": "lambert", "image": "product", "dilate": 8},
}

PRESETS: dict[str, dict[str, Any]] = {"paper": PAPER, "robust": ROBUST}
