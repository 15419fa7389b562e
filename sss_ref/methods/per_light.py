"""One light or several: with several, what belongs to a light carries its number, and contributions are summed."""

from collections.abc import Callable
from functools import cache, partial

from sss_ref.language import Stage
from sss_ref.language.names import PARTIAL, PARTIAL_SUM, Name
from sss_ref.passes.buffers import described
from sss_ref.passes.light_sum import plus
from sss_ref.passes.light_uniforms import LightUniforms
from sss_ref.scene_file.settings import SceneFile

Rename = Callable[[str], str]


class Lights:
    """The lights of a scene by their numbers: 0 for the only one, 1, 2 ... for several."""

    def __init__(self, settings: SceneFile) -> None:
        self.types = [light.type for light in settings.lights]
        self.falloffs = [light.falloff for light in settings.lights]
        count = len(self.types)
        self.numbers = [0] if count == 1 else list(range(1, count + 1))

    def each(self, stage: Stage) -> tuple[Stage, ...]:
        """A stage once for every light."""
        return tuple(stage.renamed(of_light(light)) for light in self.numbers)

    def summed(self, buffer: str) -> tuple[Stage, ...]:
        """Stages that add the parts of a buffer in the order of the lights, starting with the first; none for one."""
        stages: list[Stage] = []
        before = of_light(self.numbers[0])(buffer)
        for light in self.numbers[1:]:
            total = buffer if light == self.numbers[-1] else str(Name(buffer, light, share=PARTIAL_SUM))
            stages.append(plus.bound(first=before, second=of_light(light)(buffer), total=total))
            before = total
        return tuple(stages)


def of_light(light: int) -> Rename:
    """The renaming of what belongs to a light: lit becomes partial_lit_2; nothing does where it is the only one, 0."""
    return partial(_numbered, light) if light else lambda text: text


@cache  # of the names in our stages: a method asks for each of them many times
def _numbered(light: int, text: str) -> str:
    name = Name.of(text).of_light(light)
    if described(text).in_parts:
        return str(name.as_share(PARTIAL))
    return str(name) if belongs_to_a_light(text) else text


def belongs_to_a_light(name: str) -> bool:
    """Whether each light has a buffer or a uniform of this name."""
    return name in LightUniforms._fields or described(name).per_light
