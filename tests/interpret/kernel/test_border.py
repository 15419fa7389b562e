"""Dilation on the border of the charts: the bits of array code, which runs it on every texel."""

import numpy as np
import pytest
from one_stage import assert_same_bits

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips
from sss_ref.interpret.kernel.border import border, is_dilation
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language import Texture, vec2
from sss_ref.language.pipeline import Pass, ScreenDraw
from sss_ref.passes import blur
from sss_ref.passes.irradiance import dilate

FEEDBACK = {"irradiance": "irradiance_filled", "irradiance_mask": "irradiance_filled_mask"}


def neighbours(mask, row, column):
    """The value of the mask at the eight neighbours that there are."""
    rows, columns = range(max(row - 1, 0), row + 2), range(max(column - 1, 0), column + 2)
    inside = ((r, c) for r in rows for c in columns if r < mask.shape[0] and c < mask.shape[1])
    return [mask[at] for at in inside if at != (row, column)]


@pytest.mark.parametrize("share", [0.0, 0.02, 0.3, 1.0])
def test_the_border_is_beside_the_mask_and_not_in_it(share):
    mask = (np.random.default_rng(3).random((9, 7)) < share).astype(np.uint8)
    expected = [[not mask[r, c] and any(neighbours(mask, r, c)) for c in range(7)] for r in range(9)]
    assert border(mask, slice(0, 9)).tolist() == expected
    assert np.concatenate([border(mask, slice(k, k + 3)) for k in (0, 3, 6)]).tolist() == expected


@pytest.mark.parametrize("wanted", [FEEDBACK.values(), ["irradiance_filled_mask"]], ids=len)
@pytest.mark.parametrize("channels", [2, 3])
@pytest.mark.parametrize("share", [0.0, 0.001, 0.5, 1.0])
def test_rounds_have_the_bits_of_rounds_on_every_texel(share, channels, wanted):
    rng = np.random.default_rng(4)
    stage = dilate if channels == 3 else dilate.retyped(irradiance=Texture[vec2], irradiance_filled=vec2)
    one = Pass("fill", "", ScreenDraw(), (stage,), rounds=4, feedback=FEEDBACK)
    there = {
        "irradiance": rng.random((70, 65, channels), np.float32),
        "irradiance_mask": (rng.random((70, 65)) < share).astype(np.uint8),
    }
    found = []
    for interpreter in (strips, arrays):

        def one_round(read, run=interpreter.run_fragments):
            outputs = {FEEDBACK[name]: np.full_like(read[name], 9) for name in FEEDBACK if FEEDBACK[name] in wanted}
            clear = {own: np.zeros(buffer.shape[2:] or 1, buffer.dtype) for own, buffer in outputs.items()}
            run(Work(one, Fragments(65, 70), {}, read, outputs, clear), None)
            return outputs

        found.append(one.folded(there, one_round) if len(wanted) == 2 else one_round(there))
    assert_same_bits(*found)


def test_another_stage_in_its_place_runs_on_every_texel():
    assert is_dilation(Pass("fill", "", ScreenDraw(), (dilate,), feedback=FEEDBACK))
    assert not is_dilation(Pass("fill", "", ScreenDraw(), (blur.scatter,), feedback=FEEDBACK))
    assert not is_dilation(Pass("fill", "", ScreenDraw(), (dilate,)))
