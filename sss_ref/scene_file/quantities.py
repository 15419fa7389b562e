"""What the tables of a scene file are made of. Whole numbers pass for numbers; true, text, nan and inf never do."""

from collections.abc import Callable
from typing import Annotated, Any, TypeVar

import numpy as np
from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Discriminator, Field, Tag

from sss_ref.errors.wording import unmet

MEMORY_LIMIT = 4 * 2**30  # bytes of buffers and pictures at one time
TEXEL_BYTES = 12  # of a decoded picture: three channels, float32
LARGEST_SIZE = 16384  # pixels: snapped window positions stay within 32 bits
STRONGEST = 1000  # times that a normal map bends more than it says
MOST_STOPS = 20  # a factor of a million, either way
FLOAT32_OVERFLOW = 2.0**128 - 2.0**103  # the smallest magnitude that rounds to infinity in float32


def requiring(holds: Callable[[Any], bool], expected: str, remedy: str = "choose another value") -> AfterValidator:
    """A validator that lets through what `holds`, and otherwise says what was expected."""

    def validate(value: Any) -> Any:
        if not holds(value):
            raise unmet(expected, remedy)
        return value

    return AfterValidator(validate)


def counting(least: int, most: int, expected: str, remedy: str) -> AfterValidator:
    """A validator of an array by its length, which is what it says came: the elements may be tables, filled by now."""

    def validate(value: Any) -> Any:
        if not least <= len(value) <= most:
            raise unmet(expected, remedy, str(len(value)))
        return value

    return AfterValidator(validate)


def _three_times(value: Any) -> Any:
    """A single number, and not a bool, stands for the same number on every axis."""
    return (value,) * 3 if isinstance(value, int | float) and not isinstance(value, bool) else value


Number = Annotated[float, requiring(lambda x: abs(x) < FLOAT32_OVERFLOW, "a number that fits float32")]
NonNegative = Annotated[Number, requiring(lambda x: x >= 0, "a number >= 0")]
Positive = Annotated[Number, requiring(lambda x: np.float32(x) > 0, "a number > 0 (in float32)")]
PositiveOrZero = Annotated[Number, requiring(lambda x: x == 0 or np.float32(x) > 0, "a number >= 0")]
Inset = Annotated[Positive, requiring(lambda x: x <= 1, "a number > 0 and <= 1")]
Strength = Annotated[NonNegative, requiring(lambda x: x <= STRONGEST, f"a number from 0 to {STRONGEST}")]
Texels = Annotated[NonNegative, requiring(lambda x: x <= LARGEST_SIZE, f"a number from 0 to {LARGEST_SIZE}")]
Share = Annotated[Number, requiring(lambda x: 0 <= x <= 1, "a number from 0 to 1")]
FieldOfView = Annotated[Number, requiring(lambda x: 0 < x < 180, "an angle between 0 and 180 degrees")]
Stops = Annotated[Number, requiring(lambda x: abs(x) <= MOST_STOPS, f"from -{MOST_STOPS} to {MOST_STOPS} stops")]
Size = Annotated[int, requiring(lambda n: 1 <= n <= LARGEST_SIZE, f"a whole number from 1 to {LARGEST_SIZE}")]
Count = Annotated[int, requiring(lambda n: 0 <= n <= LARGEST_SIZE, f"a whole number from 0 to {LARGEST_SIZE}")]

# TOML has arrays only, so tuples take any sequence; their elements stay strict.
Vector = Annotated[tuple[Number, Number, Number], Field(strict=False)]
Color = Annotated[tuple[NonNegative, NonNegative, NonNegative], Field(strict=False)]
Direction = Annotated[Vector, requiring(any, "a vector that is not zero")]
Scale = Annotated[Vector, BeforeValidator(_three_times), requiring(all, "factors that are not zero")]
GaussianRow = Annotated[tuple[Positive, Number, Number, Number], Field(strict=False)]
TapRow = Annotated[tuple[Number, Number, Number, Number, Number], Field(strict=False)]

N = TypeVar("N")
OneOrThree = Annotated[  # one number for all channels, or red, green and blue
    Annotated[N, Tag("one")] | Annotated[tuple[N, N, N], Field(strict=False), Tag("three")],
    Discriminator(lambda value: "three" if isinstance(value, list | tuple) else "one"),
]


class Table(BaseModel):
    """What all tables share; what checks a table is built when one of its kind is read first."""

    model_config = ConfigDict(
        strict=True,
        defer_build=True,
        extra="forbid",
        frozen=True,
        allow_inf_nan=False,
        validate_default=True,
    )
