"""What the stages that readers write are for: scenes in which one takes its place, the right one or theirs."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import sss_ref
from sss_ref.course import checks, small_scenes
from sss_ref.course.checks.written_stages import stage_of
from sss_ref.language import Stage
from sss_ref.passes.composite import over_background
from sss_ref.passes.irradiance import irradiance_lambert
from sss_ref.passes.phong import light_inverse_square, phong_shading
from sss_ref.passes.shadow_map import back_point, directly_lit_literal, distance_to_light
from sss_ref.passes.texture_image import image_product, image_sqrt

SIZE = 256  # pixels a side
HARD = small_scenes.BY_THE_TEXT


@dataclass(frozen=True)
class StageAtWork:
    """Where a stage runs: a scene, the stage whose place it takes (its own if not said), and the buffer to look at."""

    right: Stage
    scene: str = "figure3_with"
    overrides: Mapping[str, Any] = field(default_factory=dict)
    instead_of: str = ""
    buffer: str = "image"

    def drawn(self, head: str, stage: Stage) -> np.ndarray:
        """The buffer, with a stage in this place."""
        scene = small_scenes.load(self.scene, head, SIZE, **self.overrides)
        placed = sss_ref.with_stage(scene, self.instead_of or self.right.name, stage)
        return np.asarray(sss_ref.render(placed, interpreter="arrays", keep=[self.buffer])[self.buffer])


MAPPED = {"irradiance_map.width": 256, "irradiance_map.height": 256, **HARD}
PLACES: Mapping[Callable[[Any], None], StageAtWork] = {
    checks.light_that_spreads: StageAtWork(
        light_inverse_square, instead_of="light_constant", overrides={"lights.0.intensity": 10.0}
    ),
    checks.lit_within_a_bias: StageAtWork(
        directly_lit_literal, instead_of="directly_lit_slope", overrides=HARD | {"shadow_map.bias_abs": 0.03}
    ),
    checks.matt_surface: StageAtWork(phong_shading, overrides=HARD | {"phong.specular": 0.0}, buffer="phong"),
    checks.stencilled: StageAtWork(over_background, overrides={"blur.pixel_scale": 6.0}),
    checks.where_light_entered: StageAtWork(back_point, overrides=HARD),
    checks.mixed_with_phong: StageAtWork(image_sqrt, "figure5", {**MAPPED, "irradiance_map.image": "sqrt"}),
    checks.albedo_after_the_blur: StageAtWork(image_product, "figure5", {**MAPPED, "irradiance_map.image": "product"}),
    checks.same_bits: StageAtWork(distance_to_light, "figure1", buffer="light_distance"),
    checks.mended_lambert: StageAtWork(irradiance_lambert, "figure5", {**MAPPED, "irradiance_map.mode": "lambert"}),
}


def right_and_own(check: Callable[[Any], None], answer: Any, head: str) -> tuple[np.ndarray, np.ndarray | str]:
    """The right picture of an exercise, and the one of a reader's stage, or what keeps it from being drawn."""
    place = PLACES[check]
    right = place.drawn(head, place.right)
    try:
        return right, place.drawn(head, stage_of(answer))
    except checks.NotYet:
        return right, "not a stage yet"
    except sss_ref.SssRefError as error:
        return right, str(error)
