"""A witness through its file: the same verdict from the file alone, as this version judges it."""

import json
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from wrong_pixels import WRONG, found_in, mistaken, same_bits, witness_of

from sss_ref.cli import main
from sss_ref.errors import SssRefError
from sss_ref.language import stage, vec2, vec3
from sss_ref.rendering.fold import render
from sss_ref.scene.own_stage import with_stage
from sss_ref.validation.witness import recalling
from sss_ref.validation.witness.recalling import recalled
from sss_ref.validation.witness.recording import recorded
from sss_ref.validation.witness.witness import as_value
from sss_ref.validation.witness.witness_record import read_record, write_record

LARGEST = 2048  # bytes of a file


def through_file(witness, path):
    return recalled(read_record(write_record(recorded(witness), path)), str(path))


@pytest.mark.parametrize("name", WRONG)
def test_the_file_alone_tells_what_the_run_told(name, tmp_path):
    witness = witness_of(name)
    again = through_file(witness, tmp_path / "wrong.json")
    assert (witness.drawn.buffer, witness.outcome, again.outcome) == (name, "fail", "fail")
    for each in ("got", "expected", "reach"):
        assert same_bits(getattr(again, each), getattr(witness, each)), each
    assert (tmp_path / "wrong.json").stat().st_size <= LARGEST
    assert replace(again, got=again.expected).outcome != "fail"


def test_elements_that_it_lacks_are_never_read(tmp_path):
    """The file has some texels of each texture; whatever stands in the others, the bounds are the same."""
    witness = witness_of("scattered")
    again = through_file(witness, tmp_path / "wrong.json")
    texture = again.situation.exact["lit"]
    held = np.zeros(texture.data.shape[:2], bool)
    for at in witness.situation.reads(witness.profile)["lit"]:
        held[at] = True
    assert 0 < held.sum() < held.size
    texture.data[~held] = np.nan
    assert same_bits(again.reach, witness.reach) and same_bits(again.expected, witness.expected)


def test_what_storage_and_missing_buffers_leave_open_is_in_the_file(tmp_path):
    right, buffers = mistaken("phong")
    buffers = {name: buffers[name] for name in ("phong", "triangle", "normal_world")}
    buffers["normal_world"] = buffers["normal_world"].astype(np.float16).astype(np.float32)
    buffers["phong"] = buffers["phong"].astype(np.float16).astype(np.float32)
    witness = found_in(right, buffers, stored={"normal_world": "float16", "phong": "float16"})
    again = through_file(witness, tmp_path / "wrong.json")
    assert again.drawn.stored == "float16" and again.outcome == "fail"
    assert same_bits(again.reach, witness.reach) and (again.reach > 2.0**-14).any()
    assert {line.split()[0] for line in recorded(witness).why} >= {"normal_world", "position_world"}


class Own(NamedTuple):
    """Albedo alone."""

    phong: vec3


@stage(source="a test")
def own_phong(albedo: vec3, incident_light: vec3) -> Own:
    """Light and colour, whatever the angle."""
    return Own(albedo * incident_light)


def test_a_stage_of_the_users_own_is_found_in_its_scene(tmp_path):
    right, _ = mistaken("phong")
    scene = with_stage(right.scene, "phong_shading", own_phong)
    oracle = render(scene, "arrays")
    witness = found_in(oracle, dict(oracle.buffers) | {"phong": np.nextafter(oracle["phong"], np.float32(9)) + 1})
    path = write_record(recorded(witness), tmp_path / "own.json")
    again = recalled(read_record(path), str(path), scene.own_stages)
    assert again.outcome == "fail" and same_bits(again.expected, witness.expected)
    assert main(["witness", str(path)]) == 2


@pytest.fixture
def file(tmp_path):
    return write_record(recorded(witness_of("phong")), tmp_path / "wrong.json")


def changed(file, **keys):
    file.write_text(json.dumps(json.loads(file.read_text()) | keys))
    return str(file)


