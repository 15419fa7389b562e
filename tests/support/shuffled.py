"""Dumps whose files have no telling names: shuffled, turned upside down, with reversed channels."""

import random
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Hidden:
    """What a file really holds: a buffer, the row it begins with, and the file's channels in the buffer's order."""

    name: str
    origin: str
    channels: tuple[int, ...]


def hide(buffers, folder, seed, turned=0.0, reverse=0.0, lacking=0.0):
    """Write buffers as NPY files in a folder; file -> what it is.

    turned, reverse, lacking: the share of files that begin with the top row, of RGB files that hold BGR, and of buffers
    that are not written.
    """
    chance = random.Random(seed)
    names = [name for name in buffers if chance.random() >= lacking]
    chance.shuffle(names)
    truth = {}
    for number, name in enumerate(names):
        data, origin, channels = buffers[name], "bottom", (*range(np.dstack([buffers[name]]).shape[2]),)
        if chance.random() < turned:
            data, origin = data[::-1], "top"
        if len(channels) == 3 and chance.random() < reverse:
            data, channels = data[..., ::-1], channels[::-1]
        file = f"target_{number:02}.npy"
        np.save(folder / file, np.ascontiguousarray(data))
        truth[file] = Hidden(name, origin, channels)
    return truth


def misplaced(found, truth, buffers):
    """The wrong places of an `Arrangement`: another buffer, unless it has the same values; other rows or channels."""
    wrong = []
    for name, each in found.placements.items():
        right = truth.get(each.surface.path.name)
        if right is None or not _holds(buffers, name, each.candidate, right):
            wrong.append((each.surface.path.name, right, name, each.candidate))
    return wrong


def _holds(buffers, name, candidate, right):
    """Whether what is read as a buffer is what was written of it, or looks the same."""
    written = np.dstack([buffers[right.name]])
    stored = written[..., list(np.argsort(right.channels))]
    stored = stored[::-1] if right.origin == "top" else stored
    read = stored[..., list(candidate.channels)]
    read = read[::-1] if candidate.origin == "top" else read
    return np.array_equal(read, np.dstack([buffers[name]]))
