"""Dumps that say nothing, on the command line: a message and exit code 2, or a failure; never a pass or a traceback."""

import json
from xml.etree.ElementTree import parse

import numpy as np
import pytest

from sss_ref.cli import main
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import assert_valid

SIZES = [f"{table}.{side}" for table in ("camera", "shadow_map") for side in ("width", "height")]
SMALL = [part for size in SIZES for part in ("--set", f"{size}=32")] + ["--interpreter", "arrays"]
COLOURS = ("albedo", "incident_light", "phong", "lit", "scattered", "image")


@pytest.fixture(scope="module")
def buffers():
    return dict(render(load_scene("sphere", **dict.fromkeys(SIZES, 32)), interpreter="arrays").buffers)


@pytest.fixture
def judged(tmp_path, capsys):
    """A function of a folder's buffers, and bytes of other files, that gives the exit code and what is printed."""

    def of(buffers, files=None, scene="sphere", changes=()):
        for name, buffer in buffers.items():
            np.save(tmp_path / f"{name}.npy", buffer)
        for name, data in (files or {}).items():
            (tmp_path / name).write_bytes(data)
        code = main(["validate", scene, str(tmp_path), *SMALL, *changes])
        printed = capsys.readouterr()
        assert "Traceback" not in printed.err + printed.out
        return code, printed.out, printed.err

    return of


def test_the_right_dump_passes(judged, buffers):
    assert judged(buffers)[0] == 0


@pytest.mark.parametrize("value", [0.0, 1.0, np.nan, np.inf])
def test_a_dump_filled_with_one_value_fails(judged, buffers, value):
    filled = {name: np.full_like(buffer, value) for name, buffer in buffers.items() if buffer.dtype == np.float32}
    code, printed, _ = judged(buffers | filled)
    assert code == 1 and "fail: " in printed


@pytest.mark.parametrize("name", COLOURS)
@pytest.mark.parametrize("value", [0.0, np.nan])
def test_a_single_picture_filled_with_one_value_fails(judged, buffers, name, value):
    code, printed, _ = judged({name: np.full_like(buffers[name], value)})
    assert code == 1 and f"of {name} are out of reach" in printed


def test_a_dump_of_integers_all_0_fails(judged, buffers):
    code, printed, _ = judged({name: np.zeros_like(buffers[name]) for name in ("triangle", "coverage")})
    assert code == 1 and "fail: stage rasterizer of pass camera" in printed


def test_what_follows_from_nan_is_undefined_and_what_made_it_fails(judged, buffers):
    """A stage that is given NaN gives NaN, and nothing can be said of it."""
    nothing = {
        name: np.full_like(buffers[name], np.nan)
        for name in ("position_world", "inside_point", "entry_point", "thickness")
    }
    code, printed, _ = judged(buffers | nothing)
    assert code == 1 and "fail: stage surface of pass camera" in printed
    assert "of position_world are out of reach" in printed
    (row,) = (line.split() for line in printed.splitlines() if " entry_point " in line)
    assert row[row.index("entry_point") + 1 :][2:6] == ["-", "-", "-", row[3]]  # all its pixels are undefined


def test_both_blank(judged, buffers):
    """The camera turned away: a blank picture is what a right processor draws too."""
    away = ["--set", "camera.target=[50,0,0]"]
    scene = load_scene("sphere", **dict.fromkeys(SIZES, 32))
    blank = {"image": np.full_like(buffers["image"], scene.settings.output.background)}
    code, _, told = judged(blank, changes=away)
    assert code == 2 and "expected a mesh that covers some of the pixels judged, got none; change the view" in told


AWAY = ["--set", "lights.0.target=[9,9,9]", "--set", "lights.0.fov_y=10"]  # a shadow map on which nothing is drawn


@pytest.fixture(scope="module")
def beside_the_light():
    turned = {"lights.0.target": [9, 9, 9], "lights.0.fov_y": 10, **dict.fromkeys(SIZES, 32)}
    return dict(render(load_scene("sphere", **turned), interpreter="arrays").buffers)


@pytest.mark.parametrize("profile", ["ieee", "vulkan"])
def test_a_buffer_without_pixels_to_judge_neither_passes_nor_fails(judged, beside_the_light, tmp_path, profile):
    files = [*("--report", str(tmp_path / "page")), *("--junit", str(tmp_path / "junit.xml"))]
    code, printed, _ = judged(beside_the_light, changes=[*AWAY, "--profile", profile, *files])
    assert code == 0 and "gives what it should; empty, without a pixel to judge: light_distance\n" in printed
    told = json.loads((tmp_path / "page" / "report.json").read_text())
    assert told["passed"] and told["empty"] == ["light_distance"]
    assert [one["buffer"] for one in told["buffers"] if one["empty"]] == ["light_distance"]
    assert not any(one["passed"] for one in told["buffers"] if one["empty"])
    assert '<tr class="empty"><td>light_distance' in (tmp_path / "page" / "report.html").read_text()
    (skipped,) = parse(tmp_path / "junit.xml").iterfind(".//testcase[skipped]")
    assert skipped.get("name") == "light_distance"


def test_a_run_in_which_nothing_was_judged(judged, beside_the_light, tmp_path):
    changes = [*AWAY, "--junit", str(tmp_path / "junit.xml")]
    code, printed, told = judged({"light_distance": beside_the_light["light_distance"]}, changes=changes)
    assert code == 2 and printed == f"{tmp_path / 'junit.xml'}\n"
    (line,) = (line for line in told.splitlines() if line.startswith("error: "))
    expected = "expected a buffer with pixels to judge, got no pixel that can be judged, of light_distance; give other"
    assert line.startswith(f"error: {tmp_path}: {expected}")
    assert parse(tmp_path / "junit.xml").getroot().get("errors") == "1"


