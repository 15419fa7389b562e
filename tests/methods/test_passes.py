"""Which stages the methods run: pass by pass, with the names that they are bound to where these are not their own."""

from pathlib import Path

import pytest
from scenes import settings_with

from sss_ref.scene.catalogue import method_of

LISTED = Path(__file__).parent / "passes"
LIGHTS = [{"position": [0, 0, 5]}, {"type": "directional", "azimuth": 30, "elevation": 10}]
DETAIL = {"mesh": {"path": "any", "normal_map": "bumps.png", "specular_map": "shine.png"}}
LAYER = {"layers": [{"path": "any", "extinction_per_mm": [1, 1, 1]}], "mm_per_unit": 1.0}
SCENES = {
    "paper": {"preset": "paper"},
    "paper_texture": {"preset": "paper", "method": "texture_space"},
    "published": {"preset": "published"},
    "published_texture": {"preset": "published", "method": "texture_space"},
    "robust": {"preset": "robust"},
    "robust_texture": {"preset": "robust", "method": "texture_space"},
    "wrapped": {"preset": "robust", "translucency.combine": "transmit_wrapped", "shadow_map.test": "slope"},
    "multiplied": {"preset": "robust", "translucency.combine": "multiply", "shadow_map.test": "kernel"},
    "added": {"preset": "robust", "translucency.combine": "add", "shadow_map.test": "kernel", "blur.mask": "none"},
    "gaussians": {"preset": "robust", "translucency.form": "gaussians", "blur.unit": "mm", "blur.mask": "taps"},
    "on_surface": {"preset": "robust", "blur.unit": "mm", "blur.follow_surface": True, "blur.mask": "output"},
    "two_lights": {"preset": "robust", "lights": LIGHTS},
    "detail": {"preset": "robust", **DETAIL},
    "inner_body": {"preset": "robust", **LAYER},
    "texture_mm": {"preset": "robust", "method": "texture_space", "blur.unit": "mm", "blur.mask": "none"},
    "texture_sqrt": {"preset": "robust", "method": "texture_space", "irradiance_map.image": "sqrt", "lights": LIGHTS},
    **{name: {"preset": "robust", "method": name} for name in ("separable", "burley", "preintegrated")},
    "gaussian_texture": {"preset": "robust", "method": "gaussian_texture", "lights": LIGHTS},
}


def bound(stage):
    """A stage by its name, with what it reads and writes by other names than its own."""
    others = {own: name for own, name in {**stage.reads, **stage.writes}.items() if own != name}
    return " ".join([stage.name, *(f"{own}={name}" for own, name in others.items())])


def listed(keys):
    """A line for each pass and each stage."""
    method, lines = method_of(settings_with(keys)), []
    lines.append(f"{method.name} {dict(method.constants)}")
    for each in method.passes:
        draw = each.draw
        marks = [name for name in ("on_demand", "layout") if getattr(each, name, False) or getattr(draw, name, False)]
        limits = [f"stencil {draw.stencil}"] if draw.stencil else []
        rounds = [f"rounds {each.rounds} {dict(each.feedback)}"] if each.feedback else []
        lines.append(" ".join([f"{each.name} on {each.target}", *marks, *limits, *rounds]))
        lines += [f"    {bound(stage)}" for stage in (*draw.vertex_stages, *each.stages)]
        lines += [f"    registers {' '.join(each.registers)}"] if each.registers else []
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("name", SCENES)
def test_the_stages_of_a_method(name):
    assert listed(SCENES[name]) == (LISTED / f"{name}.txt").read_text()
