"""The table of a batch: a row for each item, as CSV, and as Parquet where pyarrow is installed."""

import csv
import io
import json
import os
from collections.abc import Iterable, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from sss_ref.batch.plan import WHOLE, Plan, Shard
from sss_ref.batch.workshop import ItemOutcome
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import write_text

Row = dict[str, Any]


def write_table(folder: Path, plan: Plan, outcomes: Iterable[ItemOutcome], shard: Shard = WHOLE) -> list[Path]:
    """Write the table of some items into a batch's folder, in their order; returns the files. Raises DumpError.

    The columns are `item`, `state`, `name`, one for each varied key, `seconds`, `sha256.BUFFER` for each buffer, and
    `message`. Of a shard the files are named after it.
    """
    rows = [row(plan, each) for each in sorted(outcomes, key=lambda each: each.item)]
    columns = _columns(plan, rows)
    files = [folder / f"items{shard.suffix}.csv"]
    write_text(files[0], _csv(columns, rows), DumpError)
    if find_spec("pyarrow"):
        files.append(folder / f"items{shard.suffix}.parquet")
        _write_parquet(files[1], columns, rows)
    return files


def row(plan: Plan, outcome: ItemOutcome) -> Row:
    """The row of an item: column -> value."""
    hashes = {f"sha256.{name}": digest for name, digest in outcome.hashes.items()}
    about = {"item": outcome.item, "state": outcome.state, "name": outcome.name}
    return {**about, **plan[outcome.item], "seconds": outcome.seconds, **hashes, "message": outcome.message}


def _columns(plan: Plan, rows: Sequence[Row]) -> list[str]:
    hashes = dict.fromkeys(key for each in rows for key in each if key.startswith("sha256."))
    return ["item", "state", "name", *plan.sweep.vary, "seconds", *hashes, "message"]


def _csv(columns: Sequence[str], rows: Iterable[Row]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([_cell(each.get(name, "")) for name in columns] for each in rows)
    return text.getvalue()


def _cell(value: Any) -> Any:
    """Numbers so that reading gives the same bits, arrays and tables as JSON."""
    return value if isinstance(value, str | int | float) and not isinstance(value, bool) else json.dumps(value)


def _write_parquet(path: Path, columns: Sequence[str], rows: Sequence[Row]) -> None:
    """A column of one kind of value keeps it; what is mixed, an array or a table becomes text as in the CSV."""
    import pyarrow
    import pyarrow.parquet

    arrays = {}
    for name in columns:
        values = [each.get(name) for each in rows]
        kinds = {bool if isinstance(value, bool) else type(value) for value in values if value is not None}
        plain = kinds <= {int, float} or (len(kinds) == 1 and kinds <= {str, bool})
        arrays[name] = pyarrow.array(values if plain else [None if v is None else str(_cell(v)) for v in values])
    hidden = path.with_name(f".{path.name}.{os.getpid()}")
    pyarrow.parquet.write_table(pyarrow.table(arrays), hidden)
    hidden.replace(path)
