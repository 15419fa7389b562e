"""A RenderDoc capture: what its draws left behind, as NPY files.

It is replayed by RenderDoc's own Python module, in a process of its own: the module belongs to one Python of the
machine, which need not be the one that runs this.
"""

import json
import os
import subprocess
import sys
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from sss_ref.capture.replay import DEPTH
from sss_ref.capture.surfaces import Unnamed
from sss_ref.dump.encoding import READ_AS
from sss_ref.dump.files import parts_of
from sss_ref.dump.texels import StoredTexels, array_texels
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import check_regular
from sss_ref.errors.wording import told

SUFFIX, MAGIC = ".rdc", b"RDOC"
SCRIPT = Path(__file__).with_name("replay.py")
HEADLESS = {"EGL_PLATFORM": "surfaceless"}  # without it Mesa gives a replay no OpenGL where there is no display
SECONDS = 600  # for a replay
REMEDY = "install python3-renderdoc (Debian), or export the targets into a folder and give that with --auto"
DAMAGED = ("a whole RenderDoc capture", "one that is damaged or cut off", "capture it again")
REASONS = {  # RenderDoc's code -> what was expected, what came, what to do
    **dict.fromkeys(("FileCorrupted", "FileIOFailed", "APIDataCorrupted"), DAMAGED),
    "APIReplayFailed": ("a capture that replays to its end", "one cut off, or beyond this driver", "capture it again"),
    "APIIncompatibleVersion": ("a capture of RenderDoc {version} or older", "another", "capture it with that version"),
    "FileIncompatibleVersion": ("a capture of RenderDoc {version} or older", "another", "capture it with that version"),
    "APIHardwareUnsupported": ("a capture that this machine can replay", "another", "replay it where it was made"),
    "APIInitFailed": ("a driver that replays {driver}", "none", "install Mesa's (Debian: libegl1 mesa-vulkan-drivers)"),
}
UNORM24 = 2**24 - 1
LOWEST_BIT = {"OpenGL": 8, "Vulkan": 0}  # of a depth of 24 bits in its 32


def is_capture(path: Path | None) -> bool:
    """Whether a path is that of a capture, by its suffix."""
    return path is not None and path.suffix.lower() == SUFFIX


def captured(path: Path, folder: Path) -> tuple[list[Unnamed], list[str]]:
    """The pictures of a capture, written into a folder, in the order in which they were drawn, and what was left out.

    Raises DumpError for what is no capture, or cannot be replayed here, or draws nothing.
    """
    _check(path)
    with TemporaryDirectory() as work:
        report = _replayed(path, Path(work))
        found, notes = [], []
        for known in report["pictures"]:
            try:
                found.append(_picture(known, path, Path(work), folder))
            except DumpError as error:
                notes.append(str(error))
    if not found:
        raise DumpError(
            told(str(path), "draws into a picture", "none that can be read", "capture the frame that draws")
        )
    return found, notes


def _check(path: Path) -> None:
    """Raise DumpError for a file that does not begin as captures do."""
    check_regular(path, "a RenderDoc capture", DumpError)
    with path.open("rb") as file:
        head = file.read(len(MAGIC))
    if head != MAGIC:
        raise DumpError(told(str(path), "a RenderDoc capture", "another file", "check the path"))


def _replayed(path: Path, work: Path) -> dict[str, Any]:
    """What the replay says of a capture. Raises DumpError where it cannot be replayed."""
    python = renderdoc_python()
    if python is None:
        raise DumpError(told(str(path), "RenderDoc's Python module to replay it", "none", REMEDY))
    command = [python, str(SCRIPT), str(path), str(work)]
    try:
        ended = subprocess.run(
            command, env=_environment(), capture_output=True, timeout=SECONDS, check=False
        ).returncode
    except subprocess.TimeoutExpired:
        raise DumpError(told(str(path), f"a replay within {SECONDS} s", "none", "capture a smaller frame")) from None
    if ended:
        expected, came = "a capture that RenderDoc can replay", f"one on which it ends with code {ended}"
        raise DumpError(told(str(path), expected, came, "open it in RenderDoc, and export its targets"))
    report: dict[str, Any] = json.loads((work / "pictures.json").read_text(encoding="utf-8"))
    if report["error"]:
        raise DumpError(_reason(path, report))
    return report


