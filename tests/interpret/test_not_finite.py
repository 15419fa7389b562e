from typing import NamedTuple

import numpy as np
import pytest

from sss_ref.interpret import arrays
from sss_ref.interpret.not_finite import not_finite
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language import Texture, ivec2, sqrt, stage, texel, vec3
from sss_ref.language.pipeline import Pass, ScreenDraw


class Halved(NamedTuple):
    halved: float


@stage(source="a test")
def halve(value: float) -> Halved:
    return Halved(value * 0.5)


class Root(NamedTuple):
    root: float
    colour: vec3


@stage(source="a test")
def take_root(halved: float, tint: vec3, picture: Texture[float], pixel: ivec2) -> Root:
    """Not a number where the value or the picture is negative; the picture is no input that a message can show."""
    root = sqrt(halved)
    return Root(root, tint * (root + sqrt(texel(picture, pixel))))


def work_on(values):
    """A rectangle of the two stages over a buffer `value`, run."""
    values = np.array(values, np.float32)
    height, width = values.shape
    uniforms = {"tint": np.float32([1.5, 2, -4])}
    outputs = {"root": np.empty((height, width), np.float32), "colour": np.empty((height, width, 3), np.float32)}
    backgrounds = {"root": np.zeros(1, np.float32), "colour": np.zeros(3, np.float32)}
    one = Pass("both", "camera", ScreenDraw(), (halve, take_root))
    buffers = {"value": values, "picture": np.ones_like(values)}
    work = Work(one, Fragments(width, height), uniforms, buffers, outputs, backgrounds)
    arrays.run_fragments(work, None)
    return work


@pytest.mark.parametrize(("value", "shown"), [(-8.0, "-4.0"), (np.nan, "nan"), (-np.inf, "-inf"), (-1e-38, "-5e-39")])
def test_the_message_names_stage_pixel_and_inputs(value, shown):
    """The first pixel in rows from the bottom up, the first stage whose result is not finite."""
    error = not_finite(work_on([[1.0, 2.0, 3.0], [4.0, 5.0, value], [value, 1.0, 1.0]]))
    first = "halve" if not np.isfinite(value) else "take_root"
    inputs = f"value = {value}" if first == "halve" else f"halved = {shown}, tint = 1.5 2.0 -4.0, pixel = 2 1"
    assert str(error) == f"stage {first}, pixel 2,1: result is not finite; inputs: {inputs}"


def test_a_buffer_that_its_stages_do_not_explain_is_named():
    work = work_on([[1.0, 2.0]])
    work.outputs["colour"][0, 1, 2] = np.inf
    assert str(not_finite(work)) == "pass both, pixel 1,0: buffer colour is not finite"
