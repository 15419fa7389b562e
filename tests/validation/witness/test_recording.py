"""What a witness put together by hand is written as, and that it is read back as it was."""

import numpy as np
import pytest
from example_stages import painted
from painted_witness import GIVEN, PICTURE, F, painted_witness

from sss_ref.dump.loss import Loss
from sss_ref.interpret.intervals.value_sets import Texels
from sss_ref.language.types import vec2, vec3
from sss_ref.numerics.interval import Interval
from sss_ref.validation.witness.recalling import Standing, recalled
from sss_ref.validation.witness.recording import recorded
from sss_ref.validation.witness.witness import DrawnValue
from sss_ref.validation.witness.witness_record import PLAIN, ElementsRecord, ValueRecord

DRAWN = DrawnValue("camera", "tinted_2", (7, 4), device="a card")
WIDE = vec2(Interval(F([0.5]), F([0.625])), Interval(F([0.25]), F([0.75])))  # of texels (1, 0) and (1, 1)
WRONG = F([0, 0, 0])


def test_values_are_written_as_their_bits_and_elements_that_may_be_read_with_their_places():
    record = recorded(painted_witness("tinted", WRONG, DRAWN))
    assert (record.buffer, record.in_pass, record.at, record.device) == ("tinted_2", "camera", (7, 4), "a card")
    assert record.expected == record.low == record.high == "c1d80000 42290000 433d8000"
    assert record.got.split() == ["00000000"] * 3 and record.output == "tinted" and record.why == ()
    reads = dict(record.reads)
    assert reads["fragment_uv"] == "3f000000 3f400000" and reads["triangle"] == reads["coverage"] == "00000001"
    assert reads["picture"] == ElementsRecord(size=(3, 2), at="1,1*1x1", bits="AABAQQAAUEEAAGBB")
    assert reads["material"] == ElementsRecord(size=(2,), at="1*1", bits="AAAAQQAAgEEAAABC")
    assert reads["number"] == ElementsRecord(size=(3,), at="material", bits="AQAAAA==")


def test_ends_are_written_where_a_value_may_be_another():
    normal = vec3(*(Interval(F([end - 1]), F([end + 2])) for end in (0, 0.25, 1)))
    record = recorded(painted_witness("tinted", WRONG, DRAWN, fragment_uv=WIDE, fragment_normal=normal))
    assert record.reads["fragment_uv"] == ValueRecord(
        value="3f000000 3f400000",
        low="3fe0000000000000 3fd0000000000000",
        high="3fe4000000000000 3fe8000000000000",
    )
    assert record.reads["fragment_normal"].high == "4000000000000000 4002000000000000 4008000000000000"
    assert record.reads["picture"].at == "1,0*1x2" and record.why


@pytest.mark.parametrize(
    ("storage", "told"),
    [
        ("float32", PLAIN),
        ("float16", "float16"),
        (Loss(), PLAIN),
        (Loss(least=0.25, low=0.0), {"least": 0.25, "low": 0.0}),
    ],
)
def test_a_storage_is_told_by_what_it_loses(storage, told):
    drawn = DrawnValue("camera", "tinted_2", (7, 4), storage, "float32")
    record = recorded(painted_witness("tinted", WRONG, drawn))
    assert (record.stored, record.rounded) == (told, PLAIN)
    assert recalled(record, "a file", {"painted": painted}).drawn.stored == (PLAIN if told == PLAIN else storage)


TEXELS = {
    "both ends": Texels(PICTURE - 1, PICTURE + 1),
    "the low end": Texels(PICTURE - 1, PICTURE),
    "the high end": Texels(PICTURE, PICTURE + 1),
    "a span": Texels(PICTURE, PICTURE, 1.0),
    "nothing": Texels(PICTURE, PICTURE),
}


@pytest.mark.parametrize("known", TEXELS)
def test_a_texture_is_read_back_with_what_is_known_of_its_texels(known):
    given = TEXELS[known]
    witness = painted_witness("tinted", WRONG, DRAWN, picture=given)
    record = recorded(witness)
    is_exact = known in ("nothing", "a span")
    assert (record.reads["picture"].low == record.reads["picture"].high == "") == is_exact
    again = recalled(record, "a file", {"painted": painted})
    exact, bounds = again.situation.exact["picture"], again.situation.bounds["picture"]
    assert exact.data[1, 1].tolist() == PICTURE[1, 1].tolist() and exact.data.shape == PICTURE.shape
    assert (bounds is exact) == (known == "nothing")
    if known != "nothing":
        assert (bounds.low[1, 1].tolist(), bounds.high[1, 1].tolist()) == (
            given.low[1, 1].tolist(),
            given.high[1, 1].tolist(),
        )
        assert bounds.span == given.span
    assert np.array_equal(again.reach, witness.reach) and again.outcome == witness.outcome == "fail"


def test_all_is_read_back_as_it_was():
    witness = painted_witness("tinted", WRONG, DRAWN, fragment_uv=WIDE, flat=Interval(F([1]), F([12])))
    again = recalled(recorded(witness), "a file", {"painted": painted})
    assert again.drawn == DRAWN and again.output == "tinted" and again.profile == witness.profile
    for own in ("fragment_normal", "fragment_uv"):
        assert [*again.situation.exact[own]] == [*GIVEN[own]]
    wide, flat = again.situation.bounds["fragment_uv"], again.situation.bounds["flat"]
    assert isinstance(wide, vec2) and wide.y.low.tolist() == [0.25] and wide.x.high.tolist() == [0.625]
    assert isinstance(flat, Interval) and (flat.low.tolist(), flat.high.tolist()) == ([1], [12])
    assert again.situation.exact["number"].data.tolist() == [0, 1, 0] and again.got.tolist() == [0, 0, 0]
    assert np.array_equal(again.reach, witness.reach) and (again.reach > 0).any()
    assert recorded(again) == recorded(witness)


def test_whether_what_judges_it_is_what_wrote_it():
    record = recorded(painted_witness("steps", np.int32([9])))
    assert Standing.of(record, painted).other == ""
    older = record.model_copy(update={"rules": 1})
    assert Standing.of(older, painted).other == "written by rules version 1, here it is 2"
