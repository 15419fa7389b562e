"""Where on the body a pixel lies, from the buffers of a rendering: a pixel may be in several regions."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sss_ref.language.names import Name
from sss_ref.rendering.fold import render
from sss_ref.scene.scene import Scene
from sss_ref.truth.media import Volumes
from sss_ref.truth.searchlight import diffusion_length

FloatArray = NDArray[np.float64]
Mask = NDArray[np.bool_]
GRAZING = 0.25  # N.L up to which light counts as grazing: 14.5 degrees on either side of the terminator
STEP = 4.0  # times the usual distance of two neighbouring pixels' points: what is farther is another surface
JUMP = 5.0  # times the usual change of UV over a length: what changes more has a seam between
LARGEST_REACH = 8  # pixels
SAID = {
    "everywhere": "all pixels of the body",
    "lit": "lit, and in none of the next five",
    "terminator": "N.L of a light is between -0.25 and 0.25",
    "shadow edge": "within a diffusion length of the border between lit and cast shadow, not at a silhouette",
    "thin": "light comes from behind, through at most two diffusion lengths",
    "seam": "beside a seam of the UV layout",
    "silhouette": "within a diffusion length of the picture's background or of a nearer surface",
    "dark": "reached by no light, and in none of those",
}


@dataclass(frozen=True, eq=False)
class Regions:
    """The regions of a scene whose shadow test is "slope". volumes: per mm."""

    scene: Scene
    volumes: Volumes

    @cached_property
    def masks(self) -> Mapping[str, Mask]:
        """Name -> bool (H, W), in the order of SAID, of those that have a pixel."""
        own = {
            "terminator": self._terminator,
            "shadow edge": self._shadow_edge,
            "thin": self._thin,
            "seam": self._seam,
            "silhouette": self._silhouette,
        }
        apart = _any(list(own.values()))
        lit = _any([(cosine > GRAZING) & reached for cosine, reached, _ in self._lights])
        found = {"everywhere": self.covered, "lit": lit & ~apart, **own, "dark": ~lit & ~apart}
        masks = {name: found[name] & self.covered for name in SAID}
        return {name: mask for name, mask in masks.items() if mask.any()}

    @cached_property
    def covered(self) -> Mask:
        """Where the body is seen."""
        return np.asarray(self._buffers["coverage"] != 0)

    @property
    def length(self) -> float:
        """The mean diffusion length of the three channels, mm."""
        return float(np.mean([diffusion_length(volume) for volume in self.volumes]))

    @property
    def reach(self) -> int:
        """That length in pixels of a surface that faces the camera, at least 1."""
        pixel = self._usual_step * self.scene.settings.mm_per_unit
        return int(np.clip(round(self.length / pixel), 1, LARGEST_REACH))

    @cached_property
    def _buffers(self) -> Mapping[str, NDArray[np.generic]]:
        per_light = [*self._of_lights("directly_lit"), *self._of_lights("thickness")]
        names = ["coverage", "position_world", "normal_world", *per_light]
        return render(self.scene, keep=[*names, "uv"] if self.scene.mesh.uvs is not None else names).buffers

    def _of_lights(self, base: str) -> list[str]:
        """The buffer of each light."""
        count = len(self.scene.lights)
        return [str(Name(base, light)) for light in (range(1, count + 1) if count > 1 else [0])]

    @cached_property
    def _lights(self) -> list[tuple[FloatArray, Mask, FloatArray]]:
        """Of each light N.L, whether it reaches a point, and its way through the body, mm; each (H, W)."""
        points, normals = (self._buffers[name].astype(np.float64) for name in ("position_world", "normal_world"))
        found = []
        named = zip(self._of_lights("directly_lit"), self._of_lights("thickness"), strict=True)
        for light, (lit, thickness) in zip(self.scene.lights, named, strict=True):
            parallel = light.view.lens.is_parallel
            towards = -light.view.direction if parallel else light.position - points
            towards = towards / np.maximum(np.linalg.norm(towards, axis=-1, keepdims=True), 1e-30)
            way = self._buffers[thickness].astype(np.float64) * self.scene.settings.mm_per_unit
            found.append(((normals * towards).sum(axis=-1), self._buffers[lit] != 0, way))
        return found

    @property
    def _terminator(self) -> Mask:
        return _any([np.abs(cosine) <= GRAZING for cosine, _, _ in self._lights])

    @property
    def _shadow_edge(self) -> Mask:
        edges = []
        for cosine, reached, _ in self._lights:
            faces = self.covered & (cosine > GRAZING)
            edges.append(faces & _grown(faces & reached, self.reach) & _grown(faces & ~reached, self.reach))
        return _any(edges) & ~self._silhouette  # there the neighbour is another surface

    @property
    def _thin(self) -> Mask:
        behind = [(cosine < -GRAZING) & (way > 0) & (way <= 2 * self.length) for cosine, _, way in self._lights]
        lit = _any([(cosine > 0) & reached for cosine, reached, _ in self._lights])
        return _any(behind) & ~lit

    @cached_property
    def _silhouette(self) -> Mask:
        borders = ~self.covered
        for axis in (0, 1):
            first, second = _pairs(self._steps(axis) > STEP * self._usual_step, axis)
            borders = borders | first | second
        return _grown(borders, self.reach)

    @property
    def _seam(self) -> Mask:
        if "uv" not in self._buffers:
            return np.zeros_like(self.covered)
        found, slopes = np.zeros_like(self.covered), []
        uv = self._buffers["uv"].astype(np.float64)
        for axis in (0, 1):
            steps = self._steps(axis)
            slopes.append(np.where(steps <= STEP * self._usual_step, _distance(uv, axis) / np.maximum(steps, 1e-30), 0))
        changing = np.concatenate([slope[slope > 0] for slope in slopes])
        usual = np.median(changing) if changing.size else np.inf
        for axis, slope in enumerate(slopes):
            first, second = _pairs(slope > JUMP * usual, axis)
            found |= first | second
        return found

    def _steps(self, axis: int) -> FloatArray:
        """The distance, scene units, of each pixel's point from its neighbour's; inf where one of them has none."""
        both = self.covered & np.roll(self.covered, -1, axis)
        both = np.take(both, range(both.shape[axis] - 1), axis)
        return np.where(both, _distance(self._buffers["position_world"].astype(np.float64), axis), np.inf)

    @cached_property
    def _usual_step(self) -> float:
        """The lower quartile of those: of what about faces the camera."""
        found = np.concatenate([self._steps(axis).ravel() for axis in (0, 1)])
        finite = found[np.isfinite(found)]
        return float(np.quantile(finite, 0.25)) if finite.size else 1.0


def _any(masks: Sequence[Mask]) -> Mask:
    """Where one of them holds."""
    return np.asarray(np.logical_or.reduce(masks))


def _distance(values: FloatArray, axis: int) -> FloatArray:
    """The length of the difference between neighbours, one fewer along the axis."""
    return np.asarray(np.linalg.norm(np.diff(values, axis=axis), axis=-1))


def _pairs(between: Mask, axis: int) -> tuple[Mask, Mask]:
    """The pixels before and after each marked border, as masks of the whole picture."""
    after, before = [(0, 0), (0, 0)], [(0, 0), (0, 0)]
    after[axis], before[axis] = (1, 0), (0, 1)
    return np.pad(between, before), np.pad(between, after)


def _grown(mask: Mask, pixels: int) -> Mask:
    """The mask and what is so near to it, along rows and columns and diagonals."""
    for _ in range(pixels):
        wide = np.pad(mask, 1)
        mask = _any([wide[y : y + mask.shape[0], x : x + mask.shape[1]] for y in range(3) for x in range(3)])
    return mask
