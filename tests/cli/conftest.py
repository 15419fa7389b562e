"""What commands call is replaced here, name by name."""

import importlib
import pkgutil
from contextlib import suppress

import pytest

import sss_ref


@pytest.fixture(autouse=True, scope="session")
def _all_is_imported():
    """Before anything is replaced: a module that is imported meanwhile would keep the stand-in for good."""
    for module in pkgutil.walk_packages(sss_ref.__path__, "sss_ref."):
        if not module.name.endswith("__main__"):
            with suppress(ImportError):  # of an extra that is not installed
                importlib.import_module(module.name)
