"""What tests of several folders use."""

from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

ASSETS = Path(__file__).parents[2] / "shared" / "assets"

# No test fails for the time it takes.
settings.register_profile(
    "untimed",
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture, HealthCheck.data_too_large],
)
settings.load_profile("untimed")


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers(config: pytest.Config) -> int | None:
    """Run all tests on all processors (None: as many workers as xdist finds), but chosen ones in this process."""
    return None if config.args == config.getini("testpaths") else 0


@pytest.fixture
def asset() -> Callable[[str], Path]:
    """A file among the developers' meshes, which lie beside the checkout; without it the test is skipped."""

    def find(path: str) -> Path:
        if not (ASSETS / path).is_file():
            pytest.skip(f"developers' asset {path} is not beside the checkout")
        return ASSETS / path

    return find
