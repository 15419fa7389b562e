from math import inf, nan

import pytest

from sss_ref.batch.sweep_file import checked_sweep, read_sweep
from sss_ref.errors import SceneError

TEXT = """
scene = "head.toml"
outputs = ["npz", "png"]
[set]
camera.width = 64
lights.0.color = [1, 0, 0]
output = {background = [0, 0, 1]}
[vary]
"camera.height" = [32, 64]
camera.azimuth = {first = 0, last = 90, count = 3}
lights.1.intensity = {random = "uniform", low = 0, high = 2}
camera.target = [[0, 0, 0], [0, 1, 0]]
"""


def test_keys_are_written_as_in_a_scene_file(tmp_path):
    (tmp_path / "sweep.toml").write_text(TEXT)
    sweep = read_sweep(tmp_path / "sweep.toml")
    assert sweep.scene == str(tmp_path / "head.toml")
    assert sweep.set == {"camera": {"width": 64}, "lights.0": {"color": [1, 0, 0]}, "output": {"background": [0, 0, 1]}}
    assert list(sweep.vary) == [
        "camera.height",
        "camera.azimuth",
        "camera.target",
        "lights.1.intensity",
    ]  # as TOML nests
    assert sweep.vary["camera.azimuth"].count == 3
    assert (sweep.outputs, sweep.keep, sweep.combine) == (("npz", "png"), ("final",), "grid")


def test_tables_stay_whole_unless_the_place_of_a_light_is_in_them():
    tables = {
        "output": {"tone": {"gamma": 2.2}},
        "bake": {"deep": {"lights": {"0": {"a": 1}}, "b": {"c": 2}}},
        "lights": {"1": {"color": {"r": 1}}},
    }
    sweep = checked_sweep({"set": tables, "vary": {"a": [1]}}, "sweep")
    assert sweep.set == {
        "output": {"tone": {"gamma": 2.2}},
        "bake.deep.lights.0": {"a": 1},
        "bake.deep.b": {"c": 2},
        "lights.1": {"color": {"r": 1}},
    }


def test_what_a_sweep_is_unless_the_file_says_otherwise():
    sweep = checked_sweep({"vary": {"a": [1]}}, "sweep")
    given = (sweep.scene, sweep.combine, sweep.repeat, sweep.seed, sweep.olat, sweep.cameras, sweep.set)
    assert given == ("default", "grid", 1, 0, None, False, {})
    assert (sweep.outputs, sweep.keep) == (("png",), ("final",))


@pytest.mark.parametrize("repeat", [1, 10**9])
def test_the_ends_of_how_often(repeat):
    assert checked_sweep({"vary": {"a": [1]}, "repeat": repeat, "seed": 0}, "sweep").repeat == repeat
    with pytest.raises(SceneError, match=r"sweep: repeat: expected a whole number from 1 to 10\^9, got 1000000001"):
        checked_sweep({"vary": {"a": [1]}, "repeat": 10**9 + 1}, "sweep")


def test_a_shipped_scene_stays_a_name(tmp_path):
    (tmp_path / "sweep.toml").write_text('scene = "small"\nvary.preset = ["paper"]')
    assert read_sweep(tmp_path / "sweep.toml").scene == "small"


