"""A frame of our own drawing, captured by RenderDoc, comes back buffer by buffer; without names, and judged."""

import numpy as np
import pytest
from frame_capture import captured as capture_of
from frame_capture import captured_layers, captured_of_vulkan, captured_passes

from sss_ref.capture import renderdoc_file
from sss_ref.capture.placing import place
from sss_ref.capture.surfaces import Unnamed
from sss_ref.cli import main
from sss_ref.dump.texels import array_texels
from sss_ref.errors import DumpError
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

SIZES = {f"{table}.{side}": 32 for table in ("camera", "shadow_map") for side in ("width", "height")}
SMALL = [part for key, value in SIZES.items() for part in ("--set", f"{key}={value}")] + ["--interpreter", "arrays"]


@pytest.fixture(scope="module")
def oracle():
    return render(load_scene("sphere", **SIZES), "arrays")


@pytest.fixture(scope="module")
def frame(tmp_path_factory):
    return capture_of(tmp_path_factory.mktemp("capture"), "sphere", SIZES)


def test_every_buffer_of_the_frame_is_found(frame, oracle, tmp_path, capsys):
    assert main(["import", str(frame), "sphere", "-o", str(tmp_path), *SMALL]) == 0
    printed = capsys.readouterr()
    assert {line.partition(":")[0] for line in printed.out.splitlines()[:-1]} == set(oracle.buffers)
    assert "_depth.npy: left out, it holds the same as" in printed.err
    assert main(["validate", "sphere", str(tmp_path / "mapping.toml"), *SMALL]) == 0
    assert f"{len(oracle.buffers)} buffers, every stage gives what it should" in capsys.readouterr().out


@pytest.fixture(scope="module")
def vulkan_frame(tmp_path_factory):
    return captured_of_vulkan(tmp_path_factory.mktemp("vulkan"), "sphere", SIZES, named=False)


def test_every_buffer_of_a_frame_of_vulkan_is_found_without_names(vulkan_frame, oracle, tmp_path, capsys):
    """Colours have an alpha there, 1 where something is drawn: no mask is taken for one of these."""
    arguments = ["import", str(vulkan_frame), "sphere", "-o", str(tmp_path), *SMALL]
    assert main(arguments) == 0
    printed = capsys.readouterr()
    lines = dict(line.split(": ", 1) for line in printed.out.splitlines()[:-1])
    assert lines.keys() == oracle.buffers.keys()
    assert len({line.partition(",")[0] for line in lines.values()}) == len(lines)
    assert all("left out, it holds the same as" in line for line in printed.err.splitlines())
    assert main(["validate", "sphere", str(tmp_path / "mapping.toml"), "--profile", "wgsl", *SMALL]) == 0


def test_textures_have_their_names_in_vulkan(oracle, tmp_path, capsys):
    frame = captured_of_vulkan(tmp_path, "sphere", SIZES, named=True)
    assert main(["import", str(frame), "-o", str(tmp_path / "new")]) == 0
    named = {line.rpartition(", ")[2] for line in capsys.readouterr().out.splitlines()[:-1]}
    assert named >= oracle.buffers.keys()


def test_of_render_passes_what_each_leaves_before_the_next_clears_it(tmp_path):
    """The second pass clears what the first drew, the third does not; a depth of 24 bits is in the lower ones there."""
    found, notes = renderdoc_file.captured(captured_passes(tmp_path), tmp_path)
    assert not notes
    first, depth, second, _ = (each.texels.data for each in found)
    assert (first[..., 2] == 1).all() and (second[..., 2] == 3).all()
    assert first[0, 0, :2].tolist() == [0.5, 2.5]  # the bottom row first, as y points down
    assert np.unique(depth).tolist() == [np.float32(0x400000 / (2**24 - 1))]


def test_of_layers_of_a_texture_what_each_was_left_with(tmp_path):
    """In OpenGL one may be drawn into after the other with nothing in between but what attaches it."""
    found, notes = renderdoc_file.captured(captured_layers(tmp_path), tmp_path)
    assert not notes and [np.unique(each.texels.data).tolist() for each in found] == [[2], [3]]


