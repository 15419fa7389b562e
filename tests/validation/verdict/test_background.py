"""What stands where nothing is drawn, on buffers put together by hand."""

import numpy as np
from checked import check_of

from sss_ref.validation.verdict.background import background_of, outside_and_wrong

OUTSIDE = np.array([[True, True, False], [True, True, False]])
EXPECTED = np.float32([[1, 1, 5], [1, 1, 5]])


def found(got, **others):
    return background_of(check_of(EXPECTED, got, **{"outside": OUTSIDE} | others))


def test_a_right_background_is_none():
    assert found([[1.0, 1, 7], [1, 1, 7]]) is None and found([[2.0] * 3] * 2, outside=None) is None
    assert not outside_and_wrong(check_of(EXPECTED, EXPECTED + 1)).any()


def test_it_is_told_with_its_first_pixel_and_its_share():
    uniform = found([[1.0, 3, 7], [3, 3, 7]])
    assert (uniform.compared, uniform.wrong, uniform.at, uniform.uniform) == (4, 3, (1, 0), True)
    assert str(uniform) == "where nothing is drawn 3.0 stands, expected 1.0, on 3 of these 4 pixels"
    several = found([[1.0, 1, 7], [4, 3, 7]])
    where = "at pixel 0,1 and other values elsewhere"
    assert str(several) == f"where nothing is drawn 4.0 stands {where}, expected 1.0, on 2 of these 4 pixels"


def test_what_is_within_reach_is_right():
    got = [[1.5, 1.75, 5], [np.nan, 1, 5]]
    wrong = outside_and_wrong(check_of(EXPECTED, got, reach=0.5, outside=OUTSIDE))
    assert wrong.tolist() == [[False, True, False], [True, False, False]]


def test_one_wrong_channel_is_enough():
    colours = np.zeros((1, 2, 3), np.float32)
    got = colours.copy()
    got[0, 1, 2] = 1
    told = background_of(check_of(colours, got, outside=np.array([[True, True]])))
    assert told.at == (1, 0) and told.got == "(0.0, 0.0, 1.0)" and told.uniform