@pytest.mark.parametrize(
    "data, message",
    [
        ({}, "sweep: vary: expected at least one key to vary, got {}; add it"),
        ({"vary": {}}, "sweep: vary: expected at least one key to vary, got {}; add it"),
        ({"vary": {"a": 3}}, 'sweep: vary.a: expected an array'),
        ({"vary": {"a": []}}, "sweep: vary.a: expected 1 to 1000000 values, got []; choose another value"),
        ({"vary": {"a": {"random": "dice"}}}, 'sweep: vary.a: expected "list", "spaced", "uniform"'),
        ({"vary": {"a": {"random": "uniform", "low": 0}}}, "sweep: vary.a.high: expected a value, got nothing; add it"),
        ({"vary": {"a": {"random": "uniform", "hihg": 0}}}, "hihg: expected a known key, got this one; did you"),
        ({"vary": {"a": {"first": 0, "last": 1, "count": 1}}}, "vary.a.count: expected a whole number from 2 to"),
        ({"vary": {"a": {"first": 0, "last": 1}}}, "sweep: vary.a.count: expected a value, got nothing"),
        ({"vary": {"a": [1]}, "outputs": []}, "sweep: outputs: expected one or several outputs, each once, got []"),
        ({"vary": {"a": [1]}, "outputs": ["png", "png"]}, "sweep: outputs: expected one or several outputs, each once"),
        ({"vary": {"a": [1]}, "outputs": ["jpg"]}, 'outputs[0]: expected "png", "npz", "exr" or "zarr", got "jpg"'),
        ({"vary": {"a": [1]}, "repeat": 0}, "sweep: repeat: expected a whole number from 1 to 10^9, got 0"),
        ({"vary": {"a": [1]}, "seed": -1}, "sweep: seed: expected a whole number >= 0, got -1"),
        ({"vary": {"a": [1]}, "combin": "zip"}, "combin: expected a known key, got this one; did you"),
        ({"vary": {"a": [1]}, "cameras": True, "outputs": ["npz"]}, 'cameras: expected false without the output "png"'),
        ({"olat": 3}, "sweep: olat: expected a table, got 3"),
        ({"olat": {}}, "sweep: olat.count: expected a value, got nothing; add it"),
        ({"olat": {"coutn": 3}}, "olat.coutn: expected a known key, got this one; did you mean count?"),
        ({"olat": {"count": 0}}, "sweep: olat.count: expected a whole number from 1 to 10000, got 0"),
        ({"olat": {"count": 2, "distance": 0}}, "sweep: olat.distance: expected a number > 0"),
        ({"olat": {"count": 2}, "vary": {"lights": {"0": {"intensity": [1]}}}}, "no lights.0.intensity beside olat"),
        ({"olat": {"count": 2}, "set": {"lights": {"0": {"near": 1}}}}, "expected no lights.0 beside olat, got both"),
        ({"vary": {"a": [1]}, "set": 3}, "sweep: set: expected a table"),
        ({"vary": {"a": [1]}, "set": {"camera": {"width": inf}}}, 'set.camera: expected finite numbers, got {"width"'),
        ({"vary": {"a": [1]}, "set": {"lights.0": {"color": [1, nan, 0]}}}, "sweep: set.lights.0: expected finite"),
        ({"vary": {"a": [1, nan]}}, "sweep: vary.a[1]: expected finite numbers, got NaN; nan and inf are not accepted"),
        ({"vary": {"a": [[0, -inf]]}}, "sweep: vary.a[0]: expected finite numbers"),
        ({"vary": {"a": {"random": "choice", "values": [inf]}}}, "vary.a.values[0]: expected finite numbers, got Inf"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_by_key(data, message):
    with pytest.raises(SceneError) as caught:
        checked_sweep(data, "sweep")
    assert message in str(caught.value)


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(SceneError, match=r"no.toml: expected a sweep file, got No such file"):
        read_sweep(tmp_path / "no.toml")


def test_a_light_stage_says_what_a_learner_needs_unless_told_otherwise():
    sweep = checked_sweep({"olat": {"count": 3}}, "sweep")
    assert sweep.outputs == ("png", "npz") and sweep.cameras
    assert {"position_world", "normal_world", "albedo", "thickness", "image"} < set(sweep.keep)
    assert list(sweep.vary) == ["lights"] and len(sweep.vary["lights"]) == 3
    told = checked_sweep({"olat": {"count": 3}, "keep": ["final"], "cameras": False, "vary": {"a": [1, 2]}}, "sweep")
    assert told.keep == ("final",) and not told.cameras and list(told.vary) == ["a", "lights"]


def test_how_many_lights_can_be_told_beside_the_file(tmp_path):
    path = tmp_path / "sweep.toml"
    path.write_text('scene = "small"\n[olat]\ncount = 3\nintensity = 2.0')
    stage = read_sweep(path, 5).olat
    assert (stage.count, stage.intensity) == (5, 2.0)
    path.write_text('scene = "small"')
    assert len(read_sweep(path, 5).vary["lights"]) == 5
