"""One light or several: with several, what belongs to a light carries its number, and contributions are summed."""

from collections.abc import Callable
from dataclasses import replace

from sss_ref.language import Stage
from sss_ref.language.pipeline import MeshDraw
from sss_ref.passes.buffers import PARTIAL, PARTIAL_SUM
from sss_ref.passes.light_sum import plus
from sss_ref.scene_file.settings import SceneFile

UNIFORMS = (
    "light_clip_from_model",
    "light_clip_from_world",
    "light_position",
    "light_color",
    "light_intensity",
    "light_texel_size",
    "light_clear_distance",
)
BUFFERS = (
    "light_triangle",
    "light_depth",
    "light_distance",
    "light_uv",
    "shadow_uv",
    "shadow_valid",
    "stored_distance",
    "entry_point",
    "thickness",
    "directly_lit",
    "incident_light",
    "phong",
    "translucency",
    "irradiance",
    "irradiance_filled",
    "irradiance_filled_mask",
    "scattered_irradiance",
    "irradiance_uv",
)
SUMMED = ("lit", "irradiance_used", "gloss")  # of which a light's part is no buffer by itself


class Lights:
    """The lights of a scene, by the suffixes their names get: "" for the only one, _1, _2 ... for several."""

    def __init__(self, settings: SceneFile) -> None:
        self.falloffs = [light.falloff for light in settings.lights]
        count = len(self.falloffs)
        self.suffixes = [""] if count == 1 else [f"_{number}" for number in range(1, count + 1)]

    def numbered(self, suffix: str) -> Callable[[str], str]:
        """The renaming of what belongs to one light."""

        def rename(name: str) -> str:
            if suffix and name in SUMMED:
                return f"{PARTIAL}{name}{suffix}"
            return name + suffix if name in (*UNIFORMS, *BUFFERS) else name

        return rename

    def each(self, stage: Stage) -> tuple[Stage, ...]:
        """A stage once for every light."""
        return tuple(stage.renamed(self.numbered(suffix)) for suffix in self.suffixes)

    def draw(self, draw: MeshDraw, suffix: str) -> MeshDraw:
        """A draw from the view of one light."""
        rename = self.numbered(suffix)
        return replace(
            draw, vertex=draw.vertex.renamed(rename), triangle=rename(draw.triangle), depth=rename(draw.depth)
        )

    def summed(self, name: str) -> tuple[Stage, ...]:
        """Stages that add the parts of a buffer in the order of the lights, starting with the first; none for one."""
        stages: list[Stage] = []
        before = self.numbered(self.suffixes[0])(name)
        for suffix in self.suffixes[1:]:
            total = name if suffix == self.suffixes[-1] else f"{PARTIAL_SUM}{name}{suffix}"
            stages.append(plus.bound(first=before, second=self.numbered(suffix)(name), total=total))
            before = total
        return tuple(stages)
