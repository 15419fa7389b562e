"""A user's shader files: which pass they stand for, what they say they write, how many textures they read."""

import pytest
from scenes import settings_with

from sss_ref.cli.shader_files import shaders_of
from sss_ref.errors import ShaderError
from sss_ref.gl.shaders import ShaderPair, listed, own_shaders, shader_folder, user_shaders, user_vertex_file
from sss_ref.interpret.shader import GLSL, array_lengths
from sss_ref.scene.load import load_scene

NAMES = ("camera_1.frag", "camera.vert", "blur.FRAG", "blur.wgsl", "camera.frag.bak", "README.md", ".gitignore")
SCENE = load_scene("sphere", preset="robust")
CAMERA = SCENE.method["camera"]


@pytest.fixture
def written(tmp_path):
    """Writes files of these names; their paths."""

    def write(**texts):
        paths = [tmp_path / name.replace("__", ".") for name in texts]
        for path, text in zip(paths, texts.values(), strict=True):
            path.write_text(text)
        return paths

    return write


def fragment(*outputs):
    """A shader that writes these buffers, (location, name)."""
    return "".join(f"layout(location = {at}) out vec3 out_{name};\n" for at, name in outputs)


def refusal(files):
    with pytest.raises(ShaderError) as error:
        user_shaders(CAMERA, files, array_lengths(SCENE.uniforms))
    return str(error.value)


def test_what_a_shader_writes_is_read_by_location(written):
    paths = written(a__frag=fragment((1, "albedo"), (0, "lit")), b__frag=fragment((0, "phong")), c__vert="mine")
    pairs = user_shaders(CAMERA, paths, array_lengths(SCENE.uniforms))
    assert [(pair.name, pair.outputs) for pair in pairs] == [
        (str(paths[0]), ("lit", "albedo")),
        (str(paths[1]), ("phong",)),
    ]
    assert [pair.vertex for pair in pairs] == ["mine"] * 2 and pairs[1].fragment == fragment((0, "phong"))
    (alone,) = user_shaders(CAMERA, str(paths[1]), array_lengths(SCENE.uniforms))
    assert "gl_Position" in alone.vertex


@pytest.mark.parametrize(
    ("outputs", "count"),
    [((), 0), (((1, "lit"),), 1), (((0, "lit"), (2, "phong")), 2), (((0, "lit"), (0, "phong")), 2)],
)
def test_locations_begin_at_0_without_a_gap(written, outputs, count):
    told = refusal(written(a__frag=fragment(*outputs)))
    assert f"a.frag: expected outputs at locations 0, 1 ... of 1 to {GLSL.most_outputs} buffers (" in told
    assert f", got {count}; declare each as " in told


def test_as_many_outputs_as_the_dialect_allows(written):
    names = list(CAMERA.values)[: GLSL.most_outputs + 1]
    (path,) = written(a__frag=fragment(*enumerate(names[:-1])))
    (pair,) = user_shaders(CAMERA, path, array_lengths(SCENE.uniforms))
    assert pair.outputs == tuple(names[:-1]) and len(pair.outputs) == GLSL.most_outputs == 8
    assert ", got 9; declare" in refusal(written(a__frag=fragment(*enumerate(names))))


def test_only_what_the_pass_writes(written):
    told = refusal(written(a__frag=fragment((0, "lit"), (1, "scattered"))))
    assert "a.frag: expected outputs of pass camera (" in told and told.endswith("), got out_scattered; rename it")


def test_one_vertex_shader_a_pass(written):
    first, second, other = written(a__vert="", b__vert="", c__frag="")
    assert user_vertex_file([other]) is None and user_vertex_file([other, second]) == second
    with pytest.raises(ShaderError) as error:
        user_vertex_file([first, other, second])
    assert str(error.value) == f"{second}: expected one vertex shader a pass, got {first} as well; remove one"


def test_one_file_or_several(tmp_path):
    assert listed(str(tmp_path)) == listed(tmp_path) == listed([tmp_path]) == [tmp_path]
    assert listed([tmp_path, "a"])[1].name == "a"


def test_files_stand_for_the_pass_of_their_name(written, tmp_path):
    """With a number or without; others than shaders, and those of a pass on demand, are left out."""
    first, second, vertex, blur, _, taps = written(
        camera__frag="", camera_2__frag="", camera__vert="", blur__frag="", notes__txt="", taps__frag=""
    )
    found = shader_folder(tmp_path, SCENE.settings)
    assert found == {"camera": [first, vertex, second], "blur": [blur]} and taps.exists()
    assert list(found) == ["camera", "blur"]


def test_a_folder_without_shaders_and_a_file_of_no_pass(written, tmp_path):
    passes = "shadow_map, camera, blur, composite"
    with pytest.raises(ShaderError) as error:
        shader_folder(tmp_path, SCENE.settings)
    expected = f"expected files NAME.frag or NAME.vert, NAME a pass ({passes}), got none"
    assert str(error.value) == f"{tmp_path}: {expected}"
    (path,) = written(glow__frag="")
    with pytest.raises(ShaderError) as error:
        shader_folder(tmp_path, SCENE.settings)
    assert str(error.value) == f"{path}: expected the name of a pass ({passes}), got glow; rename it"


def test_more_textures_than_units_are_told():
    pair = ShaderPair("camera", "", "uniform sampler2D a;\nuniform isampler2D b;\nuniform float c;\n", ("lit",))
    pair.check_units(2)
    with pytest.raises(
        ShaderError, match="camera: expected at most 1 textures, as this OpenGL has units for, got 2; draw"
    ):
        pair.check_units(1)


def test_our_own_are_named_after_the_pass_or_the_users_vertex_shader(written):
    lengths = array_lengths(SCENE.uniforms)
    (vertex,) = written(a__vert="mine")
    ours, mixed = (own_shaders(CAMERA, [], {"lit"}, lengths, file) for file in (None, vertex))
    assert [pair.name for pair in ours] == ["camera"] and [pair.name for pair in mixed] == [str(vertex)]
    assert mixed[0].vertex == "mine" and mixed[0].fragment == ours[0].fragment and ours[0].outputs == ("lit",)


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
