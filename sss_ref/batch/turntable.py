"""A sweep that goes once around a scene, about +Y through the camera's target."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.batch.sweep_file import Sweep
from sss_ref.errors import SceneError
from sss_ref.errors.wording import told
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.shipped import scene_names
from sss_ref.scene_file.viewpoints import Camera, FreeCamera, OrbitCamera
from sss_ref.view.matrices import rotation, transformed

MOST_FRAMES = 10_000


def turntable(scene: str, frames: int, overrides: Mapping[str, Any]) -> Sweep:
    """The sweep of a turn in so many pictures, the first from where the scene has its camera.

    Raises SceneError for a camera without target, and as `load_scene` does.
    """
    if not 2 <= frames <= MOST_FRAMES:
        raise SceneError(
            f"--frames: expected 2 to {MOST_FRAMES}, got {frames}; 72 makes a smooth turn of three seconds"
        )
    camera = load_scene(scene, **overrides).settings.camera
    if isinstance(camera, FreeCamera):
        remedy = 'use a camera of type "orbit" or "look_at"'
        raise SceneError(told(f"{scene}: camera", "a target to turn around", 'one of type "free"', remedy))
    place = scene if scene in scene_names() else str(Path(scene).absolute())
    return Sweep.model_validate({"scene": place, "set": dict(overrides), "vary": _around(camera, frames)})


def _around(camera: Camera, frames: int) -> dict[str, list[Any]]:
    """The key that turns a camera, with its values."""
    degrees = [360 * number / frames for number in range(frames)]
    if isinstance(camera, OrbitCamera):
        return {"camera.azimuth": [camera.azimuth + angle for angle in degrees]}
    assert not isinstance(camera, FreeCamera)
    target = np.array(camera.target, np.float64)
    around = np.array([camera.eye], np.float64) - target
    return {"camera.eye": [(transformed(rotation(1, angle), around)[0] + target).tolist() for angle in degrees]}
