import os
from dataclasses import replace

import imageio.v3 as imageio
import numpy as np
import pytest

from sss_ref.errors import DumpError, RenderError
from sss_ref.rendering.fold import render
from sss_ref.results import folder as folder_module
from sss_ref.results import saving, whole_folder
from sss_ref.results.folder import read_buffer, save
from sss_ref.scene.load import load_scene


def files(folder):
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


def contents(folder):
    return {name: (folder / name).read_bytes() for name in files(folder)}


def test_contents(result, saved):
    npy = [f"buffers/{name}.npy" for name in result.buffers]
    assert files(saved) == sorted(["buffers.exr", "image.png", "manifest.json", "overview.png", *npy])
    assert os.listdir(saved.parent) == ["out"]
    assert imageio.imread(saved / "image.png").shape == (32, 48, 4)


def test_arrays_come_back_in_bits(result, saved):
    for name, buffer in result.buffers.items():
        stored = read_buffer(saved / "buffers" / f"{name}.npy")
        assert stored.dtype == buffer.dtype and stored.shape == buffer.shape
        assert stored.tobytes() == buffer.tobytes()


def test_only_what_was_kept(scene_file):
    scene = load_scene(scene_file)
    final = save(render(scene, keep="final"), scene_file.parent / "final")
    assert files(final) == ["buffers.exr", "buffers/image.npy", "image.png", "manifest.json"]
    assert imageio.imread(final / "image.png").shape == (32, 48, 3)
    early = save(render(scene, interpreter="arrays", keep=["light_depth"]), scene_file.parent / "early")
    assert files(early) == ["buffers.exr", "buffers/light_depth.npy", "manifest.json", "overview.png"]


def test_a_folder_filled_while_rendering_is_the_one_saved_afterwards(result, saved, tmp_path):
    with folder_module.saving(tmp_path / "early", "kernel", 2) as files:
        for name in list(result.buffers)[::2]:
            files.take(name, result[name])
        assert files.finish(replace(result)).hashes == result.hashes
    assert contents(tmp_path / "early") == contents(saved)


def test_a_rendering_that_fails_leaves_nothing(result, tmp_path):
    with pytest.raises(RenderError), folder_module.saving(tmp_path / "out", None, None) as files:
        files.take("image", result.image)
        raise RenderError("not finite")
    assert os.listdir(tmp_path) == []


def test_a_halo_is_not_hidden_by_alpha(scene_file):
    scene = load_scene(scene_file, **{"blur.mask": "none"})
    folder = save(render(scene, interpreter="arrays", keep=["coverage", "image"]), scene_file.parent / "halo")
    assert imageio.imread(folder / "image.png").shape == (32, 48, 3)


def test_the_printed_figures_are_not_srgb_encoded(scene_file):
    scene = load_scene(scene_file, preset="published")
    result = render(scene, interpreter="arrays", keep=["image"])
    folder = save(result, scene_file.parent / "printed")
    steps = np.rint(result.image.astype(np.float64) * 255)
    assert len(np.unique(steps)) > 20
    assert np.array_equal(imageio.imread(folder / "image.png")[::-1], steps)


def test_earlier_result_is_replaced_whole(result, saved):
    (saved / "buffers" / "stale.npy").write_bytes(b"")
    assert save(result, saved) == saved
    assert "buffers/stale.npy" not in files(saved)
    assert os.listdir(saved.parent) == ["out"]


@pytest.mark.parametrize("existing", ["nothing", "result"])
@pytest.mark.parametrize("step", ["write_exr", "write_overview", "write_png"])
def test_failure_in_the_middle_changes_nothing(result, tmp_path, monkeypatch, existing, step):
    if existing == "result":
        save(result, tmp_path / "out")
        (tmp_path / "out" / "mark").write_text("the earlier one")
    before = files(tmp_path)

    def full_disk(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(saving, step, full_disk)
    with pytest.raises(DumpError, match=r"cannot be written \(No space left on device\); choose another folder"):
        save(result, tmp_path / "out")
    assert files(tmp_path) == before
    assert os.listdir(tmp_path) == (["out"] if existing == "result" else [])


def test_failed_swap_puts_the_earlier_result_back(result, saved, monkeypatch):
    rename = type(saved).rename

    def fails_for_the_new_one(path, target):
        if path.name == "content":
            raise OSError(13, "Permission denied")
        return rename(path, target)

    before = files(saved)
    monkeypatch.setattr(whole_folder, "exchanged", lambda first, second: False)
    monkeypatch.setattr(type(saved), "rename", fails_for_the_new_one)
    with pytest.raises(DumpError, match="Permission denied"):
        save(result, saved)
    assert files(saved) == before and os.listdir(saved.parent) == ["out"]


def test_empty_folder_is_taken(result, tmp_path):
    (tmp_path / "out").mkdir()
    assert "manifest.json" in files(save(result, tmp_path / "out"))


def test_missing_parents_are_made(result, tmp_path):
    assert "manifest.json" in files(save(result, tmp_path / "a" / "b" / "out"))


@pytest.mark.parametrize("name, text", [("thesis.tex", "years of work"), ("manifest.json", '{"format": "web app"}')])
def test_foreign_folder_is_refused_and_untouched(result, tmp_path, name, text):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / name).write_text(text)
    with pytest.raises(DumpError, match="expected a new folder, an empty one or an earlier result, got other files"):
        save(result, tmp_path / "out")
    assert os.listdir(tmp_path) == ["out"] and (tmp_path / "out" / name).read_text() == text


def test_a_file_is_in_the_way(result, tmp_path):
    (tmp_path / "out").write_text("a file")
    with pytest.raises(DumpError, match="got other files"):
        save(result, tmp_path / "out")
    with pytest.raises(DumpError, match="expected a place to write to"):
        save(result, tmp_path / "out" / "below")
    assert (tmp_path / "out").read_text() == "a file"


@pytest.mark.parametrize(
    "content", [b"", b"\x93NUMPY\x01\x00rest", b"text", b"\x93NUMPY\x01\x00\x10\x00{'descr': '<f4'\n  "]
)
def test_unreadable_buffer(tmp_path, content):
    (tmp_path / "x.npy").write_bytes(content)
    with pytest.raises(DumpError, match="expected a buffer in NPY format, got one that is damaged or cut off; "):
        read_buffer(tmp_path / "x.npy")


def test_a_pipe_is_never_waited_for(tmp_path):
    os.mkfifo(tmp_path / "x.npy")
    with pytest.raises(DumpError, match="got no regular file; copy its content to one"):
        read_buffer(tmp_path / "x.npy")


@pytest.mark.parametrize("content", ["[" * 100_000, "{", "3"])
def test_a_broken_manifest_makes_no_result_of_ours(result, tmp_path, content):
    (tmp_path / "manifest.json").write_text(content)
    with pytest.raises(DumpError, match="got other files"):
        save(result, tmp_path)


def test_pickles_are_never_run(tmp_path):
    np.save(tmp_path / "x.npy", np.array([{}], dtype=object), allow_pickle=True)
    with pytest.raises(DumpError):
        read_buffer(tmp_path / "x.npy")
