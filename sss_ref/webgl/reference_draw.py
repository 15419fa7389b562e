"""What the reference's own draw of a pass gives its stages."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sss_ref.interpret.arrays import draw_values
from sss_ref.interpret.work import Work, store
from sss_ref.language.layout import dtype_of, shape_of
from sss_ref.language.pipeline import Pass
from sss_ref.rendering.draw import Machine, draw, varying_columns
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.known import pixels_of
from sss_ref.webgl.varyings_shader import DEPTH, TRIANGLE


@dataclass(frozen=True, eq=False)
class ReferenceDraw:
    """The draw of a pass.

    where: bool (H, W), the pixels that hold a fragment. varyings: name -> what is interpolated there, (H, W) or
    (H, W, C), 0 elsewhere; empty for a rectangle. written: what a mesh's draw shows, (H, W): `TRIANGLE` and, but for a
    layout, `DEPTH`.
    """

    where: np.ndarray
    varyings: Mapping[str, np.ndarray]
    written: Mapping[str, np.ndarray]


def reference_draw(oracle: Result, this_pass: Pass) -> ReferenceDraw:
    """The draw of a pass. oracle: a rendering with all buffers that the draw reads."""
    sketch = draw(oracle.scene, this_pass, oracle.buffers, Machine())
    fragments = sketch.fragments
    if not this_pass.draw.vertex_stages:
        return ReferenceDraw(fragments.where, {}, {})
    kinds = {name: this_pass.draw.varyings[name] for name in varying_columns(this_pass)[0]}
    size = fragments.width, fragments.height
    varyings = {name: np.zeros(shape_of(kind, *size), dtype_of(kind)) for name, kind in kinds.items()}
    at = pixels_of(fragments.where)
    values = draw_values(Work(this_pass, fragments, oracle.scene.uniforms, {}, {}, {}), *at)
    for name, buffer in varyings.items():
        store(buffer, *at, values[name])
    primitives, piece = fragments.of_mesh
    triangle = np.where(piece >= 0, primitives.triangle[piece], np.int32(-1)).astype(np.int32)
    depth = {} if this_pass.draw.layout else {DEPTH: sketch.written[this_pass.draw.depth]}
    return ReferenceDraw(fragments.where, varyings, {TRIANGLE: triangle, **depth})
