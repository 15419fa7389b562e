"""The techniques, rendered: with the scene's own keys, and with those that are fitted to the medium."""

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.errors.wording import nearest, told
from sss_ref.rendering.fold import render
from sss_ref.scene.catalogue import METHODS, TECHNIQUES
from sss_ref.truth.material_fit import MaterialFit
from sss_ref.yardstick.yardstick import Yardstick

ALL = (*METHODS, *TECHNIQUES)
SHIPPED, FITTED = "shipped", "fitted"
RUNS = 3  # of which the quickest counts


@dataclass(frozen=True, eq=False)
class Rung:
    """One technique's picture. keys: what is put on top of the scene's own."""

    method: str
    parameters: str  # SHIPPED or FITTED
    keys: Mapping[str, Any]
    image: NDArray[np.float32]  # linear RGB (H, W, 3), row 0 at the bottom, in the truth's units
    milliseconds: float  # of one processor, for the whole picture with its maps

    @property
    def name(self) -> str:
        """The technique and its parameters in words."""
        return f"{self.method}, {self.parameters}"


def checked_methods(names: Sequence[str]) -> tuple[str, ...]:
    """The techniques of these names, all where there are none. Raises SceneError for another name."""
    for name in names:
        if name not in ALL:
            raise SceneError(told("--methods", "a technique", repr(name), nearest(name, ALL)))
    return tuple(dict.fromkeys(names)) or ALL


def check_rungs(of: Yardstick, methods: Sequence[str], fitted: bool) -> None:
    """Raise SceneError, and MeshError, for a scene that one of the methods does not go with, before it is traced.

    fitted: whether there will be a fit.
    """
    if fitted and of.given.settings.preset == "published":
        remedy = "give --no-fit, or --preset robust"
        raise SceneError(told("preset", "one whose keys can be fitted", '"published"', remedy))
    for method in methods:
        of.scene_of(method, {})


def rungs(
    of: Yardstick, methods: Sequence[str], fit: MaterialFit | None, on_rung: Callable[[str], object]
) -> Iterator[Rung]:
    """Each method as shipped and, where there is a fit, fitted. on_rung: told the name of each."""
    for method in methods:
        yield _rung(of, method, SHIPPED, {}, on_rung)
        if fit is not None:
            keys = fit.keys(of.given.settings.mm_per_unit, fit.nearer_law)
            yield _rung(of, method, FITTED, keys, on_rung)


def _rung(
    of: Yardstick, method: str, parameters: str, keys: Mapping[str, Any], on_rung: Callable[[str], object]
) -> Rung:
    on_rung(f"rendering {method}, {parameters}")
    scene = of.scene_of(method, keys)
    seconds = []
    image = render(scene, threads=1, keep="final").image  # its kernels may have to be compiled
    for _ in range(RUNS):
        start = time.process_time()
        render(scene, threads=1, keep="final")
        seconds.append(time.process_time() - start)
    return Rung(method, parameters, keys, image, min(seconds) * 1e3)
