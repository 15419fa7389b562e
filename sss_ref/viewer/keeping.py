"""What the page saves: the scene file, the picture and the bundle, as the commands write them."""

import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sss_ref.bundle.writing import write_bundle
from sss_ref.pictures.png_file import image_encoding_of, write_png
from sss_ref.rendering.fold import render
from sss_ref.results.saving import preview
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.reading import Document
from sss_ref.viewer.dropped import FILE_KEYS
from sss_ref.viewer.studio import Studio

FILES = {  # what is asked for -> what the browser is told of the file
    "scene": {"name": "scene.toml", "type": "application/toml"},
    "picture": {"name": "image.png", "type": "image/png"},
    "bundle": {"name": "bundle.zip", "type": "application/zip"},
}


def kept_file(what: str, studio: Studio, data: Mapping[str, Any]) -> bytes:
    """A file of FILES for a scene. Raises as `load_scene` does."""
    scene = studio.scene(data)
    if what == "scene":
        return scene_text(data, studio.document).encode()
    return picture_file(scene) if what == "picture" else bundle_file(scene)


def scene_text(data: Mapping[str, Any], document: Document) -> str:
    """The scene file of these tables, which is the same scene wherever it is put.

    Files that the scene of the viewer names relative to itself are named by their whole path; a dropped file is named
    as it was dropped, for it goes beside the scene file.
    """
    import tomlkit

    return tomlkit.dumps(_placed(data, document.folder))


def picture_file(scene: Scene) -> bytes:
    """`image.png`, as `sss-ref render` writes it."""
    result = render(scene, keep=["image", "coverage"])
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "image.png"
        write_png(path, *preview(result), encode=image_encoding_of(scene.settings))
        return path.read_bytes()


def bundle_file(scene: Scene) -> bytes:
    """The folder of `sss-ref bundle`, as a ZIP file."""
    with tempfile.TemporaryDirectory() as folder:
        write_bundle(scene, Path(folder) / "bundle")
        return Path(shutil.make_archive(f"{folder}/packed", "zip", folder, "bundle")).read_bytes()


def _placed(value: Any, folder: Path) -> Any:
    """Tables and arrays whose files in `folder` are named by their whole path."""
    if isinstance(value, Mapping):
        return {
            key: str((folder / each).resolve()) if _is_file(key, each, folder) else _placed(each, folder)
            for key, each in value.items()
        }
    return [_placed(each, folder) for each in value] if isinstance(value, list) else value


def _is_file(key: str, value: Any, folder: Path) -> bool:
    return key in FILE_KEYS and isinstance(value, str) and (folder / value).exists()
