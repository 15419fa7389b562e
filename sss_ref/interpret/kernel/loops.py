"""Stages as compiled kernels: all stages of a pass fused into one loop over the pixels of a band of rows.

The loop is written from the stages (source.py, lower.py) into a module of its own in the cache folder, so that its
machine code is kept between processes. Every output is written completely, background included.
"""

import hashlib
import importlib.util
import linecache
import os
import sys
from collections.abc import Iterable, Mapping
from concurrent.futures import Executor
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from sss_ref.cache.compiled import cache_folder
from sss_ref.interpret.kernel.canonical import canonical_names, canonical_work, renamed
from sss_ref.interpret.kernel.source import fragment_source, loose, packed, vertex_reads, vertex_source
from sss_ref.interpret.work import FLOAT32, Work
from sss_ref.language.pipeline import MESH_ATTRIBUTES, MeshDraw, Pass

BAND = 32  # rows a task


def run_vertices(
    this_pass: Pass,
    mesh: Mapping[str, np.ndarray],
    uniforms: Mapping[str, Any],
    varyings: Mapping[str, int],
    columns: int,
) -> tuple[np.ndarray, np.ndarray]:
    """Run the vertex stage of a pass: clip positions float32 (V, 4) and the wanted varyings, float32 (V, columns).

    mesh: vertex attribute -> float32 (V, C). uniforms: with the textures that the stage reads, as in `Work`.
    varyings: name -> first column.
    """
    assert isinstance(this_pass.draw, MeshDraw)
    count = len(mesh["position"])
    clip_position = np.empty((count, 4), FLOAT32)
    attributes = np.empty((count, columns), FLOAT32)
    reads = vertex_reads(this_pass.draw)
    loosely = [(mesh if name in MESH_ATTRIBUTES else uniforms)[name] for name in loose(reads, MESH_ATTRIBUTES)]
    given = [_pack(reads, MESH_ATTRIBUTES, uniforms), *loosely]
    canonical = renamed(this_pass, canonical_names(this_pass))
    module = _imported(vertex_source(canonical, varyings), f"{canonical.name}_vertices")
    module.vertices(*given, clip_position, attributes)
    return clip_position, attributes


def run_fragments(work: Work, pool: Executor | None) -> None:
    """Run the stages of a pass on all its fragments and fill its outputs, by bands of rows over the pool."""
    work = canonical_work(work)
    fragments, this_pass = work.fragments, work.this_pass
    source = fragment_source(this_pass, work.buffers, work.outputs, fragments.varyings)
    module = _imported(source, f"{this_pass.name}_fragments")
    mesh = [fragments.piece, fragments.primitives, fragments.step] if fragments.piece is not None else []
    rectangle = [] if fragments.stencil is None else [fragments.stencil]
    loosely = [
        (work.buffers if name in work.buffers else work.uniforms)[name] for name in loose(this_pass.reads, work.buffers)
    ]
    given: list[Any] = [*mesh, *rectangle, _pack(this_pass.reads, work.buffers, work.uniforms), *loosely]
    given += [*work.outputs.values(), np.concatenate([work.backgrounds[name] for name in work.outputs], dtype=FLOAT32)]

    def band(first_row: int) -> None:
        module.fragments(first_row, min(first_row + BAND, fragments.height), fragments.width, *given)

    for _ in (pool.map if pool else map)(band, range(0, fragments.height, BAND)):
        pass


def _pack(reads: Mapping[str, Any], buffers: Iterable[str], uniforms: Mapping[str, Any]) -> np.ndarray:
    """The argument `uniforms`: the packed ones, one after the other."""
    return np.concatenate([np.empty(0, FLOAT32), *(np.ravel(uniforms[name]) for name in packed(reads, buffers))])


@cache
def _imported(source: str, name: str) -> ModuleType:
    """The module of this source, from the cache folder if there is one."""
    module_name = f"sss_ref_{name}_{hashlib.sha256(source.encode()).hexdigest()[:16]}"
    folder = cache_folder()
    path = _written(folder / f"{module_name}.py", source) if folder else f"<{module_name}>"
    spec = importlib.util.spec_from_loader(module_name, loader=None, origin=str(path))
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    module.__file__ = str(path)
    linecache.cache[str(path)] = (len(source), None, source.splitlines(keepends=True), str(path))
    sys.modules[module_name] = module  # numba looks a cached function's module up by name
    exec(compile(source, str(path), "exec"), module.__dict__)
    return module


def _written(path: Path, source: str) -> Path:
    """The file, written whole if it is not there yet: numba drops its cache when a source file's time changes."""
    if not path.exists():
        part = path.with_suffix(f".{os.getpid()}.part")
        part.write_text(source)
        part.replace(path)
    return path
