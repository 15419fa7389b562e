"""Which buffers a change is held against, drawn by an artist that only notes what it is asked for."""

from dataclasses import dataclass, field

import numpy as np
import pytest
from scenes import around, cube, written

from sss_ref.errors import SceneError
from sss_ref.neutral import relations
from sss_ref.neutral.artists import ReferenceArtist
from sss_ref.neutral.comparison import Pair, pairs
from sss_ref.neutral.relations import RELATIONS, Easel
from sss_ref.neutral.trial import NeutralTrial, neutral
from sss_ref.scene.load import load_scene

LIGHTS = [{"position": [2, 1, 2.5], "intensity": 4.0}, {"position": [-2, 1, 2.5], "intensity": 3.0}]
SUN = {"type": "directional", "azimuth": 30, "elevation": 10}


@dataclass
class Noting:
    """Gives the same buffers whatever it draws, and keeps what that was."""

    buffers: dict
    any_lights: bool = True
    drawn: list = field(default_factory=list)

    def whole(self, scene, keep="all"):
        self.drawn.append((scene, keep))
        return self.buffers

    def again(self, scene):
        self.drawn.append((scene, "again"))
        return self.buffers

    def one(self, scene, this_pass, buffers):
        self.drawn.append((scene, this_pass.name))
        size = (scene.settings.camera.height, scene.settings.camera.width, 3)
        return {name: np.zeros(size, np.float32) for name in this_pass.outputs}


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return written(tmp_path_factory.mktemp("bodies") / "cube.obj", *cube())


@pytest.fixture
def easel(path):
    """Makes one of some buffers, each a pixel of its own number, and keys of the scene."""

    def made(names=("lit", "image"), any_lights=True, **keys):
        scene = load_scene({**around(path, 8, preset="robust", shadow_map={"test": "slope"}), **keys})
        buffers = {name: np.full((1, 1), number, np.float32) for number, name in enumerate(names, start=1)}
        return Easel(scene, Noting(buffers, any_lights), buffers)

    return made


def compared(found):
    """(buffer, the number before, the number after) of what is held against each other."""
    return [(pair.buffer, pair.before.item(), pair.after.item()) for pair in found]


@pytest.mark.parametrize(("name", "kept"), [("drawn again", "again"), ("the image alone", "final")])
def test_the_same_scene_in_another_way(easel, name, kept):
    given = easel()
    assert compared(RELATIONS[name](given)) == [("lit", 1, 1), ("image", 2, 2)]
    assert given.artist.drawn == [(given.scene, kept)]


def test_lights_swapped_have_each_others_buffers(easel):
    given = easel(("lit_1", "lit_2", "image"), lights=LIGHTS)
    assert compared(RELATIONS["lights swapped"](given)) == [("lit_1", 1, 2), ("lit_2", 2, 1), ("image", 3, 3)]
    ((drawn, _),) = given.artist.drawn
    assert [light.intensity for light in drawn.lights] == [3, 4]


@pytest.mark.parametrize("count", [1, 3])
def test_only_two_lights_are_swapped(easel, count):
    given = easel(lights=[*LIGHTS, *LIGHTS][:count])
    assert RELATIONS["lights swapped"](given) == f"the scene has not two lights but {count}"


@pytest.mark.parametrize("other", [SUN, {**LIGHTS[1], "falloff": "inverse_square"}])
def test_lights_of_two_types_are_swapped_by_whom_draws_any(easel, other):
    for lights in ([LIGHTS[0], other], [other, LIGHTS[0]]):
        assert len(compared(RELATIONS["lights swapped"](easel(lights=lights)))) == 2
        assert RELATIONS["lights swapped"](easel(any_lights=False, lights=lights)) == (
            "its lights are of two types, each with shaders of its own"
        )
    assert len(compared(RELATIONS["lights swapped"](easel(any_lights=False, lights=LIGHTS)))) == 2


