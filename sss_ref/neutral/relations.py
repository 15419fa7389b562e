"""What must be neutral, each with the condition under which it is, exactly, by the rules.

Not here, because bits may move: a mirrored scene (a texture coordinate 1 - u rounds otherwise than u), three lights or
more in another order (sums round), triangles in another order (two may be equally deep), a moved view.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from sss_ref.language.names import Name
from sss_ref.language.pipeline import Pass
from sss_ref.neutral import scene_changes
from sss_ref.neutral.artists import Artist
from sss_ref.neutral.comparison import Pair, pairs
from sss_ref.passes.buffers import described
from sss_ref.rendering.draw import Buffers
from sss_ref.scene.scene import Scene

GROWN, MOVED = (13, 9), (5, 3)  # columns and rows: of what is added to a picture, of where the old one then lies
AT_THE_CORNER = (0, 0)
TRANSLUCENCY = "translucency"
SCALED = ("irradiance_paper", "irradiance_distance")  # stages that, as it does, take a length as a plain number
LENGTH = "scene units"  # how the unit of a buffer begins that is a length


@dataclass(frozen=True, eq=False)
class Easel:
    """A scene, who draws it, and the buffers as first drawn."""

    scene: Scene
    artist: Artist
    buffers: Buffers


Compared = Iterable[Pair] | str  # what must be alike, or why there is nothing to compare


def drawn_again(easel: Easel) -> Compared:
    """Once more: the reference in NumPy on one thread, a GPU a second time."""
    return pairs(easel.buffers, easel.artist.again(easel.scene))


def image_alone(easel: Easel) -> Compared:
    """No buffer but the image is asked for."""
    return pairs(easel.buffers, easel.artist.whole(easel.scene, "final"))


def color_for_intensity(easel: Easel) -> Compared:
    """Every light with twice its colour and half its intensity."""
    return pairs(easel.buffers, easel.artist.whole(scene_changes.brighter_color(easel.scene)))


def lights_swapped(easel: Easel) -> Compared:
    """Two lights the other way round."""
    tables = easel.scene.settings.lights
    if len(tables) != 2:
        return f"the scene has not two lights but {len(tables)}"
    if not easel.artist.any_lights and (tables[0].type, tables[0].falloff) != (tables[1].type, tables[1].falloff):
        return "its lights are of two types, each with shaders of its own"
    return pairs(easel.buffers, easel.artist.whole(scene_changes.lights_swapped(easel.scene)), {1: 2, 2: 1})


def black_light_after(easel: Easel) -> Compared:
    """A light without colour as the last, in a scene without ambient light."""
    return _with_black_light(easel, before=False)


def black_light_before(easel: Easel) -> Compared:
    """A light without colour as the first, in a scene without ambient light."""
    return _with_black_light(easel, before=True)


def _with_black_light(easel: Easel, before: bool) -> Compared:
    if not easel.artist.any_lights:
        return "the shaders are for so many lights as the scene has"
    if easel.scene.settings.preset == "published":
        return "preset published has one light"
    dark = scene_changes.without_ambient(easel.scene)
    count, further = len(dark.lights), int(before)
    numbers = {0: 1 + further} if count == 1 else {each: each + further for each in range(1, count + 1)}
    more = easel.artist.whole(scene_changes.with_black_light(dark, before))
    return pairs(easel.artist.whole(dark), more, numbers)


def vertices_reordered(easel: Easel) -> Compared:
    """The mesh's vertices in another order, its triangles in the same."""
    return pairs(easel.buffers, easel.artist.whole(scene_changes.vertices_reordered(easel.scene)))


def twice_as_large(easel: Easel) -> Compared:
    """Mesh, camera, lights and biases at twice the size, a millimetre half of that: lengths double, all else stays.

    But for equations that take a length as a plain number, as translucency does, and for what is made of them.
    """
    if easel.scene.settings.preset == "published":
        return "preset published keeps lengths from 0 to 1"
    before = {name: _doubled(name, easel.buffers[name]) for name in _without_scale(easel)}
    return pairs(before, easel.artist.whole(scene_changes.twice_as_large(easel.scene)))


