"""Kernels of a module as plain Python, so that a test of small ones by hand compiles nothing."""

from types import ModuleType

import pytest


def plain(module: ModuleType, patch: pytest.MonkeyPatch) -> ModuleType:
    """The module, whose own and imported kernels are the functions that they were compiled from."""
    for name, value in list(vars(module).items()):
        if hasattr(value, "py_func"):
            patch.setattr(module, name, value.py_func)
    return module
