"""What the page that judges is told of an exam: by hand, of a small scene that draws into a layout and a picture."""

import base64
import zlib

import numpy as np
import pytest
from judging import small

from sss_ref.numerics.inward import ordered
from sss_ref.rendering.fold import render
from sss_ref.webgl.exam_forms import form_of_draw, forms_of_stage
from sss_ref.webgl.exam_of_draw import exam_of_draw
from sss_ref.webgl.exams import WEBGL, every_value, exams


@pytest.fixture(scope="module")
def oracle():
    scene = small("lesson_seam", 16)
    return render(scene, "arrays", threads=1, keep=every_value(scene))


ASKED = ("surface", "back_point", "light_visible_kernel", "irradiance_lookup_throughout")


@pytest.fixture(scope="module")
def camera(oracle):
    """Some exams of the camera's stages by name, each with its form."""
    found = {each.stage.name: each for each in exams(oracle, oracle.scene.method["camera"])}
    return {name: (found[name], *forms_of_stage(oracle.scene, found[name])) for name in ASKED}


def unpacked(text, dtype):
    planes = np.frombuffer(zlib.decompress(base64.b64decode(text["deflated"])), np.uint8)
    return planes.reshape(text["size"], -1).T.copy().view(dtype).ravel()


def test_a_device_snaps_to_16_steps_of_a_pixel_at_least():
    """OpenGL ES 3.0 asks for 4 SUBPIXEL_BITS; how it rounds to these is not said."""
    assert (WEBGL.subpixel_bits, WEBGL.snap) == (4, "any")


def test_what_a_stage_reads_and_where_it_stands(camera):
    _, found = camera["irradiance_lookup_throughout"]
    assert found["reads"] == [
        {"own": "uv", "name": "uv", "type": "vec2", "whole": False},
        {"own": "shadow_valid", "name": "inside_shadow_valid", "type": "bool", "whole": False},
        {"own": "shadow_uv", "name": "inside_shadow_uv", "type": "vec2", "whole": False},
        {"own": "light_uv", "name": "light_uv", "type": "Texture[vec2]", "whole": True},
    ]
    assert found["given"] == {name: name for name in ("inside_shadow_uv", "inside_shadow_valid", "light_uv", "uv")}
    assert found["about"].endswith("lit or not; the own one where none is known.") and "\n" not in found["about"]
    assert found["source_of"].startswith("paper 2.2") and (found["pass"], found["edit"]) == ("camera", "fragment")


def test_of_a_longer_description_the_first_paragraph_is_told(camera):
    for name in ASKED:
        exam, found = camera[name]
        assert found["about"] == " ".join(exam.stage.description.split("\n\n")[0].split())


def test_what_is_interpolated_lies_under_the_name_of_its_pass(camera):
    exam, found = camera["surface"]
    assert found["given"] == {
        name: f"camera/{name}" for name in ("fragment_normal", "fragment_position", "fragment_uv")
    }
    (draw,) = found["draws"]
    assert draw["name"] == "camera/surface"
    assert [each["name"] for each in draw["outputs"]] == list(exam.alone.values)


def test_right_lies_so_many_steps_around_the_reference(camera):
    exam, found = camera["back_point"]
    units = {name: right["unit"] for name, right in found["right"].items()}
    assert units == {"entry_point": "scene units, world space", "thickness": "scene units along the light's ray"}
    for name, right in found["right"].items():
        ends = exam.right[name]
        middle = ordered(ends.middle).ravel()
        assert (middle - unpacked(right["below"], np.uint32) == ordered(ends.low).ravel()).all()
        assert (middle + unpacked(right["above"], np.uint32) == ordered(ends.high).ravel()).all()
        assert unpacked(right["state"], np.uint8).tolist() == ends.state.ravel().tolist()


@pytest.fixture(scope="module", params=["camera", "irradiance_map"])
def draw(request, oracle):
    exam = exam_of_draw(oracle, oracle.scene.method[request.param])
    return request.param, exam, form_of_draw(oracle, exam)


def test_a_draw_of_the_mesh_shows_its_triangle_its_depth_and_what_is_interpolated(draw):
    """Of a layout no depth, for it has none; beside the mesh stand no triangle, the far plane, and 0."""
    name, _, found = draw
    parts = {"fragment_position": 3, "fragment_normal": 3, "fragment_uv": 2}
    first = {"triangle": (1, -1)} | ({"depth": (1, 1.0)} if name == "camera" else {})
    outputs = {
        each["name"]: (each["channels"], each["background"][0]) for one in found["draws"] for each in one["outputs"]
    }
    more = {each: (1, -1) for each in outputs if each.startswith("triangle_")}
    assert outputs == first | {each: (count, 0) for each, count in parts.items()} | more
    assert len(more) == len(found["draws"]) - 1
    starts = [1, 4, 7]
    assert found["varyings"] == {
        each: {"first": start, "channels": count} for (each, count), start in zip(parts.items(), starts, strict=True)
    }
    assert found["shown"] == {each: f"{name}/{each}" for each in (*first, *parts)}


def test_a_draw_is_drawn_once_and_its_vertex_stage_is_what_may_be_edited(draw):
    name, _, found = draw
    assert (found["rounds"], found["feedback"], found["edit"], found["given"]) == (1, {}, "vertex", {})
    assert (found["pass"], found["width"], found["height"], found["mesh"]) == (name, 16, 16, "mesh")
    assert 0 < len(found["mistakes"]) <= 2 and {*found["mistakes"][0]} == {"about", "line", "text"}


def test_the_candidates_are_those_of_the_exam(draw):
    _, exam, found = draw
    given = {
        "covered": exam.covered, "first": exam.first, "triangle": exam.triangle, "low": exam.low, "high": exam.high
    }  # fmt: skip
    assert found["candidates"].keys() == given.keys()
    for name, array in given.items():
        assert unpacked(found["candidates"][name], array.dtype).tobytes() == array.tobytes()


def test_the_ends_are_as_near_as_a_snapped_corner_leaves_them(draw):
    """Normals are those of a flat side, of which rounding alone leaves a little; all else moves with the corners."""
    _, exam, _ = draw
    apart = (exam.high - exam.low)[:, 1:]
    apart = apart[np.isfinite(apart).all(axis=1)]
    position, normal, uv = apart[:, :3], apart[:, 3:6], apart[:, 6:]
    assert len(apart) > 100 and (apart >= 0).all()
    assert 0 < normal.max() < 1e-5 and position.max() < 0.5 and uv.max() < 0.1
