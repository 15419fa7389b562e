"""The ladder: what a GPU drew, the oracle, the techniques, the truth, and how far each rung is from the next."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from sss_ref.dump.read import read_dump
from sss_ref.errors import DumpError, SceneError
from sss_ref.errors.wording import told
from sss_ref.rendering.fold import render
from sss_ref.truth.material_fit import MaterialFit
from sss_ref.truth.radiance import Radiance
from sss_ref.yardstick.deviation import Deviation, FloatArray, Mask, Truth
from sss_ref.yardstick.regions import Regions
from sss_ref.yardstick.rungs import Rung, rungs
from sss_ref.yardstick.yardstick import Yardstick

BRIGHTEST = 0.99  # share of the body's pixels that are no brighter than SHOWN
SHOWN = 0.9  # of white
By = Mapping[str, Deviation]  # region -> how far off


@dataclass(frozen=True, eq=False)
class Ladder:
    """All that is measured of one scene."""

    of: Yardstick
    radiance: Radiance
    fit: MaterialFit | None
    rungs: tuple[Rung, ...]
    gpu: By | None = None  # what a GPU drew against the oracle, both of the scene as it is given

    @cached_property
    def regions(self) -> Regions:
        """Where on the body a pixel lies."""
        return Regions(self.of.tracing.scene, self.of.volumes)

    @cached_property
    def masks(self) -> Mapping[str, Mask]:
        """Region -> bool (H, W), of the pixels whose truth is known: those with two samples or more.

        Raises SceneError where there are none.
        """
        known = np.isfinite(self.radiance.error).all(axis=-1)
        masks = {name: mask & known for name, mask in self.regions.masks.items()}
        if not any(mask.any() for mask in masks.values()):
            expected, remedy = "a body that is seen, with two samples a pixel", "move the camera, or take more samples"
            raise SceneError(told(self.of.name, expected, "no such pixel", remedy))
        return {name: mask for name, mask in masks.items() if mask.any()}

    @cached_property
    def truth(self) -> Truth:
        """What the pictures are held against, with the exposure of all of them. Raises SceneError for a black one."""
        lightest = self.radiance.mean.max(axis=-1)[self.masks["everywhere"]]
        white = float(np.quantile(lightest, BRIGHTEST)) / SHOWN
        if white <= 0:
            raise SceneError(
                told(self.of.name, "light that leaves the body", "none", "move a light or take more samples")
            )
        return Truth(self.radiance.mean, self.radiance.error, white)

    @cached_property
    def noise(self) -> By:
        """What a technique without error would be said to be off, as the truth is known no better."""
        return self.truth.deviations(self.truth.as_noisy, self.masks)

    @cached_property
    def deviations(self) -> Mapping[str, By]:
        """Name of a rung -> how far it is off."""
        return {rung.name: self.truth.deviations(rung.image.astype(np.float64), self.masks) for rung in self.rungs}


def climbed(
    of: Yardstick,
    radiance: Radiance,
    methods: Sequence[str],
    fit: MaterialFit | None,
    drawn: FloatArray | None = None,
    on_rung: Callable[[str], object] = str,
) -> Ladder:
    """The ladder of a scene whose truth is traced.

    of: the scene. radiance: of its tracing. methods: the techniques, as shipped and, where there is a `fit`, fitted.
    drawn: what a GPU drew, by `drawn_image`, (H, W, 3). on_rung: told what is being rendered.
    Raises SceneError for what cannot be measured.
    """
    bare = Ladder(of, radiance, fit, tuple(rungs(of, methods, fit, on_rung)))
    return bare if drawn is None else replace(bare, gpu=_against_the_oracle(bare, drawn))


def drawn_image(of: Yardstick, dump: Path) -> FloatArray:
    """The final picture that a GPU drew of the scene as it is given, (H, W, 3), row 0 at the bottom.

    of: the scene. dump: a mapping file or a folder. Raises DumpError for one of another size, and for one without a
    finite image.
    """
    drawn = read_dump(dump, of.given).buffers.get("image")
    if drawn is None:
        raise DumpError(told(str(dump), "the buffer image", "others", "dump the final picture too"))
    if drawn.not_finite:
        raise DumpError(told(str(drawn.path), "finite numbers", f"{drawn.not_finite} that are not", "mend the shader"))
    return drawn.data.astype(np.float64)


def _against_the_oracle(ladder: Ladder, drawn: FloatArray) -> By:
    """In the terms and by the exposure that techniques are held against the truth."""
    oracle = render(ladder.of.given, keep="final").image.astype(np.float64)
    return Truth(oracle, np.zeros_like(oracle), ladder.truth.white).deviations(drawn, ladder.masks)
