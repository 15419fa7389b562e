"""Elements side by side, as blocks and as text."""

import pytest

from sss_ref.validation.witness.element_runs import blocks_in, blocks_of, blocks_text, runs_of


@pytest.mark.parametrize(
    ("elements", "text"),
    [
        ({(0, 3), (0, 4), (1, 3), (1, 4), (2, 4)}, "3,0*2x2 4,2*1x1"),
        ({(5,), (6,), (7,), (9,)}, "5*3 9*1"),
        ({(1, 1), (2, 1), (3, 1)}, "1,1*1x3"),
        (set(), ""),
    ],
)
def test_blocks_as_text_and_back(elements, text):
    blocks = blocks_of(elements)
    assert blocks_text(blocks) == text
    assert blocks_in(text) == blocks


def test_runs_go_row_by_row():
    assert list(runs_of({(1, 2), (0, 5), (1, 3), (0, 7)})) == [((0, 5), 1), ((0, 7), 1), ((1, 2), 2)]
