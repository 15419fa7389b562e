"""Every stage of the package by name, for whoever looks one up or tries them all."""

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType

import sss_ref.passes
from sss_ref.language import Stage
from sss_ref.methods import published

ROOMS = (sss_ref.passes, published)  # the packages whose modules define stages


@cache
def stage_modules() -> Mapping[str, ModuleType]:
    """Name -> module of those that may define stages: the paper's passes, then those of the printed figures."""
    names = [(each.name, f"{room.__name__}.{each.name}") for room in ROOMS for each in iter_modules(room.__path__)]
    return {name: import_module(path) for name, path in names}


@cache
def all_stages() -> Mapping[str, Stage]:
    """Name -> stage: those of the paper's passes, then those of the printed figures."""
    values = [value for module in stage_modules().values() for value in vars(module).values()]
    return {value.name: value for value in values if isinstance(value, Stage)}
