"""What tests of several folders use."""

from collections.abc import Callable
from pathlib import Path

import pytest

ASSETS = Path(__file__).parents[2] / "shared" / "assets"


@pytest.fixture
def asset() -> Callable[[str], Path]:
    """A file among the developers' meshes, which lie beside the checkout; without it the test is skipped."""

    def find(path: str) -> Path:
        if not (ASSETS / path).is_file():
            pytest.skip(f"developers' asset {path} is not beside the checkout")
        return ASSETS / path

    return find
