"""transforms.json: the cameras of a batch's pictures in the form that nerfstudio reads, with the light of each.

Its conventions (docs.nerf.studio, Data conventions): +Z of the world is up; of a camera +X is right, +Y up, and it
looks along -Z; a pixel's ray goes through its middle, at (column + 0.5, row + 0.5), row 0 at the top.
"""

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np
from pydantic import TypeAdapter

from sss_ref.batch.item_folder import item_folder, read_record
from sss_ref.batch.plan import Shard
from sss_ref.batch.workshop import ItemOutcome
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import write_text
from sss_ref.errors.wording import told
from sss_ref.scene_file.viewpoints import Camera
from sss_ref.view.matrices import Matrix, Vector, length, product, transformed
from sss_ref.view.views import View, camera_view

Z_UP: Final = np.array([[1.0, 0, 0, 0], [0, 0, -1.0, 0], [0, 1.0, 0, 0], [0, 0, 0, 1.0]])  # from our world, where Y is
CAMERA = TypeAdapter[Camera](Camera)
ARCHIVES = ("buffers.npz", "buffers.exr")
UNDISTORTED = dict.fromkeys(("k1", "k2", "p1", "p2"), 0.0)


def write_transforms(folder: Path, outcomes: Iterable[ItemOutcome], shard: Shard) -> Path:
    """Write the cameras of the items that did not fail into a batch's folder. Raises DumpError for one without lens."""
    frames = [_frame(folder, each) for each in outcomes if each.state != "failed"]
    shared = _shared(frames)
    table = {
        "camera_model": "OPENCV",
        **UNDISTORTED,
        **shared,
        "applied_transform": Z_UP[:3].tolist(),
        "frames": [{key: value for key, value in frame.items() if key not in shared} for frame in frames],
    }
    path = folder / f"transforms{shard.suffix}.json"
    write_text(path, json.dumps(table, indent=1) + "\n", DumpError)
    return path


def intrinsics(view: View) -> dict[str, float]:
    """Size, focal lengths and principal point, pixels; a pixel is a square."""
    focal = view.height / view.lens.height_at_1
    middle = {"cx": view.width / 2, "cy": view.height / 2}
    return {"w": view.width, "h": view.height, "fl_x": focal, "fl_y": focal, **middle}


def world_from_camera(view: View) -> Matrix:
    """4 x 4, of a world where +Z is up: its columns are the camera's +X, +Y and +Z, and where it is."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = view.view[:3, :3].T, view.eye
    return product(Z_UP, matrix)


def _frame(folder: Path, outcome: ItemOutcome) -> dict[str, Any]:
    """What is told of an item; a reader of nerfstudio's form passes over item, buffers_path and lights."""
    place = item_folder(folder, outcome.name)
    record = read_record(place)
    assert record  # it did not fail
    view = camera_view(CAMERA.validate_python(record.settings["camera"]))
    if view.lens.is_parallel:
        came = 'one of type "orthographic"'
        raise DumpError(told(f"item {outcome.item}: camera", "one with a perspective", came, "set cameras = false"))
    relative = place.relative_to(folder).as_posix()
    archives = [f"{relative}/{name}" for name in ARCHIVES if (place / name).is_file()]
    return {
        "file_path": f"{relative}/image.png",
        "transform_matrix": world_from_camera(view).tolist(),
        **intrinsics(view),
        "item": outcome.item,
        **({"buffers_path": archives[0]} if archives else {}),
        "lights": [_light(each) for each in record.settings["lights"]],
    }


def _light(settings: Mapping[str, Any]) -> dict[str, Any]:
    """A light in the world of the cameras. settings: with its position and target."""
    position, target = (_z_up(np.array(settings[key], np.float64)) for key in ("position", "target"))
    place = {} if settings["type"] == "directional" else {"position": position.tolist()}
    towards = ((position - target) / length(position - target)).tolist()
    return {
        "type": settings["type"],
        "towards": towards,
        **place,
        **{key: settings[key] for key in ("color", "intensity")},
    }


def _z_up(point: Vector) -> Vector:
    found: Vector = transformed(Z_UP, point[None])[0]
    return found


def _shared(frames: list[dict[str, Any]]) -> dict[str, float]:
    """The size and lens of all frames, if they have the same."""
    keys = ("w", "h", "fl_x", "fl_y", "cx", "cy")
    first = {key: frames[0][key] for key in keys} if frames else {}
    return first if all(frame[key] == first[key] for frame in frames for key in keys) else {}
