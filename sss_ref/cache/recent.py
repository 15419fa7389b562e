"""What was read from files a moment ago, given again while the files hold the same: a scene is often loaded anew."""

import hashlib
from collections import OrderedDict
from collections.abc import Callable, Hashable
from functools import wraps
from pathlib import Path
from threading import Lock
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

LIMIT = 2**28  # bytes of arrays that are kept of each kind

T = TypeVar("T")


class Recent(Generic[T]):
    """The values that were kept last, as many as take no more than `limit` bytes together."""

    def __init__(self, limit: int = LIMIT) -> None:
        self._limit, self._bytes = limit, 0
        self._kept: OrderedDict[Hashable, tuple[int, T]] = OrderedDict()
        self._lock = Lock()

    def get(self, key: Hashable) -> T | None:
        """The value of a key, which is the last used from now on; None if it is not kept."""
        with self._lock:
            if key not in self._kept:
                return None
            self._kept.move_to_end(key)
            return self._kept[key][1]

    def keep(self, key: Hashable, value: T, size: int) -> None:
        """Keep a value of so many bytes, and let the longest unused go for it."""
        with self._lock:
            self._bytes += size - self._kept.pop(key, (0, None))[0]
            self._kept[key] = size, value
            while self._bytes > self._limit:
                self._bytes -= self._kept.popitem(last=False)[1][0]


def file_hash(path: Path) -> str | None:
    """SHA-256 in hexadecimal of a file's content; None for what is no regular file, too large, or cannot be read."""
    try:
        is_read = path.is_file() and path.stat().st_size <= LIMIT
        return hashlib.sha256(path.read_bytes()).hexdigest() if is_read else None
    except (OSError, ValueError):
        return None


def of_unchanged_file(read: Callable[[Path], NDArray[Any]]) -> Callable[[Path], NDArray[Any]]:
    """Have a function that reads an array from a file give it again, as a copy, while the file is the same."""
    recent: Recent[NDArray[Any]] = Recent()

    @wraps(read)
    def again(path: Path) -> NDArray[Any]:
        key = path.suffix, file_hash(path)
        kept = recent.get(key)
        if kept is not None:
            return kept.copy()
        array = read(path)
        if None not in key and file_hash(path) == key[1]:
            recent.keep(key, np.array(array), array.nbytes)
        return array

    return again
