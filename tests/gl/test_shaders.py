"""A folder of a user's shaders: what of it is read, and what is said of the rest."""

from scenes import settings_with

from sss_ref.cli.shader_files import shaders_of

NAMES = ("camera_1.frag", "camera.vert", "blur.FRAG", "blur.wgsl", "camera.frag.bak", "README.md", ".gitignore")


def test_what_is_not_read_is_told_in_one_line_with_its_cause(tmp_path, capsys):
    settings = settings_with({})
    for name in NAMES:
        (tmp_path / name).write_text("")
    (tmp_path / "common").mkdir()
    (tmp_path / "taps.frag").write_text("")
    found = shaders_of(tmp_path, settings)
    assert {name: [path.name for path in paths] for name, paths in found.items()} == {
        "camera": ["camera.vert", "camera_1.frag"]
    }
    told = capsys.readouterr().err
    assert told == (
        f"note: {tmp_path}: not read: blur.FRAG (no .vert or .frag), blur.wgsl (no .vert or .frag), "
        "camera.frag.bak (no .vert or .frag), common (a folder), taps.frag (of a pass on demand)\n"
    )


def test_nothing_is_said_of_a_folder_that_is_read_whole(tmp_path, capsys):
    for name in ("camera.frag", "README.md", "LICENSE"):
        (tmp_path / name).write_text("")
    assert shaders_of(tmp_path, settings_with({})) == {"camera": [tmp_path / "camera.frag"]}
    assert shaders_of(None, settings_with({})) == {}
    assert capsys.readouterr().err == ""
