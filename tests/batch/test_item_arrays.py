import json
import os

import numpy as np
import pytest
from small_batches import AZIMUTHS, SMALL, small_sweep

from sss_ref.batch import item_arrays
from sss_ref.batch.batch_folder import claim
from sss_ref.batch.item_arrays import NAMES, STORE, ItemArrays, check_zarr, numbering
from sss_ref.batch.plan import Shard
from sss_ref.batch.run import BatchExecution, run
from sss_ref.errors import DumpError, SceneError
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

zarr = pytest.importorskip("zarr", minversion="3")
ARRAYS = BatchExecution(interpreter="arrays", threads=1)
KEPT = ["image", "thickness", "triangle"]
NAME, OTHER = "ab" * 16, "cd" * 16


def zarr_sweep(**changes):
    return small_sweep(**{"outputs": ["zarr"], "keep": KEPT, **changes})


def states(batch):
    return [each.state for each in batch.outcomes]


def chunks_of(array, item):
    return [path for path in array.iterdir() if path.name.startswith(f"c.{item}.")]


def test_a_chunk_has_the_bits_of_its_item(tmp_path):
    batch = run(zarr_sweep(), tmp_path, ARRAYS)
    store = zarr.open_group(tmp_path / STORE, mode="r")
    assert sorted(store.array_keys()) == sorted([*KEPT, NAMES])
    for item, azimuth in enumerate(AZIMUTHS):
        buffers = render(load_scene("small", **SMALL, **{"camera.azimuth": azimuth}), "arrays", keep=KEPT).buffers
        assert {name: store[name][item].tobytes() for name in KEPT} == {
            name: buffer.tobytes() for name, buffer in buffers.items()
        }
        assert bytes(store[NAMES][item]).hex() == batch.outcomes[item].name
    assert store["image"].chunks == (1, 24, 32, 3) and store["triangle"].dtype == np.int32
    described = store["thickness"].metadata
    assert described.dimension_names == ("item", "row", "column")
    assert store["thickness"].attrs["unit"] == "scene units along the light's ray"


def test_zeros_of_either_sign_and_a_picture_of_background_alone_are_kept(tmp_path):
    arrays = ItemArrays(tmp_path, 3)
    negative, nothing = np.full((2, 2), -0.0, np.float32), np.full((2, 2), -1, np.int32)
    arrays.write(1, NAME, {"depth": negative, "triangle": nothing})
    store = zarr.open_group(tmp_path / STORE, mode="r")
    assert store["depth"][1].tobytes() == negative.tobytes() and np.isnan(store["depth"][0]).all()
    assert len(chunks_of(tmp_path / STORE / "triangle", 1)) == 1
    assert (store["triangle"][0] == -1).all() and (store["triangle"][2] == -1).all()


def test_what_is_not_there_yet_is_no_number_that_a_buffer_has(tmp_path):
    """NaN, no triangle, and of what is in the light or not: not."""
    sample = {name: np.ones((2, 3), kind) for name, kind in (("depth", "f4"), ("triangle", "i4"), ("coverage", "u1"))}
    ItemArrays(tmp_path, 2).write(1, NAME, sample)
    store = zarr.open_group(tmp_path / STORE, mode="r")
    assert [store[name][0].reshape(-1)[0].item() for name in ("triangle", "coverage")] == [-1, 0]
    assert np.isnan(store["depth"][0]).all()
    assert {name: store[name].shape for name in sample} == dict.fromkeys(sample, (2, 2, 3))
    assert store.attrs["note"].startswith("A chunk for each item")


def test_it_is_read_while_it_grows_and_goes_on(tmp_path):
    run(zarr_sweep(), tmp_path, ARRAYS, Shard(2, 2))
    names = zarr.open_group(tmp_path / STORE, mode="r")[NAMES][:]
    assert names.any(axis=1).tolist() == [False, True, False, True]
    assert states(run(zarr_sweep(), tmp_path, ARRAYS)) == ["rendered", "there"] * 2
    drawn = {"camera.azimuth": {"random": "integer", "low": 0, "high": 90}}
    few, many = (zarr_sweep(vary=drawn, repeat=repeat) for repeat in (2, 3))
    run(few, tmp_path / "drawn", ARRAYS)
    assert states(run(many, tmp_path / "drawn", ARRAYS)) == ["there", "there", "rendered"]
    assert zarr.open_group(tmp_path / "drawn" / STORE, mode="r")["image"].shape[0] == 3


