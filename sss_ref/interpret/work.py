"""What an interpreter is handed: a pass, what it reads, the fragments of its draw, and the buffers to fill."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, get_origin

import numpy as np

from sss_ref.language.layout import CHANNELS
from sss_ref.language.pipeline import Pass
from sss_ref.language.types import Array, Texture, Vector, components, mat3, mat4
from sss_ref.raster.primitives import Primitives


@dataclass(frozen=True)
class Fragments:
    """The pixels on which a pass runs its stages.

    primitives, piece, step: of a draw of the mesh (piece int32 (H, W), -1 where none); None for a rectangle.
    varyings: varying -> its first column in primitives.attributes.
    stencil: uint8 (H, W), the rectangle's limit, or None.
    """

    width: int
    height: int
    primitives: Primitives | None = None
    piece: np.ndarray | None = None
    step: int = 1
    varyings: Mapping[str, int] = field(default_factory=dict)
    stencil: np.ndarray | None = None

    @property
    def of_mesh(self) -> tuple[Primitives, np.ndarray]:
        """The pieces of the mesh, and which of them each pixel shows; only of a draw of the mesh."""
        assert self.primitives is not None and self.piece is not None
        return self.primitives, self.piece

    @property
    def where(self) -> np.ndarray:
        """Bool (H, W): which pixels hold a fragment."""
        if self.piece is not None:
            return self.piece >= 0
        return np.ones((self.height, self.width), bool) if self.stencil is None else self.stencil != 0

    def among(self, chosen: np.ndarray) -> "Fragments":
        """Those of them that are among some pixels, bool (H, W)."""
        if self.piece is not None:
            return replace(self, piece=np.where(chosen, self.piece, np.int32(-1)))
        return replace(self, stencil=self.where & chosen)


@dataclass(frozen=True)
class Work:
    """One pass to run.

    uniforms: name -> float32 scalar, int, or array (vectors (N,), matrices (N, N), uniform arrays (N,) or (N, C),
        textures (H, W, C)), float32 or, for integers, int32.
    buffers: name -> finished buffer of an earlier pass, (H, W) or (H, W, C).
    outputs: name -> array to fill. backgrounds: name -> one value per channel for the pixels without a fragment, where
        a name that is left out keeps what it has.
    handed_on: name -> array, (H, W) or (H, W, C), that stages read in place of what one before them in the pass gives.
    """

    this_pass: Pass
    fragments: Fragments
    uniforms: Mapping[str, Any]
    buffers: Mapping[str, np.ndarray]
    outputs: Mapping[str, np.ndarray]
    backgrounds: Mapping[str, np.ndarray]
    handed_on: Mapping[str, np.ndarray] = field(default_factory=dict)


def uniform_value(kind: Any, raw: Any) -> Any:
    """A uniform as a value of the language."""
    if get_origin(kind) in (Array, Texture):
        return get_origin(kind)(raw)
    if kind in (mat3, mat4):
        return kind(raw)
    if isinstance(kind, type) and issubclass(kind, Vector):
        return kind(*map(np.float32, raw))
    return np.float32(raw) if kind is float else kind(raw)


def buffer_value(kind: Any, buffer: np.ndarray, rows: np.ndarray, columns: np.ndarray) -> Any:
    """A buffer as a value of the language: whole as a Texture, else the values at these pixels."""
    if get_origin(kind) is Texture:
        return Texture(buffer)
    values = buffer[rows, columns]
    if kind is bool:
        return values != 0
    return kind(*values.T) if CHANNELS[kind] > 1 else values


def store(buffer: np.ndarray, rows: np.ndarray, columns: np.ndarray, value: Any) -> None:
    """Write a value of the language into a buffer at these pixels."""
    for channel, component in enumerate(components(value)):
        at = (rows, columns) if buffer.ndim == 2 else (rows, columns, channel)
        buffer[at] = component
