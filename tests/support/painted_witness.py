"""Witnesses put together by hand, of the example stage that reads and writes something of every kind."""

from typing import Any

import numpy as np
from example_stages import painted

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language.types import Array, Texture, mat3, vec2, vec3
from sss_ref.validation.witness.situation import Situation
from sss_ref.validation.witness.witness import DrawnValue, Witness

F = np.float32
PICTURE = np.arange(18, dtype=F).reshape(2, 3, 3)  # 3 texels wide, 2 high
READ = {"picture": {(1, 2), (0, 0), (0, 1)}, "material": {(1,)}, "number": {(0,), (2,)}}
GIVEN: dict[str, Any] = {
    "fragment_normal": vec3(F(0), F(0.25), F(1)),
    "fragment_uv": vec2(F(0.5), F(0.75)),  # of texel (1, 1)
    "triangle": 1,
    "coverage": True,
    "picture": Texture(PICTURE),
    "material": Array(F([[1, 2, 4], [8, 16, 32]])),
    "number": Array(np.int32([0, 1, 0])),
    "normal_from_model": mat3(np.arange(9).reshape(3, 3)),
    "flat": F(2),
    "inside": True,
}


def situation(**bounds: Any) -> Situation:
    """What the stage reads. bounds: of the parameters that are known no better."""
    return Situation(painted, GIVEN, GIVEN | bounds)


def painted_witness(output: str, got: Any, drawn: DrawnValue | None = None, **bounds: Any) -> Witness:
    """The witness of an output, which is a colour or a whole number, and of which this was drawn."""
    where = drawn or DrawnValue("camera", f"{output}_2", (7, 4))
    return Witness(situation(**bounds), output, np.array(got), where, PROFILES["ieee"])