def test_wrong_and_right_by_the_exit_code(file, capsys):
    expected = json.loads(file.read_text())["expected"]
    assert main(["witness", str(file)]) == 1
    assert capsys.readouterr().out.endswith("wrong: phong is out of reach\n")
    assert main(["witness", changed(file, got=expected)]) == 0
    printed = capsys.readouterr().out
    assert printed.startswith("stage phong_shading of pass camera, pixel ")
    assert printed.endswith("right: phong is in reach\n")


@pytest.mark.parametrize(
    ("keys", "says"),
    [
        ({"rules": 1}, "other: written by rules version 1, here it is 2; by the stage here it is wrong"),
        ({"stage": {"name": "phong_shading", "source": "0" * 16}}, "other: stage phong_shading is "),
    ],
)
def test_other_rules_and_another_source_are_told_apart(file, capsys, keys, says):
    assert main(["witness", changed(file, **keys)]) == 2
    assert says in capsys.readouterr().out


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ({"format": "sss_ref witness 9"}, 'format: expected "sss_ref witness 1"'),
        ({"got": "3f800000"}, "got: expected bits of a value of its type, got others"),
        ({"output": "lit"}, "output: expected one of phong, got lit"),
        ({"reads": {}}, "reads: expected position_world, "),
        ({"stage": {"name": "nobody", "source": ""}}, "stage: expected a stage of this version"),
        ({"profile": {"based_on": "nothing"}}, "profile: based_on: expected "),
        ({"stored": "float15"}, "stored: expected float32 or one of "),
        ({"colour": 1}, "colour: expected a known key"),
    ],
)
def test_what_is_wrong_with_a_file_is_told_in_one_line(file, keys, message):
    with pytest.raises(SssRefError) as told:
        recalled(read_record(Path(changed(file, **keys))), str(file))
    assert message in str(told.value)
    assert "\n" not in str(told.value)


@pytest.mark.parametrize(
    "element",
    [{"size": [10**9, 10**9]}, {"at": "40,0*2x2"}, {"at": "-1,0*2x2"}, {"at": "0,0"}, {"bits": "AAAA"}, {"bits": "?"}],
)
def test_texels_that_do_not_fit_are_refused(tmp_path, element):
    path = write_record(recorded(witness_of("scattered")), tmp_path / "wrong.json")
    reads = json.loads(path.read_text())["reads"]
    with pytest.raises(SssRefError, match=r"reads\.lit: expected bits"):
        recalled(read_record(Path(changed(path, reads=reads | {"lit": reads["lit"] | element}))), "wrong.json")


@pytest.mark.parametrize(("spare", "message"), [(0, None), (-1, r"reads\.lit: expected bits")])
def test_no_texture_takes_more_memory_than_there_is(tmp_path, monkeypatch, spare, message):
    path = write_record(recorded(witness_of("scattered")), tmp_path / "wrong.json")
    monkeypatch.setattr(recalling, "MEMORY_LIMIT", 32 * 32 * 3 * 4 + spare)
    with pytest.raises(SssRefError, match=message) if message else nullcontext():
        recalled(read_record(path), str(path))


def test_what_is_as_it_mostly_is_is_not_written(file):
    keys = {"format", "rules", "stage", "output", "buffer", "in_pass", "at", "profile", "reads", "why"}
    assert json.loads(file.read_text()).keys() == keys | {"got", "expected", "low", "high"}
    assert file.read_text().count("\n") == 1


def test_a_value_is_a_vector_or_a_number():
    assert isinstance(as_value(vec2, np.float32([1, 2])), vec2)
    assert as_value(float, np.float32([3])) == 3


def test_no_json_at_all(tmp_path):
    (tmp_path / "text.json").write_text("no")
    with pytest.raises(SssRefError, match="expected a witness in JSON, got none"):
        read_record(tmp_path / "text.json")
