"""The CPU reference for real-time subsurface scattering: every shader stage of the paper, bit for bit.

    scene = sss_ref.load_scene("figure3_with")
    result = sss_ref.render(scene)
    result["thickness"], result.image, result.hashes
    result.save("out")
    sss_ref.explain(scene, (256, 300))

Importing the package loads neither numba nor trimesh and changes nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sss_ref.errors import DumpError, MeshError, RenderError, SceneError, SssRefError, StageError
    from sss_ref.explanation.explain import explain
    from sss_ref.rendering.fold import render
    from sss_ref.rendering.result import Result
    from sss_ref.scene.load import load_scene
    from sss_ref.scene.own_stage import with_stage
    from sss_ref.scene.scene import Scene
    from sss_ref.validation.scope import Scope
    from sss_ref.validation.stage_by_stage import assert_valid, validate

_HOMES = {
    "DumpError": "sss_ref.errors",
    "MeshError": "sss_ref.errors",
    "RenderError": "sss_ref.errors",
    "Result": "sss_ref.rendering.result",
    "Scene": "sss_ref.scene.scene",
    "SceneError": "sss_ref.errors",
    "Scope": "sss_ref.validation.scope",
    "SssRefError": "sss_ref.errors",
    "StageError": "sss_ref.errors",
    "explain": "sss_ref.explanation.explain",
    "load_scene": "sss_ref.scene.load",
    "render": "sss_ref.rendering.fold",
    "assert_valid": "sss_ref.validation.stage_by_stage",
    "validate": "sss_ref.validation.stage_by_stage",
    "with_stage": "sss_ref.scene.own_stage",
}

__all__ = [
    "DumpError",
    "MeshError",
    "RenderError",
    "Result",
    "Scene",
    "SceneError",
    "Scope",
    "SssRefError",
    "StageError",
    "assert_valid",
    "explain",
    "load_scene",
    "render",
    "validate",
    "with_stage",
]


def __getattr__(name: str) -> Any:
    """Load a public name from its home when it is first asked for."""
    if name not in _HOMES:
        raise AttributeError(f"module 'sss_ref' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted(__all__)
