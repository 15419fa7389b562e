import hashlib
import time
from weakref import ref

import numpy as np
import pytest
from scenes import around, cube, written

from sss_ref.errors import RenderError, SceneError
from sss_ref.rendering.fold import folded, machine_of, render
from sss_ref.rendering.result import buffer_hash
from sss_ref.scene.load import load_scene

PASSES = ["shadow_map", "camera", "blur", "composite"]


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("cube") / "cube.obj", *cube())
    return load_scene(around(path, size=48), preset="robust")


@pytest.fixture(scope="module")
def everything(scene):
    return render(scene)


@pytest.mark.parametrize("interpreter", ["kernel", "arrays"])
@pytest.mark.parametrize(
    "keep",
    [
        "final",
        "scattered",
        ["thickness"],
        ["image", "light_depth", "depth"],
        ["coverage"],
        ["scattered", "light_distance"],
        [],
    ],
    ids=str,
)
def test_what_is_kept_has_the_bits_it_always_has(scene, everything, keep, interpreter):
    result = render(scene, keep=keep, interpreter=interpreter)
    names = [{"final": "image"}.get(keep, keep)] if isinstance(keep, str) else keep
    wanted = [name for name in everything.buffers if name in names]
    assert list(result.buffers) == wanted
    assert result.hashes == {name: everything.hashes[name] for name in wanted}


@pytest.mark.parametrize("keep", ["everything", ["image", "irradiance"]])
def test_an_unknown_buffer_is_an_error_that_lists_the_known(scene, keep):
    wrong = "irradiance" if isinstance(keep, list) else keep
    with pytest.raises(SceneError) as caught:
        render(scene, keep=keep)
    listed = 'expected "all", "final" or names of buffers (light_triangle, light_depth, light_distance, triangle, '
    assert str(caught.value).startswith(f"keep: {listed}")
    assert str(caught.value).endswith(f", scattered, image, taps, registers), got {wrong!r}")


def test_an_unknown_interpreter_is_an_error_that_lists_the_known(scene):
    with pytest.raises(SceneError, match=r"^interpreter: expected one of kernel, arrays, got 'gpu'$"):
        render(scene, interpreter="gpu")


def test_each_pass_is_announced_and_timed(scene):
    announced = []
    result = render(scene, on_pass=announced.append)
    assert announced == list(result.timings) == PASSES
    assert all(seconds >= 0 for seconds in result.timings.values())


def test_a_pass_that_nothing_kept_depends_on_does_not_run(scene):
    assert list(render(scene, keep=["light_depth"]).timings) == ["shadow_map"]
    assert list(render(scene, keep=["depth", "normal_world"]).timings) == ["camera"]
    assert list(render(scene, keep=["thickness"]).timings) == ["shadow_map", "camera"]


def test_a_buffer_that_was_not_kept_is_an_error_that_says_so(scene):
    with pytest.raises(SceneError, match=r"^buffer: expected one of image, got 'lit'; render with keep to have it$"):
        render(scene, keep="final")["lit"]


def test_the_scene_is_not_changed_by_rendering(scene, everything):
    hashes = scene.mesh.hashes()
    assert render(scene).hashes == everything.hashes
    assert scene.mesh.hashes() == hashes


def test_a_mesh_without_uvs_has_uv_zero(everything):
    assert everything.scene.mesh.uvs is None
    assert not everything["uv"].any()


def test_the_background_shows_where_the_model_is_not(scene):
    red = load_scene(scene.settings.model_dump(exclude_none=True), **{"output.background": [1.0, 0.0, 0.0]})
    result = render(red, keep=["image", "coverage"])
    assert (result.image[result["coverage"] == 0] == (1, 0, 0)).all()
    assert (result.image[result["coverage"] == 1] == render(scene).image[result["coverage"] == 1]).all()


def test_an_infinity_that_is_not_kept_still_stops_the_rendering(scene):
    glaring = load_scene(
        scene.settings.model_dump(exclude_none=True), **{"lights.0.intensity": 3e38, "lights.0.color": [9, 9, 9]}
    )
    with pytest.raises(RenderError, match=r"^stage light_constant, pixel "):
        render(glaring, keep="final")


