"""The exam of a draw of the mesh: its vertex stage, and what the rasterizer makes of it (rules R1 to R5)."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.interpret.work import uniform_value
from sss_ref.language.layout import CHANNELS
from sss_ref.language.pipeline import MESH_ATTRIBUTES, Pass
from sss_ref.numerics.inward import float32_within
from sss_ref.raster.interpolate import interpolate_arrays
from sss_ref.rendering.draw import varying_columns
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.acceptance import INTERPOLATION
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.rasterizer.candidates import FAR
from sss_ref.validation.accept.rasterizer.interpolation import interpolation_slack
from sss_ref.validation.accept.rasterizer.visible import Visible
from sss_ref.webgl.exams import WEBGL
from sss_ref.webgl.reference_draw import ReferenceDraw, reference_draw


@dataclass(frozen=True, eq=False)
class ExamOfDraw:
    """A draw of the mesh: what each pixel may show.

    covered: uint8 (H, W), `MUST_NOT` to `MUST`. first: int32 (H * W + 1), where the candidates of each pixel begin.
    triangle: int32 (M,), those that may be seen, by pixel. low, high: float32 (M, 1 + A), between these lie its depth,
    or in a layout its turn, and what is interpolated on it; the low above the high where nothing is right.
    varyings: name -> first column. reference: what the reference draws.
    """

    of: Pass
    covered: np.ndarray
    first: np.ndarray
    triangle: np.ndarray
    low: np.ndarray
    high: np.ndarray
    varyings: dict[str, int]
    reference: ReferenceDraw

    def inputs(self, oracle: Result) -> list[Any]:
        """What the vertex stage reads for every vertex: one value for each of its parameters."""
        (stage,), mesh = self.of.draw.vertex_stages, oracle.scene.mesh_of(self.of).attributes
        outside = {**oracle.scene.uniforms, **oracle.buffers}
        return [
            kind(*mesh[own].T) if own in MESH_ATTRIBUTES else uniform_value(kind, outside[stage.reads[own]])
            for own, kind in stage.parameters.items()
        ]


def exam_of_draw(oracle: Result, this_pass: Pass) -> ExamOfDraw:
    """The exam of a pass that draws a mesh. oracle: its rendering, with all buffers that the vertex stage reads."""
    visible = Case(oracle, Drawing(oracle.buffers), WEBGL).visible(this_pass)
    assert visible is not None
    found, columns = visible.found, varying_columns(this_pass)[0]
    depth = np.clip([found.low, found.high], 0.0, FAR)[..., None]
    low, high = float32_within(*np.concatenate([depth, _interpolated(visible, this_pass)], axis=-1))
    first = np.searchsorted(found.pixel, np.arange(visible.covered.size + 1)).astype(np.int32)
    varyings = {name: column + 1 for name, column in columns.items()}
    reference = reference_draw(oracle, this_pass)
    return ExamOfDraw(this_pass, visible.covered, first, visible.triangle, low, high, varyings, reference)


def _interpolated(visible: Visible, this_pass: Pass) -> np.ndarray:
    """The ends of what may be interpolated on each candidate, float64 (2, M, A); of those without area anything."""
    boxes, found = visible.boxes, visible.found
    row, column = np.divmod(found.pixel, visible.covered.shape[1])
    own = interpolate_arrays(boxes.primitives, found.piece, column, row, boxes.viewport.step)
    reach = np.empty(own.shape)
    for name, first in varying_columns(this_pass)[0].items():
        columns = slice(first, first + CHANNELS[this_pass.draw.varyings[name]])
        slack = interpolation_slack(boxes, found.piece, column, row, own[:, columns], columns)
        rounding = np.abs(own[:, columns].astype(np.float64)).max(axis=1, keepdims=True) * INTERPOLATION
        reach[:, columns] = slack + rounding
    reach[~boxes.drawable[found.piece]] = np.inf
    middle = np.nan_to_num(own.astype(np.float64))
    return np.stack([middle - reach, middle + reach])
