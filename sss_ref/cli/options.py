"""What several commands have in common: overrides of the scene, and how its stages are run."""

import re
import tomllib
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from sss_ref.errors import SceneError

if TYPE_CHECKING:
    from sss_ref.validation.scope import Scope


@Parameter(name="*")
@dataclass(frozen=True)
class Changes:
    """What is put on top of the scene file."""

    set: Annotated[tuple[str, ...], Parameter(negative="", consume_multiple=False, show_default=False)] = ()
    """Override one value, such as `camera.width=512` or `lights.0.intensity=2`; may be given several times."""
    preset: str | None = None
    """The preset that fills what the scene leaves out."""
    method: str | None = None
    """How light is diffused: screen_space, texture_space, separable, burley,
    preintegrated or gaussian_texture."""
    size: str | None = None
    """Size of the image, such as 512x512."""

    def overrides(self) -> dict[str, Any]:
        """The overrides that `load_scene` takes, by dotted key."""
        chosen = {key: value for key in ("preset", "method") if (value := getattr(self, key)) is not None}
        return {**chosen, **_size(self.size), **dict(map(_assignment, self.set))}


@Parameter(name="*")
@dataclass(frozen=True)
class Execution:
    """How the stages are run; the bits are the same."""

    interpreter: Literal["kernel", "arrays"] = "kernel"
    """Compiled kernels, or plain NumPy."""
    threads: Annotated[int | None, Parameter(show_default=False)] = None
    """How many share the work; one per processor if not given."""

    def __post_init__(self) -> None:
        if self.threads is not None and self.threads < 1:
            raise SceneError(f"--threads: expected at least 1, got {self.threads}; leave it out for one per processor")


@Parameter(name="*")
@dataclass(frozen=True)
class Wanted:
    """Which buffers come out."""

    keep: Annotated[Literal["all", "final"] | None, Parameter(show_default=False)] = None
    """Write all buffers, which is the default, or the final image alone."""
    until: str | None = None
    """Stop after a pass, a stage or a buffer."""
    samples: int = 1
    """Average N x N renderings, each moved by a part of a pixel; writes the image alone."""

    def __post_init__(self) -> None:
        if self.until and self.keep == "final":
            raise SceneError("--until: expected without --keep final, got both; the final image needs every stage")
        if self.samples != 1 and (self.until or self.keep == "all"):
            raise SceneError(
                "--samples: expected without --until and --keep all, got both; only the final image is averaged"
            )


@Parameter(name="*")
@dataclass(frozen=True)
class Haste:
    """What validating leaves out, or does besides."""

    only: Annotated[str | None, Parameter(show_default=False)] = None
    """Judge a single stage, by name, or the rasterizer."""
    quick: Annotated[bool, Parameter(negative="")] = False
    """Look for an explanation for a second at most, and not for how small an error would be seen."""
    power: Annotated[bool | None, Parameter(negative="--no-power", show_default=False)] = None
    """Work out how small an error would be seen; done for a report unless --quick or --no-power says otherwise."""

    def scope(self, reported: bool) -> "Scope":
        """How far `judge` goes. reported: whether a report is written."""
        from sss_ref.validation.scope import FULL, QUICK

        scope = QUICK if self.quick else FULL
        power = self.power if self.power is not None else scope.power and reported
        return replace(scope, stage=self.only, power=power)


# what walks through a body take
Medium = Annotated[
    str | None, Parameter(show_default=False, help="What the body is made of, such as skin1; else its material.")
]
TimeLimit = Annotated[
    float | None, Parameter(show_default=False, help="Begin no sample of the truth after so many seconds.")
]
Threads = Annotated[int | None, Parameter(show_default=False, help="One per processor if not given.")]

NO_CHANGES, KERNELS, EVERYTHING, NO_HASTE = Changes(), Execution(), Wanted(), Haste()


def _size(text: str | None) -> dict[str, int]:
    """The camera's overrides for WIDTHxHEIGHT."""
    if text is None:
        return {}
    sides = re.fullmatch(r"(\d{1,9})[xX](\d{1,9})", text)
    if not sides:
        raise SceneError(f"--size: expected WIDTHxHEIGHT, got {text[:60]!r}; write it as 512x512")
    return {"camera.width": int(sides[1]), "camera.height": int(sides[2])}


def _assignment(text: str) -> tuple[str, Any]:
    """The key and value of `key.path=value`; a value that is not TOML is taken as text. Raises SceneError."""
    from sss_ref.errors.text_file import toml_in
    from sss_ref.errors.wording import told

    key, equals, value = text.partition("=")
    if not (equals and key):
        raise SceneError(f"--set: expected key.path=value, got {text!r}; write it as camera.width=512")
    try:
        tables = toml_in(f"value = {value}")
    except tomllib.TOMLDecodeError:
        return key, value
    except (ValueError, RecursionError):
        tables = {}
    if len(tables) != 1:
        raise SceneError(told("--set", f"one value for {key}", value, "write it as camera.width=512"))
    return key, tables["value"]