@pytest.mark.parametrize(
    ("name", "names", "numbers_after"),
    [
        ("a black light after", ("lit", "lit_1", "lit_2"), (2, 2, 3)),
        ("a black light before", ("lit", "lit_1", "lit_2"), (3, 2, 3)),
        ("a black light after", ("lit_1", "lit_2", "lit_3"), (1, 2, 3)),
        ("a black light before", ("lit_1", "lit_2", "lit_3"), (2, 3, 3)),
    ],
)
def test_a_further_light_shifts_the_numbers_of_those_after_it(easel, name, names, numbers_after):
    """A scene of one light has no numbers until there is a second."""
    lights = LIGHTS[:1] if "lit" in names else LIGHTS
    given = easel(names, lights=lights)
    assert compared(RELATIONS[name](given)) == [*zip(names, (1, 2, 3), numbers_after, strict=True)]
    (dark, _), (more, _) = sorted(given.artist.drawn, key=lambda drawn: len(drawn[0].lights))
    assert (len(dark.lights), len(more.lights)) == (len(lights), len(lights) + 1)
    assert dark.settings.phong.ambient == more.settings.phong.ambient == 0
    black = [not light.color.any() for light in more.lights]
    assert black.index(True) == (0 if "before" in name else len(lights)) and sum(black) == 1


def test_who_cannot_draw_more_lights_says_so(easel):
    given = easel(any_lights=False)
    assert RELATIONS["a black light after"](given) == "the shaders are for so many lights as the scene has"


def test_only_lengths_are_doubled_and_only_what_no_scale_goes_into(easel):
    names = ("light_distance", "position_world", "coverage", "thickness", "uv", "translucency", "lit", "image")
    found = compared(RELATIONS["twice as large"](easel(names)))
    assert found == [
        ("light_distance", 2, 1),
        ("position_world", 4, 2),
        ("coverage", 3, 3),
        ("thickness", 8, 4),
        ("uv", 5, 5),
    ]


def test_the_pictures_passes_are_drawn_on_a_larger_one(easel):
    given = easel()
    size = (8, 8)
    clear = {name: np.broadcast_to(np.asarray(given.scene.clear(name)), (*size, 3)) for name in ("lit", "scattered")}
    given.buffers.update(clear, coverage=np.zeros(size, np.uint8))
    given.buffers["image"] = np.zeros((*size, 3), np.float32)
    for name in ("a larger picture", "a moved picture"):
        assert [pair.buffer for pair in RELATIONS[name](given)] == ["scattered", "image"]
    drawn = [(scene.settings.camera.width, scene.settings.camera.height, name) for scene, name in given.artist.drawn]
    assert drawn == [(8, 8, "blur"), (21, 17, "blur"), (8, 8, "composite"), (21, 17, "composite")] * 2


class Copying(Noting):
    """Whatever the pass, it writes what lies in lit."""

    def one(self, scene, this_pass, buffers):
        self.drawn.append(buffers["lit"])
        return dict.fromkeys(this_pass.outputs, buffers["lit"])


@pytest.mark.parametrize(("name", "row", "column"), [("a larger picture", 0, 0), ("a moved picture", 3, 5)])
def test_what_a_pass_writes_lies_where_the_old_picture_does(easel, name, row, column):
    """Drawn are those passes alone of which every buffer is there: the blur, and nothing that reads what it writes."""
    scene = easel().scene
    lit = np.full((8, 8, 3), scene.clear("lit"), np.float32)
    lit[1:7, 1:7] = np.arange(6 * 6 * 3).reshape(6, 6, 3) + 1
    needed = scene.method["blur"].needs & set(scene.method.outputs)
    buffers = {each: lit if each == "lit" else np.full((8, 8), scene.clear(each)) for each in needed}
    given = Easel(scene, Copying(buffers), buffers)
    (pair,) = RELATIONS[name](given)
    before, after = given.artist.drawn
    assert before is lit and after.shape == (8 + 9, 8 + 13, 3)
    assert after[row : row + 8, column : column + 8].tolist() == lit.tolist()
    assert pair.buffer == "scattered" and pair.before.tolist() == pair.after.tolist() == lit.tolist()


@pytest.mark.parametrize("place", [(0, 3), (7, 3), (3, 0), (3, 7), (0, 0), (7, 7)])
def test_what_reaches_an_edge_is_left_out(easel, place):
    scene = easel().scene
    buffer = np.full((8, 8, 3), scene.clear("lit"), np.float32)
    assert relations._is_clear(scene, "lit", buffer)
    buffer[1:7, 1:7] = 5
    assert relations._is_clear(scene, "lit", buffer)
    buffer[place][2] = 5
    assert not relations._is_clear(scene, "lit", buffer)