def _without_scale(easel: Easel) -> list[str]:
    """The buffers that no stage with a scale of its own goes into."""
    made: set[str] = set()
    for stage in (stage for each in easel.scene.method.passes for stage in each.stages):
        writes = set(stage.writes.values())
        if made & set(stage.reads.values()) or stage.name in SCALED or TRANSLUCENCY in map(base_of, writes):
            made |= writes
    return [name for name in easel.buffers if name not in made]


def base_of(name: str) -> str:
    """The quantity that a buffer is of."""
    return Name.of(name).base


def _doubled(name: str, buffer: np.ndarray) -> np.ndarray:
    return buffer * np.float32(2) if described(name).unit.startswith(LENGTH) else buffer


def larger_picture(easel: Easel) -> Compared:
    """Passes that draw a rectangle, in a picture with more columns and rows: what was there stays."""
    return _in_larger_picture(easel, AT_THE_CORNER)


def moved_picture(easel: Easel) -> Compared:
    """The same, with all that they read moved some pixels: so is what they write."""
    return _in_larger_picture(easel, MOVED)


def _in_larger_picture(easel: Easel, at: tuple[int, int]) -> Compared:
    found: list[Pair] = []
    for each in (each for each in easel.scene.method.passes if _is_picture(each)):
        if each.needs & set(easel.scene.method.outputs) <= set(easel.buffers) and _stands_clear(easel, each):
            found += _pairs_of_pass(easel, each, at)
    return found or "no pass draws a rectangle, or the mesh reaches the edge of the picture"


def _is_picture(this_pass: Pass) -> bool:
    return this_pass.target == "camera" and not this_pass.draw.vertex_stages and not this_pass.on_demand


def _pairs_of_pass(easel: Easel, this_pass: Pass, at: tuple[int, int]) -> Iterable[Pair]:
    """What a pass writes, beside what it writes in a larger picture."""
    (column, row), read = at, _read(easel, this_pass)
    larger = scene_changes.larger_picture(easel.scene, *GROWN)
    moved = {name: _embedded(easel.scene, name, buffer, at) for name, buffer in read.items()}
    before = easel.artist.one(easel.scene, this_pass, read)
    after = easel.artist.one(larger, this_pass, moved)
    height, width = next(iter(before.values())).shape[:2]
    return pairs(before, after, window=(slice(row, row + height), slice(column, column + width)))


def _read(easel: Easel, this_pass: Pass) -> dict[str, np.ndarray]:
    return {name: easel.buffers[name] for name in sorted(this_pass.needs) if name in easel.buffers}


def _of_the_picture(scene: Scene, name: str) -> bool:
    """Whether a buffer is drawn at the camera's pixels."""
    return any(name in each.outputs and each.target == "camera" for each in scene.method.passes)


def _stands_clear(easel: Easel, this_pass: Pass) -> bool:
    """Whether what a pass reads holds its background along all four edges of the picture."""
    read = _read(easel, this_pass)
    return all(_is_clear(easel.scene, name, read[name]) for name in read if _of_the_picture(easel.scene, name))


def _is_clear(scene: Scene, name: str, buffer: np.ndarray) -> bool:
    edges = (buffer[0], buffer[-1], buffer[:, 0], buffer[:, -1])
    return all((edge == scene.clear(name)).all() for edge in edges)


def _embedded(scene: Scene, name: str, buffer: np.ndarray, at: tuple[int, int]) -> np.ndarray:
    """A buffer of the picture in a larger one, with its background around it; any other as it is."""
    if not _of_the_picture(scene, name):
        return buffer
    (right, above), (column, row), (height, width) = GROWN, at, buffer.shape[:2]
    larger = np.empty((height + above, width + right, *buffer.shape[2:]), buffer.dtype)
    larger[...] = scene.clear(name)
    larger[row : row + height, column : column + width] = buffer
    return larger


RELATIONS: Mapping[str, Callable[[Easel], Compared]] = {
    "drawn again": drawn_again,
    "the image alone": image_alone,
    "colour for intensity": color_for_intensity,
    "lights swapped": lights_swapped,
    "a black light after": black_light_after,
    "a black light before": black_light_before,
    "vertices reordered": vertices_reordered,
    "twice as large": twice_as_large,
    "a larger picture": larger_picture,
    "a moved picture": moved_picture,
}
