"""Stages as compiled kernels: all stages of a pass fused into one loop over the pixels of a band of rows.

The loop is written from the stages (source.py, lower.py) into a module of its own in the cache folder, so that its
machine code is kept between processes. Every output is written completely, background included.
"""

import hashlib
import importlib.util
import linecache
import os
import sys
from collections.abc import Mapping
from concurrent.futures import Executor
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from sss_ref.cache.compiled import cache_folder
from sss_ref.interpret.kernel.arguments import OUT, Arguments, vertex_reads
from sss_ref.interpret.kernel.canonical import canonical_names, canonical_work, renamed
from sss_ref.interpret.kernel.source import fragment_source, vertex_source
from sss_ref.interpret.work import Work
from sss_ref.language.layout import FLOAT32
from sss_ref.language.pipeline import Pass

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
    rename = canonical_names(this_pass)
    canonical = renamed(this_pass, rename)
    (stage,), (canonical_stage,) = this_pass.draw.vertex_stages, canonical.draw.vertex_stages
    module = _imported(vertex_source(canonical, varyings), f"{canonical.name}_vertices")
    there = {**uniforms, **mesh}
    read = {rename(name): there[name] for name in vertex_reads(stage)}
    clip_position = np.empty((len(mesh["position"]), 4), FLOAT32)
    attributes = np.empty((len(mesh["position"]), columns), FLOAT32)
    filled = {"clip_position": clip_position, "attributes": attributes}
    Arguments.of_vertices(canonical_stage).bound(module.vertices, read, filled)()
    return clip_position, attributes


def run_fragments(work: Work, pool: Executor | None) -> None:
    """Run the stages of a pass on all its fragments and fill its outputs, by bands of rows over the pool."""
    work = canonical_work(work)
    fragments, this_pass = work.fragments, work.this_pass
    source = fragment_source(this_pass, work.buffers, work.outputs, fragments.varyings)
    module = _imported(source, f"{this_pass.name}_fragments")
    own = {
        "width": fragments.width,
        "piece": fragments.piece,
        "primitives": fragments.primitives,
        "step": fragments.step,
        "stencil": fragments.stencil,
        "background": np.concatenate([work.backgrounds[name] for name in work.outputs], dtype=FLOAT32),
        **{OUT + name: buffer for name, buffer in work.outputs.items()},
    }
    arguments = Arguments.of_fragments(this_pass, work.buffers, work.outputs)
    fill = arguments.bound(module.fragments, {**work.uniforms, **work.buffers}, own)

    def band(first_row: int) -> None:
        fill(row0=first_row, row1=min(first_row + BAND, fragments.height))

    for _ in (pool.map if pool else map)(band, range(0, fragments.height, BAND)):
        pass


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
