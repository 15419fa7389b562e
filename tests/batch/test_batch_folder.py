import os

import pytest
from small_batches import small_sweep

from sss_ref.batch.batch_folder import BATCH, claim
from sss_ref.errors import DumpError


def test_a_sweep_goes_on_in_the_folder_of_another_with_the_same_outputs(tmp_path):
    folder = claim(tmp_path / "new" / "batch", small_sweep())
    assert os.listdir(folder) == [BATCH]
    assert claim(folder, small_sweep(seed=4, vary={"camera.elevation": [1]})) == folder


@pytest.mark.parametrize("changes", [{"outputs": ["png", "npz"]}, {"keep": ["all"]}])
def test_other_outputs_need_another_folder(tmp_path, changes):
    claim(tmp_path, small_sweep())
    with pytest.raises(
        DumpError, match=r"expected outputs \['png'\] and keep \['final'\], as the items there have, got"
    ):
        claim(tmp_path, small_sweep(**changes))


def test_other_files_are_left_alone(tmp_path):
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(DumpError, match="an earlier batch, got other files; move them"):
        claim(tmp_path, small_sweep())
    assert os.listdir(tmp_path) == ["letter.txt"]


def test_a_damaged_record_is_told(tmp_path):
    (tmp_path / BATCH).write_text("{}")
    with pytest.raises(DumpError, match=r"batch.json: expected what sss-ref batch writes"):
        claim(tmp_path, small_sweep())
