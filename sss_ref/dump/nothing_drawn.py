"""The pixels on which nothing is drawn, where a file says so in its own way: they get the scene's background."""

from collections.abc import Mapping

import numpy as np

from sss_ref.dump.convert import Converted
from sss_ref.dump.slots import Slot
from sss_ref.rendering.fold import render
from sss_ref.scene.scene import Scene

Cleared = tuple[np.ndarray, list[str]]  # a buffer, and what was done to it


def cleared(found: Mapping[str, Converted], slots: Mapping[str, Slot], scene: Scene) -> dict[str, Cleared]:
    """The buffers with the scene's background where their files have no texels, or what their mapping calls background.

    What is called background counts where the dump's own mask says that nothing is drawn, or else the scene's mask.
    """
    masked = {slots[name].mask for name, buffer in found.items() if buffer.empty is not None}
    missing = {mask for mask in masked if mask not in found or found[mask].empty is not None}
    own = render(scene, keep=missing).buffers if missing else {}
    masks = {name: _outside(found, name) for name in masked - missing} | dict(own)
    results = {}
    for name, buffer in found.items():
        clear, data, notes = scene.clear(name), buffer.data, []
        if buffer.outside is not None:
            data = _with(data, buffer.outside, clear)
        mask = slots[name].mask
        if buffer.empty is not None:
            data = _with(data, buffer.empty & _shows_nothing(masks[mask]), clear)
            whose = "the scene's, as the dump has none" if mask in missing else "the dump's"
            notes.append(f"its background is taken where {mask} says that nothing is drawn ({whose})")
        results[name] = data, notes
    return results


def _outside(found: Mapping[str, Converted], name: str) -> np.ndarray:
    """A mask of the dump, empty where its file has no texels."""
    buffer = found[name]
    nothing = 0 if buffer.data.dtype.kind == "u" else -1
    return buffer.data if buffer.outside is None else np.where(buffer.outside, nothing, buffer.data)


def _shows_nothing(mask: np.ndarray) -> np.ndarray:
    """Bool (H, W) of a coverage, 0 or 1, or of triangle numbers, -1 for none."""
    return mask == 0 if mask.dtype == np.uint8 else mask < 0


def _with(data: np.ndarray, where: np.ndarray, clear: object) -> np.ndarray:
    result = data.copy()
    result[where] = clear
    return result
