"""One light or several: with several, what belongs to a light carries its number, and contributions are summed."""

from collections.abc import Callable
from dataclasses import replace

from sss_ref.language import Stage
from sss_ref.language.pipeline import MeshDraw
from sss_ref.passes.lights import plus
from sss_ref.scene.settings import SceneFile

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
PARTIAL = "partial_"  # what is summed and is no buffer by itself


class Lights:
    """The lights of a scene, by the suffixes their names get: "" for the only one, _1, _2 ... for several."""

    def __init__(self, settings: SceneFile) -> None:
        self.falloffs = [light.falloff for light in settings.lights]
        count = len(self.falloffs)
        self.suffixes = [""] if count == 1 else [f"_{number}" for number in range(1, count + 1)]

    def numbered(self, suffix: str, also: tuple[str, ...] = ()) -> Callable[[str], str]:
        """The renaming of what belongs to one light; `also`: further names, which a sum takes up."""

        def rename(name: str) -> str:
            if suffix and name in also:
                return f"{PARTIAL}{name}{suffix}"
            return name + suffix if name in (*UNIFORMS, *BUFFERS) else name

        return rename

    def each(self, stage: Stage, also: tuple[str, ...] = ()) -> tuple[Stage, ...]:
        """A stage once for every light."""
        return tuple(stage.renamed(self.numbered(suffix, also)) for suffix in self.suffixes)

    def draw(self, draw: MeshDraw, suffix: str) -> MeshDraw:
        """A draw from the view of one light."""
        rename = self.numbered(suffix)
        return replace(
            draw, vertex=draw.vertex.renamed(rename), triangle=rename(draw.triangle), depth=rename(draw.depth)
        )

    def summed(self, name: str) -> tuple[Stage, ...]:
        """Stages that add the parts of a buffer in the order of the lights, starting with the first; none for one."""
        stages: list[Stage] = []
        before = self.numbered(self.suffixes[0], (name,))(name) if name not in BUFFERS else name + self.suffixes[0]
        for suffix in self.suffixes[1:]:
            part = name + suffix if name in BUFFERS else f"{PARTIAL}{name}{suffix}"
            total = name if suffix == self.suffixes[-1] else f"{PARTIAL}sum_{name}{suffix}"
            stages.append(plus.bound(first=before, second=part, total=total))
            before = total
        return tuple(stages)
