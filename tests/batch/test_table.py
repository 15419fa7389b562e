import csv
import sys
from types import SimpleNamespace

import pytest
from small_batches import small_sweep

from sss_ref.batch import table
from sss_ref.batch.plan import Plan, Shard
from sss_ref.batch.table import write_table
from sss_ref.batch.workshop import ItemOutcome

PLAN = Plan(small_sweep(vary={"camera.fov_y": [0.1, 30], "camera.target": [[0, 1, 2]], "mesh.color": ["material"]}))
OUTCOMES = [
    ItemOutcome(1, "failed", message='camera: "wrong", said\ntwice'),
    ItemOutcome(0, "rendered", "ab12", 0.25, {"image": "00ff"}),
]
ROWS = [
    ["item", "state", "name", "camera.fov_y", "camera.target", "mesh.color", "seconds", "sha256.image", "message"],
    ["0", "rendered", "ab12", "0.1", "[0, 1, 2]", "material", "0.25", "00ff", ""],
    ["1", "failed", "", "30", "[0, 1, 2]", "material", "0.0", "", 'camera: "wrong", said\ntwice'],
]


def test_there_is_a_row_for_each_item_in_their_order(tmp_path, monkeypatch):
    monkeypatch.setattr(table, "find_spec", lambda name: None)
    (path,) = write_table(tmp_path, PLAN, OUTCOMES)
    with path.open(newline="") as file:
        assert list(csv.reader(file)) == ROWS


def test_a_shard_has_a_table_of_its_own(tmp_path, monkeypatch):
    monkeypatch.setattr(table, "find_spec", lambda name: None)
    assert write_table(tmp_path, PLAN, OUTCOMES, Shard(2, 3)) == [tmp_path / "items-2-of-3.csv"]


def test_a_column_of_one_kind_keeps_it_and_any_other_is_text(tmp_path, monkeypatch):
    """In the place of pyarrow, which not everyone has: the columns that it is given."""
    kinds = {
        "whole": [1, 2],
        "number": [1, 2.5],
        "flag": [True, False],
        "text": ["a", "b"],
        "flag_or_number": [True, 1],
        "text_or_number": ["a", 1],
        "array": [[1, 2], [3]],
    }
    plan = Plan(small_sweep(vary=kinds, combine="zip"))
    tables = {}

    def write(columns, path):
        tables[path.name] = columns
        path.write_bytes(b"")

    pyarrow = SimpleNamespace(array=list, table=dict, parquet=SimpleNamespace(write_table=write))
    monkeypatch.setitem(sys.modules, "pyarrow", pyarrow)
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", pyarrow.parquet)
    monkeypatch.setattr(table, "find_spec", lambda name: name)
    outcomes = [ItemOutcome(0, "rendered", "ab", 0.5, {"image": "00"}), ItemOutcome(1, "failed", message="no")]
    assert write_table(tmp_path, plan, outcomes) == [tmp_path / "items.csv", tmp_path / "items.parquet"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["items.csv", "items.parquet"]
    (columns,) = tables.values()
    as_text = {"flag_or_number": ["true", "1"], "text_or_number": ["a", "1"], "array": ["[1, 2]", "[3]"]}
    assert columns == {
        "item": [0, 1],
        "state": ["rendered", "failed"],
        "name": ["ab", ""],
        **kinds,
        **as_text,
        "seconds": [0.5, 0.0],
        "sha256.image": ["00", None],
        "message": ["", "no"],
    }
    assert [type(value) for value in columns["flag"]] == [bool, bool]


def test_parquet_has_the_same_with_types(tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet", reason="needs pyarrow")
    _, path = write_table(tmp_path, PLAN, OUTCOMES)
    found = parquet.read_table(path).to_pylist()
    assert [each["camera.fov_y"] for each in found] == [0.1, 30.0]
    assert [each["camera.target"] for each in found] == ["[0, 1, 2]"] * 2
    assert [list(map(type, each.values())) for each in found] == [
        [int, str, str, float, str, str, float, str, str],
        [int, str, str, float, str, str, float, type(None), str],
    ]
    assert [path.name for path in sorted(tmp_path.iterdir())] == ["items.csv", "items.parquet"]
