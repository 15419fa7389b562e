"""Memory of buffers that are gone, kept for the next ones: what a system hands out anew it clears first, page by page.

It is of use to whoever renders again and again in one process. The largest buffers are never kept.
"""

import ctypes
import weakref
from math import prod
from threading import RLock
from typing import Any

import numpy as np

LARGEST = 192 * 2**20  # bytes of a buffer whose memory is kept: three channels of 4096^2
SMALLEST = 2**20  # bytes; smaller ones cost less than the search
MOST = 1280 * 2**20  # bytes kept: all of an image of 4096^2; those longest unused are let go first


class Spare:
    """Blocks of memory that nobody uses, those longest unused first; most: bytes that are kept."""

    def __init__(self, most: int = MOST) -> None:
        self.blocks: list[np.ndarray] = []
        self.most = most
        self.lock = RLock()  # memory may come back while a thread looks for some

    def empty(self, shape: tuple[int, ...], dtype: Any) -> np.ndarray:
        """An array as `np.empty` gives it; its memory comes back when no array has a part in it any more."""
        size = prod(shape) * np.dtype(dtype).itemsize
        if not SMALLEST <= size <= LARGEST:
            return np.empty(shape, dtype)
        block = self.taken(size)
        owner = (ctypes.c_uint8 * size).from_buffer(block)  # no array, or views of views would let go of it
        weakref.finalize(owner, self.give_back, block).atexit = False
        return np.frombuffer(owner, dtype).reshape(shape)  # each view keeps the owner alive

    def taken(self, size: int) -> np.ndarray:
        """A block of so many bytes, the one used last if there are several."""
        with self.lock:
            fitting = [block for block in self.blocks if block.nbytes == size]
            self.blocks = [block for block in self.blocks if block is not fitting[-1]] if fitting else self.blocks
        return fitting[-1] if fitting else np.empty(size, np.uint8)

    def give_back(self, block: np.ndarray) -> None:
        """Keep a block, and let go those longest unused beyond `most`."""
        with self.lock:
            self.blocks.append(block)
            while sum(each.nbytes for each in self.blocks) > self.most:
                del self.blocks[0]


SPARE = Spare()