def test_an_empty_buffer_with_a_wrong_background_fails(judged, beside_the_light):
    cleared = {"light_distance": np.zeros_like(beside_the_light["light_distance"])}
    code, printed, _ = judged(cleared, changes=AWAY)
    assert code == 1 and "in light_distance, where nothing is drawn 0.0 stands" in printed


def test_a_stage_of_which_nothing_was_given(judged, buffers):
    code, printed, told = judged({"image": buffers["image"]}, changes=["--only", "back_point"])
    assert code == 2 and not printed and "got no buffer of stage back_point to judge" in told


def test_in_a_test_nothing_that_can_be_judged_is_no_pass(beside_the_light):
    scene = load_scene("sphere", **{"lights.0.target": [9, 9, 9], "lights.0.fov_y": 10, **dict.fromkeys(SIZES, 32)})
    with pytest.raises(AssertionError, match=r"empty: no pixel that can be judged, of light_distance"):
        assert_valid(scene, {"light_distance": beside_the_light["light_distance"]})


def test_a_region_that_shows_nothing(judged, buffers):
    code, _, told = judged(buffers, changes=["--region", "0,0,2,2"])
    assert code == 2 and "a blank picture proves nothing" in told


def test_a_dump_of_another_scene_fails(judged, buffers):
    other = render(load_scene("wedge", **dict.fromkeys(SIZES, 32)), interpreter="arrays").buffers
    code, printed, _ = judged({name: other[name] for name in buffers if name in other})
    assert code == 1 and "fail: stage rasterizer of pass shadow_map" in printed


def test_a_dump_of_another_method_has_no_buffer_of_this_one(judged, buffers):
    code, _, told = judged({"irradiance": buffers["lit"]})
    assert code == 2 and "expected a file for a buffer (light_triangle, " in told


def test_an_empty_folder(judged):
    code, _, told = judged({})
    assert code == 2 and "expected a file for a buffer" in told


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (lambda lit: lit[:16], "lit.npy: expected 32 x 32 pixels, as camera of the scene, got 32 x 16 of lit"),
        (lambda lit: np.repeat(lit, 2, axis=1), "got 64 x 32 of lit"),
        (lambda lit: lit[..., :2], "expected 3 channels with usual names in lit.npy, got R, G"),
        (lambda lit: lit[None], "expected an array of height x width, perhaps x 1 to 4 channels, got 1 x 32 x 32 x 3"),
        (lambda lit: lit[:0], "got 32 x 0"),
        (
            lambda lit: lit.astype(np.float64),
            "expected float32, float16, integers of 8, 16 or 32 bits, or bool, got f",
        ),
        (lambda lit: lit.astype(np.complex64), "got complex64"),
        (lambda lit: (lit * 9).astype(np.int32), "expected floats, or a byte's share of 1 for lit, got integers"),
        (lambda lit: lit.astype(object), "expected numbers, got Python objects"),
    ],
)
def test_an_array_of_another_form(judged, buffers, wrong, message):
    code, printed, told = judged(buffers | {"lit": wrong(buffers["lit"])})
    assert code == 2 and message in told and not printed
    assert told.count("expected") == 1  # of one buffer, one message


@pytest.mark.parametrize("name", ["lit.npy", "lit.png", "lit.exr", "lit.dds", "lit.tif"])
@pytest.mark.parametrize("kept", [0, 40, 0.5])
def test_a_file_that_is_cut_off(judged, buffers, files_of, name, kept):
    whole, others = files_of[name], {other: buffer for other, buffer in buffers.items() if other != "lit"}
    code, printed, told = judged(others, {name: whole[: kept if kept >= 1 else int(kept * len(whole))]})
    assert code == 2 and name in told and "expected" in told and "profile" not in printed


@pytest.fixture(scope="module")
def files_of(tmp_path_factory):
    """Name -> the bytes of a whole file in each format."""
    import imageio.v3
    import OpenEXR
    import tifffile

    folder = tmp_path_factory.mktemp("whole")
    colours = np.random.default_rng(3).random((32, 32, 3), np.float32)
    np.save(folder / "lit.npy", colours)
    imageio.v3.imwrite(folder / "lit.png", (colours * 255).astype(np.uint8))
    tifffile.imwrite(folder / "lit.tif", colours, photometric="rgb")
    channels = {"RGB": OpenEXR.Channel("RGB", colours)}
    OpenEXR.File({"compression": OpenEXR.ZIP_COMPRESSION}, channels).write(str(folder / "lit.exr"))
    head = bytearray(148)  # DDS with a DX10 header: R32G32B32A32_FLOAT
    words = np.frombuffer(head, "<u4")
    words[[0, 1, 2, 3, 4, 19, 20, 21]] = [0x20534444, 124, 0x1007, 32, 32, 32, 4, 0x30315844]
    words[[32, 33, 35]] = [2, 3, 1]
    (folder / "lit.dds").write_bytes(bytes(head) + np.dstack([colours, colours[..., :1]]).tobytes())
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize("name", ["lit.npy", "lit.png", "lit.exr", "lit.dds", "lit.tif"])
def test_the_whole_files_are_read_and_found_wrong(judged, buffers, files_of, name):
    """So that it is the cut that the test above sees."""
    code, printed, told = judged({}, {name: files_of[name]})
    assert code == 1 and "of lit are out of reach" in printed, told
