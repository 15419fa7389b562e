"""Files without telling names are placed where they belong, whatever stage is wrong; or not at all."""

from functools import cache

import imageio.v3 as imageio
import numpy as np
import OpenEXR
import pytest
from planted import PLANTED, Planted, oracle_of, scene_of
from ports import Mistake
from shuffled import hide, misplaced

from sss_ref.capture.placing import place
from sss_ref.capture.recognized import Recognized
from sss_ref.capture.surfaces import surfaces_of
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate

SIDE = 40
SIZES = {
    f"{table}.{side}": SIDE for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")
}
RIGHT = {
    "bust": ("figure3_with", {}),
    "tooth": ("teeth_layers", {}),
    "parallel": ("molar_orthographic", {}),
    "surface": ("figure5", {}),
    "published": ("figure4_wax", {}),
}
WRONG = {  # a mistake -> what share of its files is placed at least
    "12 of 13 taps": 1.0,
    "light position x 1.0005": 1.0,
    "sRGB8": 1.0,
    "bilinear for nearest": 1.0,
    "REPEAT for CLAMP": 1.0,
    "normals not turned": 0.9,
    "jitter left in the map": 0.9,
    "depth test the wrong way round": 0.6,
    "the map read upside down": 0.6,
    "camera matrix transposed": 0.1,
}
SQUARED = Planted("distances squared", Mistake("shadow_map", writes={"light_distance": np.square}), "")
TABLE = {each.name: each for each in (*PLANTED, SQUARED)}


def found_in(folder, oracle):
    return place(surfaces_of(folder)[0], oracle)


@pytest.mark.parametrize("name", RIGHT)
def test_every_buffer_of_a_right_dump_is_placed(name, tmp_path):
    """But for two of the tooth, the light that reaches dentine and enamel, which are nearly the same."""
    shipped, changes = RIGHT[name]
    oracle = render(load_scene(shipped, **SIZES | changes))
    truth = hide(oracle.buffers, tmp_path, seed=len(name), turned=0.4, reverse=0.3)
    found = found_in(tmp_path, oracle)
    assert not misplaced(found, truth, oracle.buffers)
    blank = {name for name, buffer in oracle.buffers.items() if len(np.unique(buffer)) == 1}
    asked = {name for question in found.questions for name in question.names}
    left = set(oracle.buffers) - set(found.placements)
    assert left <= blank | asked and len(left - blank) <= 2


@cache
def oracle_at(name):
    return oracle_of(scene_of(name, SIDE))


def hidden(planted, folder, seed, **ways):
    """The places of a port's files, and those of them that are wrong; and the share that is placed."""
    oracle = oracle_at(planted.scene)
    drawn = planted.drawn(oracle.scene)
    truth = hide(drawn, folder, seed, **ways)
    found = found_in(folder, oracle)
    return found, misplaced(found, truth, drawn), len(found.placements) / len(truth)


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_stage_does_not_mislead(name, tmp_path):
    _, wrong, share = hidden(TABLE[name], tmp_path, seed=len(name), turned=0.5, reverse=0.3)
    assert not wrong
    assert share >= WRONG[name]


@pytest.mark.full
@pytest.mark.parametrize("lacking", [0.0, 0.5])
@pytest.mark.parametrize("name", TABLE)
def test_no_file_of_any_port_is_misplaced(name, lacking, tmp_path):
    assert not hidden(TABLE[name], tmp_path, seed=len(name), turned=0.5, reverse=0.3, lacking=lacking)[1]


@pytest.mark.parametrize(
    ("name", "stage"), [("12 of 13 taps", "scatter_inside"), ("distances squared", "distance_to_light")]
)
def test_the_wrong_stage_is_named_afterwards(name, stage, tmp_path):
    found, wrong, share = hidden(TABLE[name], tmp_path, seed=3, turned=0.5, reverse=0.3)
    assert (wrong, share) == ([], 1.0)
    oracle = oracle_at(TABLE[name].scene)
    told = validate(oracle, Recognized(tmp_path, oracle, found).write(tmp_path), explain=False)
    assert not told.passed and f"stage {stage}" in told.summary


