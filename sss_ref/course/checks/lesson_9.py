"""The exercises of lesson 9: validate your shader."""

import difflib
import hashlib
from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called
from sss_ref.course.checks.fragments import COUNT, fragments
from sss_ref.course.checks.kinds import Kind, described
from sss_ref.course.checks.written_shaders import compared_glsl
from sss_ref.course.checks.written_stages import compared
from sss_ref.methods.stages import all_stages
from sss_ref.passes.irradiance import irradiance_lambert

RIGHT = {
    "A": "dde60d82411ff582",
    "B": "92704bd87cc39949",
    "C": "a9ea26807e28afc2",
}  # dump -> the hash of its name and of the stage that is wrong in it


def wrong_stages(answer: Any) -> None:
    """A line: the stage that is wrong in each of the dumps A, B and C; None for the one that is right."""
    got = called(answer, Kind("a dict of A, B and C", _dict, numeric=False))
    for name, right in RIGHT.items():
        if name not in got:
            raise NotYet(f"nothing is said of {name}.")
        _check_stage(name, got[name])
        if fingerprint(name, got[name]) == right:
            continue
        if right == fingerprint(name, None):
            raise NotYet(f"{name} has other bits than the oracle. Could a right processor have them?")
        if got[name] is None:
            raise NotYet(f"{name} looks right. Give `sss_ref.validate` its buffers.")
        raise NotYet(f"{got[name]} is not what is wrong in {name}: did it make a mistake, or was it given one?")


def _dict(value: Any) -> dict[Any, Any] | None:
    return value if isinstance(value, dict) else None


def fingerprint(dump: str, stage: str | None) -> str:
    """What stands for an answer here, where a reader may look."""
    return hashlib.sha256(f"{dump}: {stage}".encode()).hexdigest()[:16]


def _check_stage(dump: str, named: Any) -> None:
    """Raise NotYet unless it is None or the name of a stage."""
    if named is None or (isinstance(named, str) and named in all_stages()):
        return
    if not isinstance(named, str):
        raise NotYet(f"for {dump} you say {described(named)}, where a stage's name or None is expected.")
    found = difflib.get_close_matches(named, all_stages(), n=1)
    what = f"did you mean {found[0]}?" if found else "the report of `sss_ref.validate` has their names."
    raise NotYet(f"no stage is called {named[:40]!r}: {what}")


def mended_lambert(answer: Any) -> None:
    """A stage: Lambert's law with the shadow map, freed of two mistakes."""
    hint = "One mistake is in the direction, the other in what a fragment gets that lies in shadow, or outside the map."
    compared(answer, irradiance_lambert, fragments(9), hint)


def mended_srgb_in_glsl(answer: Any) -> None:
    """A shader: a linear value encoded for a screen (sRGB, IEC 61966-2-1), freed of two mistakes."""
    linear = np.r_[np.linspace(0, 0.01, COUNT // 2), np.linspace(0.02, 1, COUNT // 2)]
    expected = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)
    hint = "Draw both branches: they have to meet, and 1 has to stay 1."
    compared_glsl(answer, "float encoded(float linear)", {"linear": linear}, expected, hint, within=1e-3)
