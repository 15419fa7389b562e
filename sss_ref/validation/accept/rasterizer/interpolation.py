"""How far apart right processors may interpolate: on a triangle as it is, or as they have snapped it (rule R5)."""

import numpy as np

from sss_ref.validation.accept.rasterizer.boxes import Boxes

NEXT, LAST = [1, 2, 0], [2, 0, 1]  # the corners of the edge opposite to each


def interpolation_slack(
    boxes: Boxes, piece: np.ndarray, column: np.ndarray, row: np.ndarray, interpolated: np.ndarray, columns: slice
) -> np.ndarray:
    """How far from its interpolated attributes (N, A) a fragment may have them, float64 (N, A).

    piece, column, row: integers (N,). columns: those of `primitives.attributes`.
    With weights E_i that may be off by D_i, a = sum(E_i*a_i) / sum(E_i) is off by at most
    sum(D_i*|a_i - a|) / (sum(E_i) - sum(D_i)); infinite on slivers where that is not above 0. A processor that
    interpolates a/w and 1/w on planes rounds either, by as much as they change across the picture, and on slivers
    that is more than a changes.
    """
    primitives = boxes.primitives
    corners = primitives.corners[piece].T
    inverse_w = primitives.inverse_w[corners].astype(np.float64)
    edge, off_edge, rounding = _edges(boxes, piece, np.stack([column, row], axis=-1))
    weight, change = edge * inverse_w, (off_edge + np.abs(edge) * boxes.weight_error[corners]) * inverse_w
    lost = rounding * np.ptp(inverse_w, axis=0)
    least = (np.abs(weight.sum(axis=0)) - change.sum(axis=0) - lost)[:, None]

    own, attributes = interpolated.astype(np.float64), primitives.attributes[corners, columns].astype(np.float64)
    off = (change[..., None] * np.abs(attributes - own)).sum(axis=0)
    off += rounding[:, None] * np.ptp(attributes * inverse_w[..., None], axis=0) + lost[:, None] * np.abs(own)
    with np.errstate(divide="ignore", invalid="ignore"):
        slack = np.where(least > 0, off / least, np.inf)
    return slack + boxes.attribute_error[corners, columns].max(axis=0)


def _edges(boxes: Boxes, piece: np.ndarray, sample: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The edge functions of pieces at samples (N, 2) and how far they may be off, float64 (3, N), and a rounding (N,).

    That is how far a plane is rounded that changes by 1 over the piece, times twice the piece's area.
    """
    corners = boxes.primitives.corners[piece].T
    x, y = np.moveaxis(boxes.primitives.snapped[corners] / boxes.viewport.step - sample, -1, 0)
    off_x, off_y = np.moveaxis(boxes.off[corners], -1, 0)
    change = np.abs(x[NEXT]) * off_y[LAST] + np.abs(y[LAST]) * off_x[NEXT] + off_x[NEXT] * off_y[LAST]
    change += np.abs(x[LAST]) * off_y[NEXT] + np.abs(y[NEXT]) * off_x[LAST] + off_x[LAST] * off_y[NEXT]
    moved_x, moved_y = boxes.rounding[piece].T
    return x[NEXT] * y[LAST] - x[LAST] * y[NEXT], change, moved_x * np.ptp(y, axis=0) + moved_y * np.ptp(x, axis=0)