def _reason(path: Path, report: Mapping[str, Any]) -> str:
    """Why RenderDoc does not replay a capture."""
    other = ("a capture that can be replayed here", report["error"], "open it in RenderDoc, and export its targets")
    expected, came, remedy = REASONS.get(report["error"], other)
    facts = {"version": report["version"], "driver": report.get("driver", "it")}
    return told(str(path), expected.format(**facts), came, remedy)


@cache
def renderdoc_python() -> str | None:
    """A Python that has RenderDoc's module: this one, or the system's; None where neither has."""
    for python in (sys.executable, "/usr/bin/python3"):
        try:
            tried = subprocess.run(
                [python, "-c", "import renderdoc"], env=_environment(), capture_output=True, check=False
            )
        except OSError:
            continue
        if tried.returncode == 0:
            return python
    return None


def _environment() -> dict[str, str]:
    """Without the paths of this Python, and without a window where there is no display."""
    own = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    return own if {"DISPLAY", "WAYLAND_DISPLAY"} & own.keys() else HEADLESS | own


def _picture(known: Mapping[str, Any], path: Path, work: Path, folder: Path) -> Unnamed:
    """One picture as an NPY file, the bottom row first. Raises DumpError where it cannot be read."""
    where = f"{path}: event {known['event']}, target {known['target']}"
    if known["samples"] > 1:
        came, remedy = f"{known['samples']} samples a pixel", "resolve it, and draw with that"
        raise DumpError(told(where, "one sample a pixel", came, remedy))
    texels = _in_order(_texels(known, work, where))
    file = folder / f"{Path(known['file']).stem}.npy"
    upright = np.ascontiguousarray(texels.data[::-1])
    np.save(file, upright)
    held = array_texels(file, upright).storage
    given = {"encoding": texels.storage} if texels.storage != held and texels.storage in READ_AS.get(held, ()) else {}
    is_spare = known["target"] == DEPTH
    return Unnamed(file, replace(texels, data=upright), labels=_labels(known), is_spare=is_spare, given=given)


def _texels(known: Mapping[str, Any], work: Path, where: str) -> StoredTexels:
    file = work / known["file"]
    if file.suffix == ".dds":
        return parts_of(file)[0]
    width, height = known["size"]
    data = np.fromfile(file, np.uint8)
    if known["format"] != "D24" or known["api"] not in LOWEST_BIT or data.size != 4 * width * height:
        remedy = "export it by hand, and give the folder with --auto"
        raise DumpError(told(where, "a format that DDS files have, or D24", known["format"], remedy))
    depth = (data.view("<u4") >> LOWEST_BIT[known["api"]] & UNORM24) / UNORM24
    return StoredTexels(depth.astype(np.float32).reshape(height, width, 1)[::-1], ("R",), "float32")


def _in_order(texels: StoredTexels) -> StoredTexels:
    """With the channels from red to alpha, as an array has them."""
    names = [name for name in "RGBA" if name in texels.channels]
    if len(names) < len(texels.channels):
        return replace(texels, channels=tuple("RGBA"[: len(texels.channels)]))
    return replace(
        texels, data=texels.data[..., [texels.channels.index(name) for name in names]], channels=tuple(names)
    )


def _labels(known: Mapping[str, Any]) -> tuple[str, ...]:
    """What the texture is called, and the debug group around the draw."""
    return (known["name"], *known["groups"][-1:])


def listing(pictures: Iterable[Unnamed]) -> Iterator[str]:
    """The pictures of a capture as lines."""
    for each in pictures:
        width, height = each.size
        channels = f"{len(each.channels)} channel{'s' if len(each.channels) > 1 else ''}"
        yield f"{each.path.name}: {width} x {height}, {channels}, {each.texels.storage}, {each.labels[0]}"
