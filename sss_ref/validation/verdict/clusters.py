"""Where on the picture wrong pixels lie: at outlines, between triangles, at the edge of a shadow, on one triangle."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from operator import itemgetter

import numpy as np

from sss_ref.language.pipeline import Pass
from sss_ref.rendering.draw import Machine, draw
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.dumped import Buffers

SHADOW = "directly_lit"  # the buffers that say what lies in shadow begin with it
EVERYWHERE = 0.9  # of the compared pixels
MOST, CLEARLY = 0.6, 2.0  # of the wrong pixels, and how many times as often as among all
ONE_TRIANGLE = 0.9  # of the wrong pixels, on a triangle with less than half of all


@dataclass(frozen=True)
class Zone:
    """A kind of place, in words. wrong, compared: how many of the wrong pixels and of all compared ones lie there."""

    name: str
    wrong: int
    compared: int


@dataclass(frozen=True)
class Clusters:
    """Where a buffer's wrong pixels lie. zones may overlap; sentence: what stands out."""

    zones: tuple[Zone, ...]
    sentence: str


@dataclass
class Whereabouts:
    """What the oracle shows at each pixel of a pass's target. oracle: the rendering. dumped: what is judged."""

    oracle: Result
    dumped: Buffers
    _shown: dict[str, np.ndarray] = field(default_factory=dict)

    def triangles(self, pass_name: str) -> np.ndarray:
        """The triangle in scene order at every pixel of a pass's target, int32 (H, W), -1 where there is none.

        Of a full-screen pass those of the last draw of the mesh into a target of its size.
        """
        this_pass = self._mesh_pass(pass_name)
        if this_pass.name not in self._shown:
            fragments = draw(self.oracle.scene, this_pass, self.oracle.buffers, Machine()).fragments
            primitives, piece = fragments.of_mesh
            self._shown[this_pass.name] = np.append(primitives.triangle, np.int32(-1))[piece]
        return self._shown[this_pass.name]

    def at(self, pass_name: str, pixel: tuple[int, int]) -> tuple[int, ...]:
        """The triangle at a pixel (column, row), and that of the dump if it shows another one; -1 is none."""
        column, row = pixel
        shown = self._mesh_pass(pass_name).draw.triangle
        ids = [self.triangles(pass_name)[row, column]]
        if shown in self.dumped:
            ids.append(self.dumped[shown][row, column])
        return tuple(dict.fromkeys(int(each) for each in ids))

    def clusters(self, pass_name: str, where: np.ndarray, wrong: np.ndarray) -> Clusters:
        """Where wrong pixels lie; where, wrong: bool (H, W), the compared pixels and some of them."""
        triangles, layout = self.triangles(pass_name), self._mesh_pass(pass_name).draw.layout
        outline = _varies(triangles >= 0)
        border = "at the borders of the UV layout" if layout else "at the outline"
        named = {"where nothing is drawn": triangles < 0, border: outline}
        named["at triangle edges inside"] = _varies(triangles) & ~outline
        for name in (name for name in self._mesh_pass(pass_name).outputs if name.startswith(SHADOW)):
            lit = self.oracle[name] != 0
            named[f"where {name} changes"] = _varies(lit) & ~outline
            named |= {f"where {name} is 0": ~lit & (triangles >= 0), f"where {name} is 1": lit}
        zones = tuple(Zone(name, int((wrong & zone).sum()), int((where & zone).sum())) for name, zone in named.items())
        return Clusters(zones, _sentence(zones, triangles, where, wrong))

    def _mesh_pass(self, pass_name: str) -> Pass:
        method = self.oracle.scene.method
        this_pass = method[pass_name]
        before = method.passes[: method.passes.index(this_pass) + 1]
        return next(each for each in reversed(before) if each.draw.vertex_stages and each.target == this_pass.target)


def _sentence(zones: tuple[Zone, ...], triangles: np.ndarray, where: np.ndarray, wrong: np.ndarray) -> str:
    total, errors = int(where.sum()), int(wrong.sum())
    if errors >= EVERYWHERE * total:
        return f"wrong everywhere: {errors / total:.0%} of the pixels compared"
    ids, counts = np.unique(triangles[wrong], return_counts=True)
    worst, share = int(ids[counts.argmax()]), counts.max() / errors
    if worst >= 0 and share >= ONE_TRIANGLE and 2 * (where & (triangles == worst)).sum() < total:
        return f"{share:.0%} of the wrong pixels lie on triangle {worst}"
    found = max(_standing_out(zones, errors, total), default=None, key=itemgetter(0))
    if found is None:
        return f"the wrong pixels, {errors / total:.1%} of those compared, lie in no particular kind of place"
    _, zone = found
    share = f"{zone.wrong / errors:.0%} of the wrong pixels"
    return f"{share} lie {zone.name}, as {zone.compared / total:.1%} of all do"


def _standing_out(zones: tuple[Zone, ...], errors: int, total: int) -> Iterator[tuple[float, Zone]]:
    """The zones that hold most of the wrong pixels and far fewer of all, each with how many times as often.

    A zone that is nothing but the wrong pixels, all of them, stands out however large it is.
    """
    for zone in (zone for zone in zones if zone.compared):
        share = zone.wrong / errors
        ratio = share * total / zone.compared
        if (share >= MOST and ratio >= CLEARLY) or zone.wrong == errors == zone.compared:
            yield ratio, zone


def _varies(values: np.ndarray) -> np.ndarray:
    """Where the 3 x 3 pixels around one hold several values, bool (H, W)."""
    padded = np.pad(values, 1, mode="edge")
    rows, columns = values.shape
    shifted = [padded[y : y + rows, x : x + columns] for y in range(3) for x in range(3)]
    return np.logical_or.reduce([each != values for each in shifted])
