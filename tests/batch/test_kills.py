"""Batches that are killed at any moment, the process itself or one of those it starts, lose only what is in flight."""

import csv
import os
import random
import signal
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import pytest
from data_folder import TETRAHEDRON
from small_batches import items_of

from sss_ref.batch.item_arrays import NAMES, STORE
from sss_ref.batch.item_folder import ItemRecord
from sss_ref.batch.run import BatchExecution, run
from sss_ref.batch.sweep_file import read_sweep

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="finds processes by /proc")

SWEEP = """
scene = "scene.toml"
outputs = {outputs}
keep = ["image", "thickness"]
repeat = {items}
set = {{camera = {{width = 24, height = 16}}, shadow_map = {{width = 24, height = 24}}}}
vary."camera.azimuth" = {{random = "uniform", low = 0, high = 360}}
"""
SCENE = """
mesh = {path = "tetrahedron.obj"}
camera = {type = "orbit", distance = 5}
lights = [{position = [0, 0, 9]}]
"""
OUTPUTS = ["png", "npz", *(["zarr"] if find_spec("zarr") else [])]
MOST_BETWEEN = 60  # items from one kill to the next
MOMENT = 0.02  # seconds from an item to the kill, of about the time that an item takes
PATIENCE = 300.0  # seconds, on a machine that has much else to do


def begun(sweep, folder):
    """A batch in a process of its own, with two more that render."""
    command = ["-m", "sss_ref.cli", "batch", str(sweep), "-o", str(folder), "--jobs", "2", "--interpreter", "arrays"]
    return subprocess.Popen([sys.executable, *command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def renderers(process):
    """The processes that a batch has started to render."""
    try:
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        return [int(child) for child in children if b"spawn_main" in Path(f"/proc/{child}/cmdline").read_bytes()]
    except FileNotFoundError:
        return []


def complete(folder):
    """How many items are there as a whole."""
    return sum(not path.name.startswith(".") for path in folder.glob("items/??/*"))


def awaited(met):
    end = time.monotonic() + PATIENCE
    while not met():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def is_running(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def killed_once(sweep, folder, draw, whole):
    """Begin a batch, and kill it, or else one of the processes that render, at a moment that is drawn."""
    count = complete(folder) + draw.randint(0, MOST_BETWEEN)
    process = begun(sweep, folder)
    awaited(lambda: complete(folder) > count or process.poll() is not None)
    time.sleep(draw.uniform(0, MOMENT))
    workers = renderers(process)
    assert process.poll() is None and workers, "it had ended before it was killed; give it more items"
    if whole:
        process.kill()
        process.communicate()
    else:
        os.kill(draw.choice(workers), signal.SIGKILL)
        more = complete(folder)
        awaited(lambda: complete(folder) > more or process.poll() is not None)  # others have taken its place
        assert process.poll() in (None, 0)
        workers = renderers(process)
        process.kill()
        process.communicate()
    awaited(lambda: not any(map(is_running, workers)))  # none of them is left waiting


def without_times(files):
    """The files of an item, of its record all but how long it took."""
    record = ItemRecord.model_validate_json(files["item.json"]).model_dump()
    return {**files, "item.json": {**record, "seconds": None}}


def whole_items(folder):
    """Number -> bytes of each chunk, of the items of a batch's Zarr store that say that they are complete."""
    chunks = {path: path.read_bytes() for path in sorted((folder / STORE).glob("*/c.*")) if path.suffix != ".partial"}
    found = {}
    for path, content in chunks.items():
        found.setdefault(int(path.name.split(".")[1]), {})[path.parent.name] = content
    return {item: arrays for item, arrays in found.items() if any(arrays.get(NAMES, b""))}


def check_kills(folder, kills, items, seed):
    (folder / "scene.toml").write_text(SCENE)
    (folder / "tetrahedron.obj").write_text(TETRAHEDRON)
    sweep = folder / "sweep.toml"
    sweep.write_text(SWEEP.format(items=items, outputs=OUTPUTS))
    run(read_sweep(sweep), folder / "whole", BatchExecution(interpreter="arrays", threads=1))
    expected = {name: without_times(files) for name, files in items_of(folder / "whole").items()}
    expected_arrays = whole_items(folder / "whole")
    assert len(expected) == items and len(expected_arrays) == (items if "zarr" in OUTPUTS else 0)
    draw, outs = random.Random(seed), folder / "killed"
    for number in range(kills):
        killed_once(sweep, outs, draw, whole=number % 2 == 0)
        found = items_of(outs)
        assert {name: without_times(files) for name, files in found.items()} == {name: expected[name] for name in found}
        arrays = whole_items(outs)
        assert arrays == {item: expected_arrays[item] for item in arrays}
    last = begun(sweep, outs)
    _, told = last.communicate(timeout=PATIENCE)
    assert last.returncode == 0, told
    assert {name: without_times(files) for name, files in items_of(outs).items()} == expected
    assert whole_items(outs) == expected_arrays
    with (outs / "items.csv").open(newline="") as file:
        assert {row["state"] for row in csv.DictReader(file)} == {"rendered", "there"}
    # What was in flight is cleared away, but for an emptied place of an item that was complete when it was killed.
    assert not [path for place in outs.rglob(".*.part") for path in place.iterdir()]


def test_a_killed_batch_loses_what_is_in_flight_alone(tmp_path):
    check_kills(tmp_path, kills=2, items=600, seed=2)


@pytest.mark.full
def test_thirty_kills(tmp_path):
    check_kills(tmp_path, kills=30, items=4000, seed=1)
