"""The printed mapping: it reads what `render` writes as it stands, and with every key of it that can be given."""

import re

import numpy as np
import pytest

import sss_ref
from sss_ref.cli import main
from sss_ref.dump.mapping import BufferTable, MappingFile, read_mapping
from sss_ref.dump.mapping_template import key_reference, mapping_template
from sss_ref.dump.read import read_dump

SMALL = {f"{t}.{s}": 24 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}
KEY = re.compile(r"^# (\w+ = .*)$", re.MULTILINE)
SCENES = ["figure3_with", "figure5", "figure4_glass", "default"]


@pytest.fixture(scope="module", params=SCENES)
def result(request, tmp_path_factory):
    """A rendering of all buffers, and its folder."""
    rendered = sss_ref.render(sss_ref.load_scene(request.param, **SMALL), "arrays")
    return rendered, rendered.save(tmp_path_factory.mktemp(request.param) / "out") / "buffers"


def read_with(text, result):
    rendered, folder = result
    (folder / "mapping.toml").write_text(text)
    return read_dump(folder / "mapping.toml", rendered.scene)


def is_of_other_files(line):
    """Of raw files, of parts of files, and of all buffers."""
    return re.match(r"(shape|dtype|file|device) = ", line)


def test_as_it_stands_it_reads_every_buffer_bit_for_bit(result):
    rendered, _ = result
    found = read_with(mapping_template(rendered.scene), result)
    assert list(found.buffers) == list(rendered.buffers)
    for name, buffer in rendered.buffers.items():
        assert found.buffers[name].data.tobytes() == buffer.tobytes(), name
        assert found.buffers[name].stored in ("float32", "int32", "uint8")
    assert sss_ref.validate(rendered, {name: one.data for name, one in found.buffers.items()}, explain=False).passed


def test_with_every_key_it_says_the_same(result):
    """What a key says in it is what counts without: no bit changes, whatever is uncommented."""
    rendered, _ = result
    tables, _, _ = mapping_template(rendered.scene).partition("# What no target holds")
    text = KEY.sub(lambda found: found[0] if is_of_other_files(found[1]) else found[1], tables)
    assert text.count("\nscale = 1.0") == len(rendered.buffers)
    for name, one in read_with(text, result).buffers.items():
        assert one.data.tobytes() == rendered[name].tobytes(), name


def test_the_lines_for_raw_files_read_them(result):
    rendered, folder = result
    for name, buffer in rendered.buffers.items():
        np.ascontiguousarray(buffer).tofile(folder / f"{name}.raw")
    tables, _, _ = mapping_template(rendered.scene).partition("# What no target holds")
    text = re.sub(r"^file = .*\n", "", tables, flags=re.MULTILINE)
    text = re.sub(r"^# ((file|shape|dtype|origin) = .*)$", r"\1", text, flags=re.MULTILINE)
    for name, one in read_with(text, result).buffers.items():
        assert one.data.tobytes() == rendered[name].tobytes(), name


def test_every_key_of_a_mapping_file_is_in_it():
    scenes = [sss_ref.load_scene(name, **SMALL) for name in SCENES]
    shown = {found[1].split(" = ")[0] for scene in scenes for found in KEY.finditer(mapping_template(scene))}
    assert shown == {*BufferTable.model_fields, *MappingFile.model_fields} - {"buffers", "part"}
    for key in BufferTable.model_fields:
        assert f"# buffers.NAME.{key}: " in mapping_template(scenes[0])


def test_registers_are_there_as_comments(tmp_path):
    scene = sss_ref.load_scene("figure4_glass", **SMALL)
    text = mapping_template(scene)
    assert '# [buffers.exact_lit]\n# file = "exact_lit.npy"\n' in text and "# [buffers.tap_12]" in text
    (tmp_path / "mapping.toml").write_text(re.sub(r"^# (\[buffers\.|file = .*npy)", r"\1", text, flags=re.MULTILINE))
    assert set(read_mapping(tmp_path / "mapping.toml").buffers) == set(scene.method.values)


def test_no_line_is_too_long_for_a_screen():
    assert max(map(len, mapping_template(sss_ref.load_scene("figure5")).splitlines())) <= 120


def test_the_command_prints_it_and_its_help_has_every_key(capsys):
    scene = sss_ref.load_scene("figure5", **SMALL)
    assert main(["mapping", "figure5", *(word for key in SMALL for word in ("--set", f"{key}=24"))]) == 0
    assert capsys.readouterr().out == mapping_template(scene)
    main(["mapping", "--help"])
    printed = "".join(capsys.readouterr().out.split())
    assert "".join(key_reference().replace("`", "").split()) in printed.replace("`", "")


def test_the_commands_of_the_command_line_say_what_it_is_for(capsys):
    main(["--help"])
    assert "mapping      Print a mapping file to edit" in capsys.readouterr().out


def test_an_unknown_scene_is_one_line(capsys):
    assert main(["mapping", "none"]) == 2
    assert capsys.readouterr().err.count("\n") == 1