def test_a_buffer_of_the_picture_lies_in_a_larger_one_with_its_background(easel):
    scene = easel().scene
    buffer = np.arange(2 * 3 * 3, dtype=np.float32).reshape(2, 3, 3)
    larger = relations._embedded(scene, "lit", buffer, (4, 5))
    assert larger.shape == (2 + 9, 3 + 13, 3) and larger.dtype == np.float32
    assert larger[5:7, 4:7].tolist() == buffer.tolist()
    larger[5:7, 4:7] = scene.clear("lit")
    assert (larger == scene.clear("lit")).all()
    assert relations._embedded(scene, "light_distance", buffer, (4, 5)) is buffer


def test_pairs_are_what_both_have(easel):
    before = {"lit_1": np.zeros((2, 2)), "lit_3": np.ones((2, 2)), "gone": np.ones((2, 2)), "image": np.ones((2, 2))}
    after = {"lit_2": np.full((4, 4), 2.0), "lit_3": np.full((4, 4), 3.0), "image": np.arange(16.0).reshape(4, 4)}
    window = slice(1, 3), slice(2, 4)
    found = {pair.buffer: pair.after.tolist() for pair in pairs(before, after, {1: 2}, window)}
    assert found == {"lit_1": [[2, 2]] * 2, "lit_3": [[3, 3]] * 2, "image": [[6, 7], [10, 11]]}
    assert [pair.buffer for pair in pairs(before, after)] == ["lit_3", "image"]


def test_a_pair_differs_in_shape_or_in_any_bit():
    zeros = np.zeros((2, 2), np.float32)
    assert not Pair("a", zeros, zeros.copy()).differs
    assert Pair("a", zeros, -zeros).differs and Pair("a", zeros, np.zeros((2, 3), np.float32)).differs
    one = zeros.copy()
    one[1, 0] = 1
    assert str(Pair("lit", zeros, one)).startswith("lit, first at pixel 0,1")


@pytest.mark.parametrize(
    ("trial", "told"),
    [
        (NeutralTrial("a change", "", 3), "holds: a change: 3 buffers"),
        (NeutralTrial("a change", "", 3, "lit, first"), "broken: a change: lit, first"),
        (NeutralTrial("a change", "", not_tried="none"), "not tried: a change: none"),
        (NeutralTrial("a change", ""), "holds: a change: 0 buffers"),
    ],
)
def test_an_outcome_is_a_sentence(trial, told):
    assert str(trial) == told


class Wavering(Noting):
    """The second time it draws otherwise."""

    def again(self, scene):
        return {name: buffer + 1 for name, buffer in self.buffers.items()}


def test_changes_are_tried_in_their_order_or_those_alone_that_are_asked_for(easel):
    given = easel()
    two = [*neutral(given.scene, given.artist, ["the image alone", "drawn again"])]
    assert [(each.name, each.compared, each.broken) for each in two] == [
        ("drawn again", 2, ""),
        ("the image alone", 2, ""),
    ]
    assert two[1].says == "No buffer but the image is asked for."
    assert [kept for _, kept in given.artist.drawn] == ["all", "again", "final"]
    assert [each.name for each in neutral(given.scene, given.artist)] == list(RELATIONS)
    (alone,) = neutral(given.scene, Wavering(given.buffers), ["drawn again"])
    assert (alone.compared, alone.not_tried) == (2, "") and alone.broken.startswith("lit, first at pixel 0,0")
    (none,) = neutral(given.scene, given.artist, ["lights swapped"])
    assert (none.compared, none.broken, none.not_tried) == (0, "", "the scene has not two lights but 1")


def test_a_change_that_nobody_knows(easel):
    given = easel()
    with pytest.raises(SceneError, match=r"neutral: expected one of drawn again, .*, got twice as larg; did you mean"):
        next(neutral(given.scene, given.artist, ["drawn again", "twice as larg"]))
    assert given.artist.drawn == []


def test_the_reference_draws_a_pass_as_the_whole_scene(easel):
    scene = easel().scene
    artist = ReferenceArtist()
    whole = artist.whole(scene)
    assert artist.any_lights and [*artist.whole(scene, "final")] == ["image"]
    camera = scene.method["camera"]
    alone = artist.one(scene, camera, whole)
    assert {*alone} == {*camera.outputs}
    assert all(alone[name].tobytes() == whole[name].tobytes() for name in alone)
