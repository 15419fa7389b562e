"""The fragments that exercises are tried on: every name that a stage may read, with values that a scene may have."""

from typing import Any

import numpy as np

from sss_ref.language import vec2, vec3

COUNT = 64
UNIFORMS = {
    "light_intensity": 1.5,
    "ambient": 0.1,
    "diffuse": 0.8,
    "specular": 0.4,
    "shininess": 12.0,
    "light_count": 1.0,
    "bias_abs": 0.25,
    "translucency_scale": 0.2,
    "translucency_neutral": 0.0,
    "d_min": 0.25,
    "exponent": 0.6,
    "x": 2.0,
    "y": 0.5,
}


def fragments(seed: int) -> dict[str, Any]:
    """Name -> value: float32 arrays and vectors of 64 fragments each, and uniforms."""
    draw = np.random.default_rng(seed)
    uniforms = {name: np.float32(value) for name, value in UNIFORMS.items()}
    places = {name: _vectors(draw.normal(size=(COUNT, 3))) for name in ("position_world", "fragment_position")}
    colours = {
        name: _vectors(draw.uniform(0.05, 1, (COUNT, 3)))
        for name in ("albedo", "phong", "scattered", "irradiance_used", "incident_light")
    }
    truths = {name: draw.uniform(size=COUNT) < 0.5 for name in ("coverage", "directly_lit", "shadow_valid")}
    lengths = {name: draw.uniform(0.1, 6, COUNT).astype(np.float32) for name in ("stored_distance", "thickness")}
    fixed = {
        "light_position": _vector(3.0, 1.5, 2.0),
        "camera_position": _vector(0.0, 0.5, 4.0),
        "light_color": _vector(1.0, 0.75, 0.5),
        "background": _vector(0.1, 0.2, 0.3),
        "normal_world": _vectors(units(draw, COUNT)),
        "uv": vec2(*draw.uniform(size=(2, COUNT)).astype(np.float32)),
    }
    return {**uniforms, **places, **colours, **truths, **lengths, **fixed}


def units(draw: np.random.Generator, count: int) -> np.ndarray:
    """Unit vectors (N, 3) in random directions."""
    vectors = draw.normal(size=(count, 3))
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def _vectors(rows: np.ndarray) -> vec3:
    return vec3(*rows.astype(np.float32).T)


def _vector(*parts: float) -> vec3:
    return vec3(*map(np.float32, parts))
