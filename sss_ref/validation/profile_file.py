"""Profiles by name, or from a TOML file: what a processor has other than the profile it is based on."""

import os
from collections.abc import Mapping
from dataclasses import fields, replace
from functools import cache
from pathlib import Path
from typing import Any, Literal, get_type_hints

from pydantic import BaseModel, ValidationError, create_model

from sss_ref.errors import ProfileError
from sss_ref.errors.text_file import toml_of
from sss_ref.errors.wording import described
from sss_ref.interpret.intervals.profile import PROFILES, Profile
from sss_ref.numerics.bounded import Bounded
from sss_ref.scene_file.quantities import Count, NonNegative, Table

DEFAULT_BASE = "vulkan"
CHECKED: dict[Any, Any] = {float: NonNegative, int: Count}  # what the numbers of a profile must be


def _keys_of(described_class: type) -> dict[str, Any]:
    """The fields of a dataclass that a file may give: name -> type and default, as pydantic takes them."""
    hints = get_type_hints(described_class)
    own = [field for field in fields(described_class) if "arithmetic" not in field.name]
    return {field.name: (CHECKED.get(hints[field.name], hints[field.name]), field.default) for field in own}


def _table(name: str, keys: Mapping[str, Any]) -> type[BaseModel]:
    return create_model(name, __base__=Table, **keys)


@cache
def _bounds_table() -> type[BaseModel]:
    return _table("BoundsTable", _keys_of(Bounded))


@cache
def _profile_table() -> type[BaseModel]:
    bounds = _bounds_table()
    base = {"based_on": (Literal[tuple(PROFILES)], DEFAULT_BASE), "bounds": (bounds, bounds())}
    return _table("ProfileTable", base | _keys_of(Profile))


def profile_of(name: str | os.PathLike[str]) -> Profile:
    """The profile of a name ("ieee", "vulkan", "wgsl", "gl", "mediump") or of a TOML file.

    A file names the profile that it is `based_on` ("vulkan" unless it says so) and gives what differs: keys of
    `Profile`, and in the table `bounds` keys of `Bounded`.
    Raises ProfileError, which lists all that is wrong with the file.
    """
    name = os.fspath(name)
    return PROFILES[name] if name in PROFILES else profile_in(_parsed(name), name)


def profile_in(data: Mapping[str, Any], source: str) -> Profile:
    """The profile that the tables of such a file give; `source` stands in the messages. Raises ProfileError."""
    return _profile(_validated(data, source))


def tables_of(profile: Profile) -> dict[str, Any]:
    """The tables that `profile_in` makes a profile of again, but for what it has other in vertex shaders."""
    named = [name for name, each in PROFILES.items() if each == profile]
    exact = not isinstance(profile.arithmetic, Bounded)
    name = named[0] if named else "ieee" if exact else DEFAULT_BASE
    base = PROFILES[name]
    tables: dict[str, Any] = {"based_on": name} | _other(profile, base)
    if isinstance(profile.arithmetic, Bounded) and isinstance(base.arithmetic, Bounded):
        bounds = _other(profile.arithmetic, base.arithmetic)
        return tables | ({"bounds": bounds} if bounds else {})
    return tables


def _other(given: Profile | Bounded, base: Profile | Bounded) -> dict[str, Any]:
    """The keys of a file in which two of a kind differ."""
    return {key: value for key in _keys_of(type(given)) if (value := getattr(given, key)) != getattr(base, key)}


def _parsed(name: str) -> dict[str, Any]:
    return toml_of(Path(name), f"a profile file or a profile ({', '.join(PROFILES)})", ProfileError)


def _validated(data: Mapping[str, Any], source: str) -> Any:
    try:
        return _profile_table().model_validate(data)
    except ValidationError as error:
        problems = (described(each, _known(each["loc"])) for each in error.errors())
        raise ProfileError("\n".join(f"{source}: {problem}" for _, problem in problems)) from None


def _known(location: tuple[int | str, ...]) -> list[str]:
    """The keys of the table that an error is in."""
    table = _bounds_table() if location[0] == "bounds" and len(location) > 1 else _profile_table()
    return list(table.model_fields)


def _profile(table: Any) -> Profile:
    """The profile that a file is based on, with what the file gives in its place."""
    base = PROFILES[table.based_on]
    bounds = table.bounds.model_dump(exclude_unset=True)
    if bounds:
        known = base.arithmetic if isinstance(base.arithmetic, Bounded) else Bounded()
        base = replace(base, arithmetic=replace(known, **bounds))
    return replace(base, **table.model_dump(exclude_unset=True, exclude={"based_on", "bounds"}))