def test_an_item_is_there_only_with_all_its_chunks(tmp_path):
    """Killed before the last chunk, which is that of its name, or before the folder of the item has its name."""
    batch = run(zarr_sweep(), tmp_path, ARRAYS)
    for path in chunks_of(tmp_path / STORE / NAMES, 2):
        path.unlink()
    again = run(zarr_sweep(), tmp_path, ARRAYS)
    assert states(again) == ["there", "there", "rendered", "there"]
    assert [each.hashes for each in again.outcomes] == [each.hashes for each in batch.outcomes]
    assert bytes(zarr.open_group(tmp_path / STORE)[NAMES][2]).hex() == batch.outcomes[2].name


def test_the_name_is_written_last(tmp_path, monkeypatch):
    arrays = ItemArrays(tmp_path, 2)
    good = np.zeros((2, 2), np.float32)
    arrays.write(0, NAME, {"depth": good, "image": good})
    with pytest.raises(DumpError, match=r"image: expected 2 x 2 of float32, as other items have, got 3 of int32"):
        arrays.write(1, NAME, {"depth": good, "image": np.zeros(3, np.int32)})
    assert not arrays.holds(1, NAME) and arrays.holds(0, NAME)
    with pytest.raises(DumpError):
        arrays.write(0, OTHER, {"depth": good, "image": np.zeros(3, np.int32)})
    assert not arrays.holds(0, NAME) and not arrays.holds(0, OTHER)  # what it held is no longer whole


def test_two_numbers_of_one_picture_have_a_chunk_each(tmp_path):
    batch = run(zarr_sweep(vary={"camera.azimuth": [0, 90, 0]}), tmp_path, ARRAYS)
    images = zarr.open_group(tmp_path / STORE)["image"][:]
    assert images[0].tobytes() == images[2].tobytes() != images[1].tobytes()
    assert batch.outcomes[0].name == batch.outcomes[2].name


def test_of_two_that_make_an_array_the_first_stays(tmp_path):
    arrays = ItemArrays(tmp_path, 2)
    sample = np.zeros((2, 2), np.float32)
    arrays.write(0, NAME, {"depth": sample + 1})
    arrays._make(tmp_path / STORE / "depth", sample, {"fill_value": 0})
    assert zarr.open_group(tmp_path / STORE)["depth"][0].tolist() == (sample + 1).tolist()
    assert sorted(os.listdir(tmp_path)) == [STORE]


def test_sizes_that_vary_are_told(tmp_path):
    batch = run(zarr_sweep(vary={"camera.height": [24, 16]}), tmp_path, ARRAYS)
    assert states(batch) == ["rendered", "failed"]
    assert "triangle: expected 24 x 32 of int32, as other items have, got 16 x 32 of int32; vary no" in (
        batch.outcomes[1].message
    )


def test_numbers_are_those_of_one_sweep(tmp_path):
    claim(tmp_path, zarr_sweep())
    with pytest.raises(DumpError, match="the sweep that has numbered the items of the Zarr store there, got another"):
        claim(tmp_path, zarr_sweep(vary={"camera.elevation": [1]}))
    assert claim(tmp_path, zarr_sweep()) == tmp_path
    assert "numbering" not in json.loads((claim(tmp_path / "png", small_sweep()) / "batch.json").read_text())


def test_more_rounds_change_no_number():
    drawn = {"a": {"random": "uniform", "low": 0, "high": 1}}
    one = numbering(small_sweep(vary=drawn))
    assert numbering(small_sweep(vary=drawn, repeat=9)) == one
    others = [{"seed": 2}, {"combine": "zip"}, {"scene": "other"}, {"set": {"a": 1}}]
    assert len({one, *(numbering(small_sweep(vary=drawn, **each)) for each in others)}) == 5


@pytest.mark.parametrize("version, came", [(None, "none"), ("2.18.3", "2.18.3")])
def test_a_missing_package_is_told(monkeypatch, version, came):
    monkeypatch.setattr(item_arrays, "find_spec", lambda name: version)
    monkeypatch.setattr(item_arrays.metadata, "version", lambda name: version)
    with pytest.raises(SceneError, match=f"outputs: zarr: expected the package zarr, version 3, got {came}; run"):
        check_zarr(zarr_sweep())
    check_zarr(small_sweep())