@pytest.mark.parametrize(
    ("buffer", "head"),
    [
        (np.array([[1.5, -0.0]], "<f4"), b"sss_ref buffer 1\nname\n<f4\n1,2,1\n"),
        (np.array([[[1, 2, 3]], [[4, 5, 6]]], "<f4"), b"sss_ref buffer 1\nname\n<f4\n2,1,3\n"),
        (np.array([[-1], [7]], "<i4"), b"sss_ref buffer 1\nname\n<i4\n2,1,1\n"),
        (np.array([[0, 1, 1]], "u1"), b"sss_ref buffer 1\nname\n|u1\n1,3,1\n"),
    ],
)
def test_a_hash_is_over_name_type_size_and_little_endian_data(buffer, head):
    expected = hashlib.sha256(head + buffer.tobytes()).hexdigest()
    assert buffer_hash("name", buffer) == expected
    assert buffer_hash("name", buffer.astype(buffer.dtype.newbyteorder(">"))) == expected
    assert buffer_hash("name", np.asfortranarray(buffer)) == expected
    assert buffer_hash("other", buffer) != expected


def test_the_sign_of_zero_is_part_of_a_hash():
    assert buffer_hash("name", np.float32([[0.0]])) != buffer_hash("name", np.float32([[-0.0]]))


def test_subpixel_bits_are_those_of_the_rules_unless_told(scene, everything):
    assert render(scene, subpixel_bits=8).hashes == everything.hashes
    coarse = render(scene, subpixel_bits=2)
    assert coarse.hashes == render(scene, "arrays", subpixel_bits=2).hashes != everything.hashes
    with pytest.raises(SceneError, match=r"^subpixel_bits: expected 0 to 8, got 9;"):
        render(scene, subpixel_bits=9)


def test_kept_buffers_are_handed_out_after_their_pass_and_once(scene, everything):
    events = []
    with machine_of("kernel") as machine:
        result = folded(scene, machine, scene.kept("all"), events.append, lambda *named: events.append(named))
    handed = dict(event for event in events if not isinstance(event, str))
    assert {name: buffer_hash(name, buffer) for name, buffer in handed.items()} == everything.hashes
    assert list(result.buffers) == ["image"] and result.image is handed["image"]
    told = [event if isinstance(event, str) else event[0] for event in events]
    assert told == [name for each in PASSES for name in (each, *sorted(scene.method[each].outputs))]


def test_what_is_handed_out_is_let_go_when_no_pass_reads_it_any_more(scene):
    handed = {}
    with machine_of("kernel") as machine:
        result = folded(
            scene, machine, scene.kept("all"), on_buffer=lambda name, buffer: handed.update({name: ref(buffer)})
        )
    assert [name for name, buffer in handed.items() if buffer() is not None] == [*result.buffers]


@pytest.mark.parametrize(("threads", "processors", "count"), [(1, 8, 1), (2, 8, 2), (None, 3, 3), (None, None, 1)])
def test_as_many_threads_as_are_asked_for_or_as_there_are_processors(monkeypatch, threads, processors, count):
    """One does it all itself."""
    monkeypatch.setattr("os.cpu_count", lambda: processors)
    with machine_of("kernel", threads) as machine:
        assert (machine.pool.count if machine.pool else 1) == count and machine.stops


def test_a_pass_takes_as_long_as_the_clock_says(scene):
    before = time.perf_counter()
    timings = render(scene).timings
    assert 0 < sum(timings.values()) <= time.perf_counter() - before


def test_what_is_drawn_by_itself_is_told_once_the_image_is_kept(scene):
    glaring = {"phong.ambient": 1e6}
    bright = load_scene(scene.settings.model_dump(exclude_none=True), **glaring)
    assert len(render(bright, keep="final").notes) == 1 and render(bright, keep=["lit", "coverage"]).notes == ()
