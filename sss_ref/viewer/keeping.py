"""What the page saves: the scene file, the picture and the bundle, as the commands write them."""

import shutil
import tempfile
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

from sss_ref.bundle.writing import write_bundle
from sss_ref.pictures.png_file import image_encoding_of, write_png
from sss_ref.rendering.fold import render
from sss_ref.results.saving import preview
from sss_ref.scene.scene import Scene
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
        return scene_text(data, studio.document.folder, studio.files.names()).encode()
    return picture_file(scene) if what == "picture" else bundle_file(scene)


def scene_text(data: Mapping[str, Any], folder: Path, dropped: Collection[str]) -> str:
    """The scene file of these tables, which is the same scene wherever it is put.

    Files that lie in the folder of the viewer's scene are named by their whole path. A dropped file is named as it was
    dropped, for it goes beside the scene file.
    """
    import tomlkit

    return tomlkit.dumps(_placed(data, folder, dropped))


def picture_file(scene: Scene) -> bytes:
    """`image.png`, as `sss-ref render` writes it."""
    result = render(scene, keep={"image", "coverage"} & set(scene.method.values))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "image.png"
        write_png(path, *preview(result), encode=image_encoding_of(scene.settings))
        return path.read_bytes()


def bundle_file(scene: Scene) -> bytes:
    """The folder of `sss-ref bundle`, as a ZIP file."""
    with tempfile.TemporaryDirectory() as folder:
        write_bundle(scene, Path(folder) / "bundle")
        return Path(shutil.make_archive(f"{folder}/packed", "zip", folder, "bundle")).read_bytes()


def _placed(value: Any, folder: Path, dropped: Collection[str]) -> Any:
    """Tables and arrays whose files in `folder` are named by their whole path."""
    if isinstance(value, Mapping):
        return {key: _file_or(key, each, folder, dropped) for key, each in value.items()}
    return [_placed(each, folder, dropped) for each in value] if isinstance(value, list) else value


def _file_or(key: str, value: Any, folder: Path, dropped: Collection[str]) -> Any:
    if key in FILE_KEYS and isinstance(value, str) and value not in dropped and (folder / value).exists():
        return str((folder / value).resolve())
    return _placed(value, folder, dropped)
