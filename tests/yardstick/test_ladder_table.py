"""The table of a ladder whose numbers are given."""

from dataclasses import replace

import pytest
from known_ladder import MASKS, known, off

from sss_ref.yardstick.ladder_table import as_markdown, rows

TABLE = """\
| technique | bias | rms | mean | 95 % | dE | dE 95 % | lit | dark | ms |
|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|
| noise of the truth | -1.0% | 2.0% | 1.0% | 3.0% | 4.0 | 8.0 | 2.0% | 3.0% |  |
| GPU against the oracle | -0.0% | 0.0% | 0.0% | 0.0% | 4.0 | 8.0 | 0.0% | 0.0% |  |
| burley, shipped | -25.0% | 50.0% | 25.0% | 75.0% | 4.0 | 8.0 | 50.0% | 75.0% | 12 |
| burley, fitted | -12.5% | 25.0% | 12.5% | 37.5% | 4.0 | 8.0 | 25.0% | 37.5% | 100 |
"""


@pytest.mark.parametrize("gpu", [True, False])
def test_a_row_for_the_noise_and_each_technique(gpu):
    lines = TABLE.splitlines(keepends=True)
    expected = TABLE if gpu else "".join(line for line in lines if "GPU" not in line)
    assert as_markdown(known(gpu)) == expected


def test_colours_that_are_not_known_are_left_out():
    without = known(gpu=False)
    without.__dict__["noise"] = {name: replace(off(0.25), bias=0.25) for name in MASKS}
    assert next(rows(without))[1:7] == ["+25.0%", "50.0%", "25.0%", "75.0%", "", ""]
