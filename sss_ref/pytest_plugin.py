"""The plugin for pytest that is there wherever sss_ref is installed: one fixture, which renders a scene once."""

import json
import os
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from sss_ref.rendering.result import Result

Oracle = Callable[..., "Result"]


@pytest.fixture(scope="session")
def sss_ref_oracle() -> Oracle:
    """A function (scene, **overrides) that gives a scene's rendering with all buffers, made once a session.

    It takes what `sss_ref.load_scene` takes, a bundle's folder too, and gives what `sss_ref.assert_valid` takes.
    """
    rendered: dict[str, Result] = {}

    def oracle(scene: str | os.PathLike[str] | Mapping[str, Any], /, **overrides: Any) -> "Result":
        import sss_ref

        named = scene if isinstance(scene, Mapping) else os.path.abspath(scene) if os.path.exists(scene) else str(scene)
        key = json.dumps([named, overrides], sort_keys=True, default=str)
        if key not in rendered:
            rendered[key] = sss_ref.render(sss_ref.load_scene(scene, **overrides))
        return rendered[key]

    return oracle
