"""One pixel explained: what is told of it has the bits of the rendering."""

import numpy as np
import pytest
from scenes import around, cube, sphere, written

from sss_ref.errors import SceneError
from sss_ref.explanation.explain import explain
from sss_ref.language.types import components
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.shipped import scene_names

SMALL = {
    f"{table}.{side}": size
    for table, size in (("camera", 64), ("shadow_map", 64), ("irradiance_map", 48))
    for side in ("width", "height")
}


def assert_told_as_rendered(explanation):
    """Every buffer that a traced stage writes holds what the trace says, in every bit; how many that were."""
    count = 0
    for one in explanation.passes:
        for name, value in ((n, v) for traced in one.stages for n, v in traced.writes.items()):
            if name in explanation.result.buffers:
                column, row = one.place.pixel
                buffer = explanation.result[name]
                got = np.array(components(value), buffer.dtype)
                assert got.tobytes() == np.atleast_1d(buffer[row, column]).tobytes(), (one.name, name)
                count += 1
    return count


@pytest.mark.parametrize("name", scene_names())
def test_random_pixels_of_every_shipped_scene(name):
    result = render(load_scene(name, **SMALL))
    rng = np.random.default_rng(11)
    covered = np.argwhere(result["coverage"] != 0)
    told = [explain(result, (int(c), int(r))) for r, c in covered[rng.integers(0, len(covered), 4)]]
    told += [explain(result, (int(c), int(r))) for r, c in rng.integers(0, 64, (2, 2))]
    counts = [assert_told_as_rendered(explanation) for explanation in told]
    assert min(counts[:4]) >= 12
    assert [[one.name for one in e.passes] for e in told] == [[one.name for one in told[0].passes]] * 6


@pytest.fixture(scope="module")
def body(tmp_path_factory):
    return written(tmp_path_factory.mktemp("bodies") / "sphere.obj", *sphere(8))


def test_interpolated_values_and_weights_are_those_of_the_rendering(body):
    result = render(load_scene(around(body, size=32)))
    camera = explain(result, (16, 17)).passes[1]
    drawn = camera.drawn
    assert drawn.triangle == result["triangle"][17, 16] and not drawn.clipped
    assert (
        np.array(components(drawn.values["fragment_position"])).tobytes() == result["position_world"][17, 16].tobytes()
    )
    mesh = result.scene.mesh
    own = mesh.triangles[drawn.triangle]
    assert [corner.vertex for corner in drawn.corners] == own.tolist()
    weights = np.array([float(corner.weight) for corner in drawn.corners])
    mean = weights @ mesh.positions[own].astype(float) / weights.sum()
    assert np.abs(mean - result["position_world"][17, 16]).max() < 1e-6
    for vertex, index in zip(drawn.vertices, own, strict=True):
        assert vertex.at == f"vertex {index}"
        assert components(vertex.writes["fragment_position"]) == mesh.positions[index].tolist()


def test_a_piece_that_was_cut_is_said_to_be(body):
    result = render(load_scene(around(body, size=32), **{"camera.near": 3.8}))
    cut = [explain(result, (16, row)).passes[1].drawn for row in range(32) if result["coverage"][row, 16]]
    assert {drawn.clipped for drawn in cut} == {True, False}


def test_places_follow_the_lookups(body):
    scene = around(body, size=32, method="texture_space", preset="robust")
    scene["irradiance_map"] = {"width": 32, "height": 16}
    result = render(load_scene(scene))
    column, row = 16, 17
    light, layout, *_, camera = explain(result, (column, row)).passes
    u, v = result["shadow_uv"][row, column]
    assert light.place.pixel == (int(u * np.float32(32)), int(v * np.float32(32)))
    u, v = result["irradiance_uv"][row, column]
    assert layout.place.pixel == (int(u * np.float32(32)), int(v * np.float32(16)))
    assert camera.place.pixel == (column, row)


def test_every_light_has_its_own_place(tmp_path):
    path = written(tmp_path / "cube.obj", *cube())
    lights = [{"position": [2.0, 1.5, 2.5]}, {"position": [-2.0, 1.5, -2.5]}]
    result = render(load_scene(around(path, size=32, lights=lights)), interpreter="arrays")
    told = explain(result, (16, 16))
    assert assert_told_as_rendered(told) > 15
    for one, suffix in zip(told.passes[:2], ("_1", "_2"), strict=True):
        u, v = result[f"shadow_uv{suffix}"][16, 16]
        assert one.place.pixel == (int(u * np.float32(32)), int(v * np.float32(32)))


def test_beside_the_model_only_the_rectangles_run(body):
    told = explain(render(load_scene(around(body, size=32)), interpreter="arrays"), (0, 0))
    assert {one.name: bool(one.stages) for one in told.passes} == {
        "shadow_map": False,
        "camera": False,
        "blur": False,
        "composite": True,
    }
    assert told.passes[1].place.reason == "the pixel itself; nothing is drawn there"


def test_what_cannot_be_explained(body):
    scene = load_scene(around(body, size=32))
    for pixel in ((32, 0), (0, 32), (-1, 0)):
        at = f"{pixel[0]},{pixel[1]}"
        with pytest.raises(SceneError, match=f"pixel: expected column 0 to 31 and row 0 to 31, got {at}; row 0 is"):
            explain(scene, pixel)
    with pytest.raises(SceneError, match='got no light_triangle; render with keep="all"'):
        explain(render(scene, interpreter="arrays", keep="final"), (0, 0))
