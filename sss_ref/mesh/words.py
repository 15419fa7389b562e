"""The words of a text file, found for the whole text at once: what stands between blanks, comments left out.

OBJ, MTL, OFF and the text forms of PLY and STL are words on lines. A million triangles are some ten million words, so
they are kept as places in the text, and numbers are read in bulk.
"""

import re
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

IntArray = NDArray[np.int32]
Mask = NDArray[np.bool_]

BLANK = np.zeros(256, bool)
BLANK[[9, 10, 11, 12, 13, 32]] = True
NUMBER = re.compile(rb"[+-]?(?:(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|inf|nan|infinity)", re.IGNORECASE)
WHOLE = re.compile(rb"[+-]?\d+")
UTF8_MARK = b"\xef\xbb\xbf"
UTF16_MARKS = (b"\xff\xfe", b"\xfe\xff")


@dataclass(frozen=True, eq=False)
class Words:
    """A text and where its words are."""

    text: bytes  # lines end with \n
    starts: IntArray  # (W,): the first byte of each word
    ends: IntArray  # (W,): the byte behind it
    line: IntArray  # (W,): the line it stands on, from 0

    @classmethod
    def of(cls, text: bytes, comments: bool = True) -> "Words":
        """The words of a text in one line form (`plain`). comments: from # to the end of a line."""
        letters = np.frombuffer(text, np.uint8)
        blank = BLANK[letters]
        if comments and b"#" in text:
            blank |= _commented(letters)
        edges = np.flatnonzero(np.diff(np.concatenate([[True], blank, [True]])))
        starts, ends = edges[::2].astype(np.int32), edges[1::2].astype(np.int32)
        breaks = np.flatnonzero(letters == 10)
        return cls(text, starts, ends, np.searchsorted(breaks, starts).astype(np.int32))

    def __len__(self) -> int:
        return len(self.starts)

    def __getitem__(self, number: int) -> bytes:
        return self.text[self.starts[number] : self.ends[number]]

    @cached_property
    def heads(self) -> NDArray[np.int64]:
        """The first word of each line that has any (L,)."""
        return np.flatnonzero(np.diff(self.line, prepend=-1))

    @cached_property
    def counts(self) -> NDArray[np.int64]:
        """How many words those lines have (L,)."""
        return np.diff(self.heads, append=len(self))

    def are(self, word: bytes, among: NDArray[np.int64]) -> Mask:
        """Which of the words `among` (numbers of words) are this one, in whatever case."""
        found = self.ends[among] - self.starts[among] == len(word)
        letters = np.frombuffer(self.text, np.uint8)
        for at, letter in enumerate(word.lower()):
            places = self.starts[among[found]] + at
            found[found] = (letters[places] | 32 if chr(letter).isalpha() else letters[places]) == letter
        return found

    def only(self, chosen: Mask) -> bytes:
        """The stretch of the text that holds the chosen words (W,), with blanks in place of all else."""
        starts, ends = self.starts[chosen], self.ends[chosen]
        if not len(starts):
            return b""
        letters = np.frombuffer(self.text, np.uint8)[starts[0] : ends[-1]]
        steps = np.zeros(len(letters) + 1, np.int8)
        steps[starts - starts[0]] = 1
        steps[ends - starts[0]] -= 1
        kept = np.cumsum(steps[:-1], dtype=np.int8).view(bool)
        return np.where(kept, letters, np.uint8(32)).tobytes()

    def floats(self, chosen: Mask) -> NDArray[np.float64]:
        """The chosen words (W,) as numbers; NaN for those that are none."""
        return floats(self.only(chosen), int(np.count_nonzero(chosen)))

    def rest(self, head: int) -> bytes:
        """All that stands on a line behind its first word, blanks and # within included."""
        end = self.text.find(b"\n", self.ends[head])
        return self.text[self.ends[head] : end if end >= 0 else None].strip()


def plain(data: bytes) -> bytes:
    r"""A text without byte-order mark, its line ends \r\n and \r turned into \n."""
    data = data.removeprefix(UTF8_MARK)
    return data.replace(b"\r\n", b"\n").replace(b"\r", b"\n") if b"\r" in data else data


def floats(text: bytes, count: int) -> NDArray[np.float64]:
    """The `count` numbers in a text, (count,); NaN for words that are none."""
    numbers = _read(text, count, np.float64)
    return _one_by_one(text, NUMBER, float, np.nan) if numbers is None else numbers


def wholes(text: bytes, count: int, otherwise: int) -> NDArray[np.int64]:
    """The `count` whole numbers in a text, (count,); `otherwise` for words that are none.

    One that 64 bits do not hold becomes the largest or the smallest that they do.
    """
    numbers = _read(text, count, np.int64)
    if numbers is None:
        return _one_by_one(text, WHOLE, _whole, otherwise).astype(np.int64)
    return numbers


def named(raw: bytes) -> str:
    """A name in a file: UTF-8, or where it is not, one letter for each byte (Latin-1)."""
    try:
        return raw.decode()
    except UnicodeDecodeError:
        return raw.decode("latin-1")


def _commented(letters: NDArray[np.uint8]) -> Mask:
    """Which bytes belong to a comment: those from a # to the end of its line."""
    steps = np.zeros(len(letters), np.int64)
    ends = np.flatnonzero(letters == 10)
    marks = np.flatnonzero(letters == 35)
    line = np.searchsorted(ends, marks)
    first = marks[np.diff(line, prepend=-1) > 0]
    steps[first] += 1
    behind = ends[np.unique(line[line < len(ends)])]
    steps[behind] -= 1
    return np.cumsum(steps).astype(bool)


def _read(text: bytes, count: int, kind: type) -> NDArray[Any] | None:
    """`count` numbers of one kind, or None if not all that stands there can be read as such."""
    if not count:
        return np.zeros(0, kind)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            numbers: NDArray[Any] = np.fromstring(text, kind, sep=" ")
        except ValueError:
            return None
    return numbers if len(numbers) == count else None


def _one_by_one(
    text: bytes, form: re.Pattern[bytes], reading: Callable[[bytes], float], otherwise: float
) -> NDArray[Any]:
    return np.array([reading(word) if form.fullmatch(word) else otherwise for word in text.split()])


def _whole(word: bytes) -> int:
    return int(np.fromstring(word, np.int64, sep=" ")[0])
