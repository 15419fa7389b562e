import pytest
from small_batches import small_sweep

from sss_ref.batch.plan import WHOLE, Plan, Shard
from sss_ref.errors import SceneError


def plan(vary, **changes):
    return Plan(small_sweep(vary=vary, **changes))


def test_a_grid_has_every_value_with_every_other_the_last_key_fastest():
    found = plan({"a": [1, 2], "b": {"first": 0, "last": 1, "count": 3}, "c": ["x"]})
    assert len(found) == 6
    assert [tuple(found[item].values()) for item in range(6)] == [(a, b, "x") for a in (1, 2) for b in (0, 0.5, 1)]
    assert list(found[0]) == ["a", "b", "c"]


def test_a_zip_takes_one_of_each():
    found = plan({"a": [1, 2, 3], "b": {"first": 0, "last": 1, "count": 3}}, combine="zip")
    assert [found[item] for item in range(len(found))] == [{"a": 1, "b": 0}, {"a": 2, "b": 0.5}, {"a": 3, "b": 1}]


def test_random_keys_are_drawn_for_every_item_and_do_not_depend_on_how_many_there_are():
    given = {"r": {"random": "uniform", "low": 0, "high": 1}, "a": [1, 2]}
    few, many = plan(given, repeat=2), plan(given, repeat=50)
    assert (len(few), len(many)) == (4, 100)
    assert [few[item] for item in range(4)] == [many[item] for item in range(4)]
    assert [few[item]["a"] for item in range(4)] == [1, 2, 1, 2]
    assert len({many[item]["r"] for item in range(100)}) == 100
    assert plan(given, seed=1)[0]["r"] != few[0]["r"]


def test_random_keys_alone_give_as_many_items_as_rounds():
    assert len(plan({"r": {"random": "uniform", "low": 0, "high": 1}}, repeat=5)) == 5


def test_random_keys_alone_may_be_zipped():
    assert len(plan({"r": {"random": "uniform", "low": 0, "high": 1}}, repeat=5, combine="zip")) == 5
    assert len(plan({"r": {"random": "uniform", "low": 0, "high": 1}})) == 1


def test_what_is_set_lies_below_what_varies():
    assert Plan(small_sweep(set={"a": 1, "b": 2}, vary={"b": [3]})).overrides(0) == {"a": 1, "b": 3}


def test_a_zip_of_unequal_lengths_is_refused():
    with pytest.raises(SceneError, match=r"vary.b: expected 2 values, as vary.a has, got 3; zip takes one of each"):
        plan({"a": [1, 2], "b": [1, 2, 3]}, combine="zip")


def test_rounds_that_would_all_be_the_same_are_refused():
    with pytest.raises(SceneError, match="repeat: expected a key drawn at random, got none"):
        plan({"a": [1, 2]}, repeat=2)


def test_shards_share_the_items_among_them():
    parts = [Shard.parsed(f"{number}/3").of(10) for number in (1, 2, 3)]
    assert sorted(item for part in parts for item in part) == list(range(10))
    assert max(map(len, parts)) - min(map(len, parts)) <= 1
    assert WHOLE.of(4) == range(4)


@pytest.mark.parametrize(
    ("text", "shard", "items", "suffix"),
    [
        ("1/1", Shard(1, 1), [0, 1, 2, 3, 4], ""),
        ("1/2", Shard(1, 2), [0, 2, 4], "-1-of-2"),
        ("2/2", Shard(2, 2), [1, 3], "-2-of-2"),
        ("7/7", Shard(7, 7), [], "-7-of-7"),
    ],
)
def test_a_part_is_every_so_manyth_item(text, shard, items, suffix):
    assert Shard.parsed(text) == shard
    assert [*shard.of(5)] == items and shard.suffix == suffix


@pytest.mark.parametrize("text", ["", "3", "0/3", "4/3", "a/3", "-1/3", "1/", "9" * 5000 + "/3"])
def test_what_is_no_shard_is_refused(text):
    with pytest.raises(SceneError, match="--shard: expected NUMBER/COUNT, NUMBER from 1 to COUNT"):
        Shard.parsed(text)
