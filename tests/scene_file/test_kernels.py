"""The published kernels, held to each other, to what their authors printed."""

from sss_ref.scene_file.kernels import HBH09, KERNELS, SCHOENBERGER, TABLE1, channel_sums, normalized


def test_kernels_sum_to_what_their_authors_printed():
    assert [round(s, 4) for s in channel_sums(TABLE1)] == [0.9977, 1.0494, 0.9996]
    assert [round(s, 6) for s in channel_sums(HBH09)] == [0.998440, 1.000001, 0.999999]
    assert [round(sum(column), 6) for column in zip(*HBH09, strict=True)][:2] == [1.400346, -2.959784]
    assert SCHOENBERGER[0] == (0.0, 0.0, 0.220441, 0.487, 0.635) and SCHOENBERGER[1:] == HBH09[1:]
    assert all(len(taps) == 13 for taps in KERNELS.values())
    # The paper's table is the original cut off, not rounded, at four decimals, but for its green centre.
    cut = [tuple(int(x * 1e4 + (1e-6 if x > 0 else -1e-6)) / 1e4 for x in row) for row in HBH09]
    assert [row for row, printed in zip(cut, TABLE1, strict=True) if row != printed] == [
        (0.0, 0.0, 0.2204, 0.437, 0.635)
    ]


def test_each_channel_is_divided_by_its_own_sum():
    taps = ((7.0, 8.0, 1.0, 2.0, 5.0), (9.0, 6.0, 3.0, 2.0, 11.0))
    assert channel_sums(taps) == (4, 4, 16)
    assert normalized(taps) == ((7, 8, 0.25, 0.5, 0.3125), (9, 6, 0.75, 0.5, 0.6875))
