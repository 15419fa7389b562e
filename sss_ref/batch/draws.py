"""The values that a key of a scene takes: a list, evenly spaced numbers, or numbers drawn at random.

Random numbers are counter-based: the bits of a draw are a hash of the sweep's seed, the key, the item's number and the
place of the draw within it. No item depends on another one, and + - * / and sqrt alone make a value of the bits, so
every machine draws the same.
"""

import hashlib
import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Tag, ValidationInfo, field_validator

from sss_ref.errors.wording import unmet
from sss_ref.scene_file.quantities import FLOAT32_OVERFLOW, Positive, Table, Vector, requiring

MOST = 10**6  # values of one key
WholeNumber = Annotated[int, requiring(lambda n: abs(n) < 2**31, "a whole number below 2^31")]
AnyNumber = Annotated[Any, requiring(lambda value: _is_number(value), "a number")]  # whole ones stay whole
NumberOrThree = Annotated[
    Any,
    requiring(
        lambda value: (
            _is_number(value) or (isinstance(value, list) and len(value) == 3 and all(map(_is_number, value)))
        ),
        "a number, or an array of three",
    ),
]

SceneValue = Annotated[
    Any, requiring(lambda value: _all_finite(value), "finite numbers", "nan and inf are not accepted")
]
"""What a key of a scene may be given, as far as that can be told without the scene."""

Chances = Iterator[float]
"""Independent numbers, uniform from 0 to 1, without 1: multiples of 2^-53."""


def chances(seed: int, key: str, item: int) -> Chances:
    """The random numbers of an item's key, without end."""
    place = 0
    while True:
        digest = hashlib.sha256(f"sss_ref draw 1\n{seed}\n{key}\n{item}\n{place}\n".encode()).digest()
        yield (int.from_bytes(digest[:8], "big") >> 11) / 2**53
        place += 1


class Spaced(Table):
    """Evenly spaced numbers, both ends among them; whole ones where both ends and the value are."""

    first: AnyNumber
    """The first value."""
    last: AnyNumber
    """The last value."""
    count: Annotated[int, requiring(lambda n: 2 <= n <= MOST, f"a whole number from 2 to {MOST}")]
    """How many values."""

    @property
    def values(self) -> tuple[float, ...]:
        """first + (last - first) * i / (count - 1), rounded once."""
        start, step = Fraction(self.first), (Fraction(self.last) - Fraction(self.first)) / (self.count - 1)
        whole = isinstance(self.first, int) and isinstance(self.last, int)
        exact = (start + step * number for number in range(self.count))
        return tuple(int(value) if whole and value.denominator == 1 else float(value) for value in exact)


class Uniform(Table):
    """Every number from low to high as likely as any other; of three numbers each for itself."""

    random: Literal["uniform"]
    low: NumberOrThree
    """The least value."""
    high: NumberOrThree
    """The greatest value, of the same form."""

    @field_validator("high")
    @classmethod
    def _of_one_form(cls, high: Any, info: ValidationInfo) -> Any:
        return _same_form(high, info)

    def drawn(self, numbers: Chances) -> Any:
        """low + u * (high - low)."""
        return _each(self.low, self.high, lambda low, high: low + next(numbers) * (high - low))


class LogUniform(Table):
    """The logarithm uniform from low to high: every factor as likely as any other."""

    random: Literal["log_uniform"]
    low: Positive
    """The least value."""
    high: Positive
    """The greatest value."""

    def drawn(self, numbers: Chances) -> float:
        """low * (high / low)^u, rounded once."""
        from mpmath import mp, mpf

        with mp.workdps(50):
            return float(mpf(self.low) * (mpf(self.high) / mpf(self.low)) ** mpf(next(numbers)))


class Whole(Table):
    """Every whole number from low to high, both among them, as likely as any other."""

    random: Literal["integer"]
    low: WholeNumber
    """The least value."""
    high: WholeNumber
    """The greatest value."""

    @field_validator("high")
    @classmethod
    def _not_below(cls, high: int, info: ValidationInfo) -> int:
        if high < info.data.get("low", high):
            raise unmet(f"a number >= low = {info.data['low']}", "exchange the two")
        return high

    def drawn(self, numbers: Chances) -> int:
        """low + floor(u * how many there are)."""
        return self.low + math.floor(next(numbers) * (self.high - self.low + 1))


class Choice(Table):
    """One of some values, each as likely as any other."""

    random: Literal["choice"]
    values: Annotated[list[SceneValue], requiring(len, "at least one value")]
    """What is chosen from."""

    def drawn(self, numbers: Chances) -> Any:
        """values[floor(u * how many there are)]."""
        return self.values[math.floor(next(numbers) * len(self.values))]


class OnSphere(Table):
    """A point of a sphere, uniform over its area (Marsaglia 1972): for the position of a light or an eye."""

    random: Literal["sphere"]
    radius: Positive
    """Of the sphere, scene units."""
    center: Vector = (0.0, 0.0, 0.0)
    """Of the sphere."""

    def drawn(self, numbers: Chances) -> list[float]:
        """A point (x, y) of the unit disc, uniform, laid onto the sphere."""
        while True:
            x, y = (2 * next(numbers) - 1 for _ in range(2))
            square = x * x + y * y
            if square < 1:
                break
        slope = 2 * math.sqrt(1 - square)
        unit = (slope * x, slope * y, 1 - 2 * square)
        return [middle + self.radius * part for middle, part in zip(self.center, unit, strict=True)]


Random = Uniform | LogUniform | Whole | Choice | OnSphere
Listed = Annotated[list[SceneValue], requiring(lambda values: 1 <= len(values) <= MOST, f"1 to {MOST} values")]


def form_of(value: Any) -> str:
    """Which form a key's values have, in a file or read from it: a list, spaced, or the name of a distribution."""
    if isinstance(value, Table):
        return str(getattr(value, "random", "spaced"))
    return str(value.get("random", "spaced")) if isinstance(value, dict) else "list"


Values = Annotated[
    Annotated[Listed, Tag("list")]
    | Annotated[Spaced, Tag("spaced")]
    | Annotated[Uniform, Tag("uniform")]
    | Annotated[LogUniform, Tag("log_uniform")]
    | Annotated[Whole, Tag("integer")]
    | Annotated[Choice, Tag("choice")]
    | Annotated[OnSphere, Tag("sphere")],
    Discriminator(form_of),
]


def _is_number(value: Any) -> bool:
    return type(value) in (int, float) and abs(value) < FLOAT32_OVERFLOW


def _all_finite(value: Any) -> bool:
    """Whether a value has nothing infinite in it, and no NaN."""
    if isinstance(value, float):
        return math.isfinite(value)
    parts = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return all(map(_all_finite, parts))


def _same_form(high: Any, info: ValidationInfo) -> Any:
    if isinstance(info.data.get("low", high), list) != isinstance(high, list):
        raise unmet("a number or three, as low has", "give both in one form")
    return high


def _each(low: Any, high: Any, value: Callable[[float, float], float]) -> Any:
    """The value of two numbers, or of each two of three."""
    return [value(*pair) for pair in zip(low, high, strict=True)] if isinstance(low, list) else value(low, high)
