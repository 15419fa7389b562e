"""The pictures of a capture, from what a replay wrote: no capture is replayed."""

import numpy as np
import pytest

from sss_ref.capture import renderdoc_file
from sss_ref.dump.texels import StoredTexels
from sss_ref.errors import DumpError

KNOWN = {
    "event": 7,
    "target": "depth",
    "samples": 1,
    "file": "7-depth.bin",
    "size": [2, 2],
    "format": "D24",
    "api": "OpenGL",
    "name": "the depth",
    "groups": ["frame", "camera"],
}
WORDS = np.array([0xFFFFFF12, 0x80000034, 0x00000056, 0x00000100], "<u4")  # the lower row first
DEPTHS = {  # of OpenGL the upper 24 bits, of Vulkan the lower ones
    "OpenGL": [[0xFFFFFF, 0x800000], [0, 1]],
    "Vulkan": [[0xFFFF12, 0x34], [0x56, 0x100]],
}


@pytest.mark.parametrize("api", DEPTHS)
def test_depths_of_24_bits(tmp_path, api):
    """Rows as they come; a picture that is tested against stands back."""
    (tmp_path / "7-depth.bin").write_bytes(WORDS.tobytes())
    folder = tmp_path / "kept"
    folder.mkdir()
    found = renderdoc_file._picture({**KNOWN, "api": api}, tmp_path / "a.rdc", tmp_path, folder)
    assert (np.rint(np.load(found.path)[..., 0].astype(float) * (2**24 - 1)) == DEPTHS[api]).all()
    assert (found.path.name, found.labels, found.is_spare, dict(found.given)) == (
        "7-depth.npy",
        ("the depth", "camera"),
        True,
        {},
    )
    assert list(renderdoc_file.listing([found])) == ["7-depth.npy: 2 x 2, 1 channel, float32, the depth"]


@pytest.mark.parametrize(
    ("changes", "data"),
    [({"format": "D24S9"}, WORDS), ({"api": "D3D11"}, WORDS), ({}, WORDS[:3]), ({"size": [2, 1]}, WORDS)],
)
def test_what_is_stored_otherwise_is_refused(tmp_path, changes, data):
    (tmp_path / "7-depth.bin").write_bytes(data.tobytes())
    with pytest.raises(
        DumpError, match=r"a\.rdc: event 7, target depth: expected a format that DDS files have, or D24"
    ):
        renderdoc_file._picture(KNOWN | changes, tmp_path / "a.rdc", tmp_path, tmp_path)


def test_a_picture_of_several_samples_is_refused(tmp_path):
    with pytest.raises(DumpError, match="expected one sample a pixel, got 2 samples a pixel; resolve it"):
        renderdoc_file._picture(KNOWN | {"samples": 2}, tmp_path / "a.rdc", tmp_path, tmp_path)


@pytest.mark.parametrize(
    ("channels", "first", "names"),
    [
        ("BGRA", [2, 1, 0, 3], "RGBA"),
        ("RGB", [0, 1, 2], "RGB"),
        ("RG", [0, 1], "RG"),
        ("A", [0], "A"),
        ("BGRX", [0, 1, 2, 3], "RGBA"),
    ],
)
def test_channels_run_from_red_to_alpha(channels, first, names):
    data = np.arange(len(channels), dtype=np.uint8).reshape(1, 1, -1)
    found = renderdoc_file._in_order(StoredTexels(data, tuple(channels), "unorm8"))
    assert (found.data[0, 0].tolist(), "".join(found.channels)) == (first, names)


def test_why_a_capture_is_not_replayed(tmp_path):
    path = tmp_path / "a.rdc"
    older, mesa = "expected a capture of RenderDoc 1.2 or older, got another", "libegl1 mesa-vulkan-drivers"
    said = {
        "FileCorrupted": "expected a whole RenderDoc capture, got one that is damaged or cut off; capture it again",
        "APIIncompatibleVersion": f"{older}; capture it with that version",
        "APIInitFailed": f"expected a driver that replays Vulkan, got none; install Mesa's (Debian: {mesa})",
        "Odd": "expected a capture that can be replayed here, got Odd; open it in RenderDoc, and export its targets",
    }
    for error, words in said.items():
        report = {"error": error, "version": "1.2", "driver": "Vulkan"}
        assert renderdoc_file._reason(path, report) == f"{path}: {words}"


@pytest.mark.parametrize("display", ["DISPLAY", "WAYLAND_DISPLAY", ""])
def test_without_a_display_a_replay_needs_no_surface_and_never_our_paths(monkeypatch, display):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "EGL_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    if display:
        monkeypatch.setenv(display, ":0")
    monkeypatch.setenv("PYTHONPATH", "here")
    found = renderdoc_file._environment()
    assert found.get("EGL_PLATFORM") == (None if display else "surfaceless") and "PYTHONPATH" not in found


@pytest.mark.parametrize(("name", "is_one"), [("a.rdc", True), ("a.RDC", True), ("a.dds", False)])
def test_a_capture_by_its_suffix(tmp_path, name, is_one):
    assert renderdoc_file.is_capture(tmp_path / name) is is_one
    assert renderdoc_file.is_capture(None) is False
