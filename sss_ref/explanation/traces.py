"""What is known of one pixel: passes, in them stages, and in those the steps that the interpreter traced."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sss_ref.explanation.places import Place
from sss_ref.interpret.trace import Bounds, Step
from sss_ref.language.stage import Stage


@dataclass(frozen=True)
class StageTrace:
    """A stage at one fragment or vertex.

    reads: name -> value, textures and uniform arrays included. writes: name -> value. at: which vertex, or "".
    bounds: name -> what a value that is read may be at least and at most on another processor, if that was asked for.
    """

    stage: Stage
    reads: Mapping[str, Any]
    steps: tuple[Step, ...]
    writes: Mapping[str, Any]
    at: str = ""
    bounds: Mapping[str, Bounds | None] = field(default_factory=dict)


@dataclass(frozen=True)
class Corner:
    """A corner of the piece that a fragment lies on: its weight, exact in float32 (rule R5), and its 1/w."""

    vertex: int
    weight: np.float32
    inverse_w: np.float32


@dataclass(frozen=True)
class TriangleTrace:
    """What a draw of the mesh gives a fragment; clipped: the corners are cut vertices and not the triangle's own."""

    triangle: int
    corners: tuple[Corner, ...]
    clipped: bool
    vertices: tuple[StageTrace, ...]  # the vertex stage at the corners of the triangle
    values: Mapping[str, Any]  # varyings, interpolated


@dataclass(frozen=True)
class PassTrace:
    """A pass at one pixel of its target. drawn: None for a rectangle. stages: empty where nothing is drawn."""

    name: str
    place: Place
    drawn: TriangleTrace | None
    stages: tuple[StageTrace, ...]