def test_a_capture_is_judged_at_once(frame, capsys):
    assert main(["validate", "sphere", str(frame), "--set", "translucency.y=3.0", "--quick", *SMALL]) == 1
    assert "fail: stage translucency" in capsys.readouterr().out


def test_without_a_scene_the_pictures_are_listed(frame, tmp_path, capsys):
    assert main(["import", str(frame), "-o", str(tmp_path / "new")]) == 0
    printed = capsys.readouterr().out
    assert "32 x 32, 1 channel, int32, Texture" in printed
    assert printed.splitlines()[-1] == f"{tmp_path / 'new'}: {len(list((tmp_path / 'new').iterdir()))} pictures"


@pytest.mark.parametrize(
    ("kept", "words"),
    [
        (4, "expected a whole RenderDoc capture, got one that is damaged or cut off; capture it again"),
        (0.5, "expected a whole RenderDoc capture, got one that is damaged or cut off; capture it again"),
        (0.99, "expected a capture that replays to its end, got one cut off, or beyond this driver"),
    ],
)
def test_a_capture_cut_off_is_refused_in_one_line(kept, words, frame, tmp_path, capsys):
    data = frame.read_bytes()
    (tmp_path / "x.rdc").write_bytes(data[: kept if kept > 1 else int(len(data) * kept)])
    assert main(["import", str(tmp_path / "x.rdc")]) == 2
    printed = capsys.readouterr().err
    assert words in printed and printed.count("\n") == 1


def test_another_file_of_that_name_is_refused(tmp_path):
    (tmp_path / "x.rdc").write_text("text")
    with pytest.raises(DumpError, match="expected a RenderDoc capture, got another file; check the path"):
        renderdoc_file.captured(tmp_path / "x.rdc", tmp_path)
    with pytest.raises(DumpError, match="expected a RenderDoc capture, got No such file"):
        renderdoc_file.captured(tmp_path / "y.rdc", tmp_path)


def test_without_the_module_it_is_said_how_to_get_it(tmp_path, monkeypatch):
    monkeypatch.setattr(renderdoc_file, "renderdoc_python", lambda: None)
    (tmp_path / "x.rdc").write_bytes(b"RDOC")
    with pytest.raises(DumpError, match="got none; install python3-renderdoc"):
        renderdoc_file.captured(tmp_path / "x.rdc", tmp_path)


def unnamed(name, data, labels=(), is_spare=False):
    texels = array_texels(None, data)
    return Unnamed(renderdoc_file.Path(f"{name}.npy"), texels, labels=labels, is_spare=is_spare)


def test_what_is_called_like_a_buffer_is_that_buffer(oracle):
    """Two files that hold the same, told apart by what their textures are called; channels and rows by the values."""
    turned = np.ascontiguousarray(oracle["phong"][::-1])
    files = [unnamed("a", oracle["phong"]), unnamed("b", turned, labels=("phong",))]
    (name, found), *others = place(files, oracle).placements.items()
    assert (name, found.surface, found.candidate.origin) == ("phong", files[1], "top")
    assert not others


def test_an_opacity_is_no_mask_where_there_are_masks(oracle):
    """Every colour has the coverage in its alpha, as those of Vulkan and WebGPU have."""
    opacity = oracle["coverage"].astype(np.float32)
    files = [
        unnamed(name, np.dstack([data, opacity]) if data.shape[2:] == (3,) else data)
        for name, data in oracle.buffers.items()
    ]
    found = place(files, oracle).placements
    assert {name: each.surface.path.stem for name, each in found.items()} == {name: name for name in oracle.buffers}


def test_depths_that_are_tested_against_stand_back(oracle):
    close = oracle["depth"] * np.float32(1 - 2e-6)
    files = [unnamed("a", close, is_spare=True), unnamed("b", oracle["depth"])]
    assert place(files, oracle).placements["depth"].surface is files[1]
    assert place(files[:1], oracle).placements["depth"].surface is files[0]