def test_pictures_of_something_else_are_left_out(tmp_path):
    """Noise, a gradient, a blank; what is like a buffer only in its outline."""
    oracle = oracle_at("bust")
    rows, columns = np.mgrid[0:SIDE, 0:SIDE].astype(np.float32) / SIDE
    shade = oracle["coverage"] * (0.5 + 0.5 * oracle["normal_world"][..., 1])
    others = {
        "noise": np.random.default_rng(1).random((SIDE, SIDE, 3), np.float32),
        "gradient": np.dstack([columns, rows, 0 * rows]),
        "blank": np.ones((SIDE, SIDE), np.float32),
        "shade": shade.astype(np.float32),
        "small": np.ones((3, 3), np.float32),
    }
    for name, picture in others.items():
        np.save(tmp_path / f"{name}.npy", picture)
    found = found_in(tmp_path, oracle)
    assert not found.placements
    assert {surface.path.stem for surface in found.unknown} == set(others)


def test_two_files_for_one_buffer_are_asked_for(tmp_path):
    oracle = oracle_at("bust")
    np.save(tmp_path / "a.npy", oracle["thickness"])
    np.save(tmp_path / "b.npy", oracle["thickness"] * np.float32(1.00005))
    np.save(tmp_path / "c.npy", oracle["depth"])
    found = found_in(tmp_path, oracle)
    assert list(found.placements) == ["depth"]
    (question,) = found.questions
    assert question.names == ("thickness",)
    assert [surface.path.name for surface in question.surfaces] == ["a.npy", "b.npy"]


def test_a_file_that_may_be_two_buffers_is_asked_for(tmp_path):
    """The picture and what the blur wrote are the same where the scene is black around the mesh."""
    oracle = render(
        load_scene("figure3_with", **SIZES, **{"preset": "paper", "output.background": [0.0, 0.0, 0.0]}), "arrays"
    )
    assert np.array_equal(oracle["image"], oracle["scattered"])
    np.save(tmp_path / "x.npy", oracle["image"])
    found = found_in(tmp_path, oracle)
    assert not found.placements
    assert [question.names for question in found.questions] == [("scattered", "image")]


def test_several_buffers_in_one_picture(tmp_path):
    """A normal with the thickness as its alpha, and layers of an EXR file in half floats."""
    oracle = oracle_at("bust")
    np.save(tmp_path / "a.npy", np.dstack([oracle["normal_world"], oracle["thickness"]])[::-1])
    layers = {"p": oracle["position_world"], "q": oracle["lit"]}
    channels = {
        f"{layer}.{letter}": np.ascontiguousarray(picture[::-1, :, k]).astype(np.float16)
        for layer, picture in layers.items()
        for k, letter in enumerate("RGB")
    }
    form = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(form, channels).write(str(tmp_path / "b.exr"))
    placements = found_in(tmp_path, oracle).placements
    assert {name: each.channel_names for name, each in placements.items()} == {
        "position_world": ["p.R", "p.G", "p.B"],
        "normal_world": ["R", "G", "B"],
        "thickness": ["A"],
        "lit": ["q.R", "q.G", "q.B"],
    }
    assert all(each.candidate.origin == "top" for each in placements.values())


@pytest.mark.parametrize(
    ("name", "stored", "keys"),
    [
        ("normal_world", lambda n, camera: n * 0.5 + 0.5, {"normals": "n*.5+.5"}),
        ("normal_world", lambda n, camera: n @ camera.view[:3, :3].T, {"space": "view"}),
        ("uv", lambda uv, camera: uv * (1, -1) + (0, 1), {"scale": [1, -1], "offset": [0, 1]}),
        ("depth", lambda z, camera: 1 - z, {"scale": -1, "offset": 1}),
        (
            "depth",
            lambda z, camera: camera.far * camera.near / (camera.far - z * (camera.far - camera.near)),
            {"depth": "view"},
        ),
    ],
)
def test_other_ways_to_store_a_buffer(name, stored, keys, tmp_path):
    oracle = oracle_at("bust")
    np.save(tmp_path / "x.npy", stored(oracle[name].astype(np.float64), oracle.scene.camera).astype(np.float32))
    (found,) = found_in(tmp_path, oracle).placements.items()
    assert (found[0], found[1].candidate.keys) == (name, keys)


def test_bytes_of_a_picture_in_srgb(tmp_path):
    oracle = oracle_at("bust")
    linear = np.clip(oracle["lit"][::-1].astype(np.float64), 0, 1)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    imageio.imwrite(tmp_path / "x.png", np.rint(encoded * 255).astype(np.uint8))
    (found,) = found_in(tmp_path, oracle).placements.items()
    assert (found[0], found[1].candidate.keys) == ("lit", {"encoding": "srgb8"})
