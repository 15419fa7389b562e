"""Where pictures are made: what all pages share, and what runs beside the server's own thread."""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

from sss_ref.errors import MeshError, SceneError
from sss_ref.explanation.explain import explain
from sss_ref.explanation.page import html
from sss_ref.explanation.rows import sections
from sss_ref.mesh.triangles import Mesh
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene, read_mesh, scene_of
from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.layers import overridden
from sss_ref.scene_file.reading import Document, opened
from sss_ref.view.views import camera_view, light_of
from sss_ref.viewer import steering
from sss_ref.viewer.draft import Pace, draft_settings
from sss_ref.viewer.dropped import DroppedFiles
from sss_ref.viewer.session import plain
from sss_ref.viewer.shown import needed, pass_of, pixels_of

MESHES = 4  # that are kept in memory
FEW_PIXELS = 256  # a side: so small a picture is drawn sooner by one thread than shared among several


class Superseded(Exception):
    """What is being drawn is out of date."""


@dataclass(frozen=True)
class Order:
    """A picture that is wanted. data: the scene; buffer: what of it; is_draft: whether a small picture will do."""

    data: Mapping[str, Any]
    buffer: str
    is_draft: bool


@dataclass(frozen=True)
class DrawnPicture:
    """A picture and what the page is told with it. pixels: sRGB with alpha, row by row from the top."""

    scene: Scene
    facts: dict[str, Any]
    pixels: bytes


def starting_point(scene: str, overrides: Mapping[str, Any]) -> Document:
    """What the viewer starts with: the document of a scene, as `load_scene` takes it, with overrides laid on it.

    Raises as `load_scene` does.
    """
    load_scene(scene, **overrides)
    document = opened(scene)
    data, _ = overridden(document.data, overrides)
    return replace(document, data=plain(data))


class Studio:
    """Draws what pages ask for. document: the scene that the viewer was started with; files: what was dropped."""

    def __init__(self, document: Document, files: DroppedFiles) -> None:
        self.document, self.files, self.pace = document, files, Pace()
        self._meshes = lru_cache(MESHES)(lambda path, changed, unwrap, tangents: read_mesh(path, unwrap, tangents))

    def scene(self, data: Mapping[str, Any]) -> Scene:
        """The scene of these tables. Raises as `load_scene` does; dropped files are called by their names."""
        try:
            located = self.files.located(data, self.document.data)
            return scene_of(replace(self.document, data=located), {}, self._read)
        except (SceneError, MeshError) as error:
            raise type(error)(self.files.named(str(error))) from None

    def picture(self, order: Order, is_stale: Callable[[], bool]) -> DrawnPicture:
        """Draw what is ordered. Raises Superseded as soon as `is_stale`, which a draft never is."""

        def go_on(_: str) -> None:
            if is_stale():
                raise Superseded

        start = time.perf_counter()
        scene = self.scene(order.data)
        drawn = smaller(scene, self.pace.side) if order.is_draft else scene
        name = order.buffer if order.buffer in drawn.method.values else "image"
        threads = 1 if max(drawn.settings.camera.width, drawn.settings.camera.height) <= FEW_PIXELS else None
        result = render(drawn, threads=threads, keep=needed(drawn, name), on_pass=go_on)
        pixels, facts = pixels_of(result, name)
        seconds = time.perf_counter() - start
        if drawn is not scene:
            self.pace.took(seconds)
        told: dict[str, Any] = {
            **facts,
            "kind": "picture",
            "buffer": name,
            "ofCamera": pass_of(drawn, name).target == "camera",
            "draft": drawn is not scene,
            "width": pixels.shape[1],
            "height": pixels.shape[0],
            "hash": None if drawn is not scene else result.hashes[name],
            "ms": round(seconds * 1e3),
            "notes": [*scene.warnings, *result.notes],
            **places_of(scene),
            "values": self.files.by_name(scene.settings.model_dump(mode="json")),
            "given": order.data,
            "passes": [{"name": each.name, "buffers": [*each.values]} for each in drawn.method.passes],
        }
        return DrawnPicture(scene, told, pixels.tobytes())

    def explanation(self, data: Mapping[str, Any], pixel: tuple[int, int]) -> dict[str, Any]:
        """What `explain` says of a pixel, as HTML."""
        told = explain(self.scene(data), pixel)
        return {"kind": "explanation", "pixel": pixel, "html": html(sections(told.passes))}

    def _read(self, path: Path, unwrap: bool, tangents: bool) -> Mesh:
        changed = path.stat().st_mtime_ns
        mesh: Mesh = self._meshes(path, changed, unwrap, tangents)
        return mesh


def smaller(scene: Scene, side: int) -> Scene:
    """A scene whose picture has at most `side` pixels a side, its maps as much smaller; itself where it is that small.

    It is framed and lit as the scene is, since nothing is fitted anew.
    """
    settings = draft_settings(scene.settings, side)
    if settings is scene.settings:
        return scene
    lights = tuple(light_of(light, settings.shadow_map) for light in settings.lights)
    return replace(scene, settings=settings, camera=camera_view(settings.camera), lights=lights)


def places_of(scene: Scene) -> dict[str, Any]:
    """The whole picture's width and height, and where in it the lights' handles are."""
    bounds = PlacedMesh(scene.mesh, scene.world_from_model).bounds
    return {
        "size": [scene.settings.camera.width, scene.settings.camera.height],
        "handles": [steering.handle(light.position, scene.camera, bounds) for light in scene.lights],
    }
