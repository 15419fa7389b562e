"""manifest.json: all it takes to render a result again and to tell, if it differs, whose doing that is."""

import hashlib
import platform
import sys
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Annotated, Any, Final, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sss_ref.errors import DumpError
from sss_ref.errors.text_file import text_of
from sss_ref.errors.wording import told
from sss_ref.passes.buffers import described
from sss_ref.rendering.result import Result
from sss_ref.rendering.samples import SampledResult
from sss_ref.rules import RULES_VERSION
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.reading import folder_of
from sss_ref.scene_file.shipped import find_mesh

FILE_NAME = "manifest.json"
FORMAT: Final = "sss_ref result"
ROW_ORDER = {"npy": "bottom row first", "exr": "top row first", "png": "top row first"}

Sha256 = Annotated[str, Field(pattern="^[0-9a-f]{64}$")]


class Record(BaseModel):
    """Strict: a manifest that was edited by hand and no longer fits is reported, never guessed at."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True)


class BufferRecord(Record):
    """One buffer and the file it is in."""

    name: Annotated[str, Field(pattern="^[a-z0-9_]+$")]
    dtype: Annotated[str, Field(pattern="^(<f4|<i4|[|]u1)$")]
    shape: list[int]
    """[height, width] or [height, width, channels]."""
    unit: str
    background: float | list[float]
    """What stands where nothing is drawn, one value per channel."""
    sha256: Sha256
    """Rule A5."""
    file: str
    """Relative to the manifest."""
    row_order: str


class SceneRecord(Record):
    """The scene with every key filled, and the files it came from."""

    source: str
    mesh_file: str
    """Absolute path of the mesh when the scene was rendered."""
    texture_file: str | None = None
    """The same of the colour texture; None for a scene without."""
    other_files: dict[str, str] = {}
    """Key -> the same of any other file: mesh.normal_map, layers.0.path."""
    settings: dict[str, Any]


class Manifest(Record):
    """The whole file."""

    format: Literal["sss_ref result"]
    format_version: Literal[1]
    package_version: str
    rules_version: int
    scene: SceneRecord
    inputs: dict[str, Sha256]
    """Array of the mesh, or texels -> hash after decoding."""
    buffers: list[BufferRecord]
    """In stage order."""
    row_order: dict[str, str]
    """Kind of file -> which row comes first."""
    interpreter: str | None
    """None where the caller of `save` did not say."""
    threads: int | None
    """None: one per processor."""
    samples: Annotated[int, Field(ge=1)] = 1
    """n: the image is the average of n x n renderings (see `sss_ref.rendering.samples`)."""
    own_stages: list[str] = []
    """Stages that others ran in the place of (see `sss_ref.with_stage`), which no file can record."""
    milliseconds: dict[str, float]
    """Pass -> duration."""
    environment: dict[str, str]


def manifest_of(result: Result, interpreter: str | None, threads: int | None) -> Manifest:
    """The manifest of a rendering."""
    scene = result.scene
    return Manifest(
        format=FORMAT,
        format_version=1,
        package_version=package_version(),
        rules_version=RULES_VERSION,
        scene=_scene_record(scene),
        inputs=scene.input_hashes(),
        buffers=[_record(result, name) for name in result.buffers],
        row_order=ROW_ORDER,
        interpreter=interpreter,
        threads=threads,
        samples=result.samples if isinstance(result, SampledResult) else 1,
        own_stages=sorted(scene.own_stages),
        milliseconds={name: round(seconds * 1e3, 3) for name, seconds in result.timings.items()},
        environment=_environment(),
    )


@cache
def package_version() -> str:
    """The installed version; a checkout that is merely on the path has none."""
    try:
        return version("sss_ref")
    except PackageNotFoundError:
        return "not installed"


def scene_hash(scene: Scene) -> str:
    """SHA-256 in hexadecimal of a scene's resolved settings."""
    return hashlib.sha256(scene.settings.model_dump_json().encode()).hexdigest()


def read_manifest(folder: Path) -> Manifest:
    """The manifest of a result folder. Raises DumpError where there is none or it is damaged."""
    path = folder / FILE_NAME
    text = text_of(path, "a folder written by sss-ref render", DumpError)
    try:
        return Manifest.model_validate_json(text)
    except ValidationError as error:
        where = ".".join(map(str, error.errors()[0]["loc"])) or "file"
        expected, remedy = "what sss-ref render writes", "the manifest is damaged, render the scene again"
        raise DumpError(told(f"{path}: {where}", expected, "something else", remedy)) from None


def _record(result: Result, name: str) -> BufferRecord:
    buffer = result.buffers[name]
    return BufferRecord(
        name=name,
        dtype=buffer.dtype.newbyteorder("<").str,
        shape=list(buffer.shape),
        unit=described(name).unit,
        background=np.asarray(result.scene.clear(name)).tolist(),
        sha256=result.hashes[name],
        file=f"buffers/{name}.npy",
        row_order=ROW_ORDER["npy"],
    )


def _scene_record(scene: Scene) -> SceneRecord:
    """The scene, and where its loader found the mesh and the texture; the mesh as written if it is gone since."""
    named, texture = scene.settings.mesh.path, scene.settings.mesh.texture
    folder = folder_of(scene.source)
    others = {key: path for key, path in scene.settings.mesh.pictures.items() if key != "texture"}
    return SceneRecord(
        source=scene.source,
        mesh_file=_mesh_file(named, folder),
        texture_file=None if texture is None else str((folder / texture).absolute()),
        other_files={
            **{f"mesh.{key}": str((folder / path).absolute()) for key, path in others.items()},
            **{f"layers.{k}.path": _mesh_file(layer.path, folder) for k, layer in enumerate(scene.settings.layers)},
        },
        settings=scene.settings.model_dump(mode="json"),
    )


def _mesh_file(named: str, folder: Path) -> str:
    return str((find_mesh(named, folder) or Path(named)).absolute())


def _environment() -> dict[str, str]:
    versions = {name: version(name) for name in ("numpy", "numba", "llvmlite", "trimesh")}
    return {
        "python": platform.python_version(),
        **versions,
        "platform": platform.platform(),
        "byte_order": sys.byteorder,
    }
