from dataclasses import replace

import pytest
from one_stage import assert_same_bits

from sss_ref import load_scene
from sss_ref.interpret.kernel import strips
from sss_ref.rendering.crew import Crew
from sss_ref.rendering.draw import Machine, made_ready
from sss_ref.rendering.foresight import Foresight


@pytest.fixture(scope="module")
def scene():
    sides = {
        f"{table}.{side}": 16 for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")
    }
    return load_scene("default", method="texture_space", **sides)


def test_the_next_mesh_is_begun_as_soon_as_it_is_a_pass_s_turn(scene):
    passes = scene.method.passes
    first, *drawn = [each.name for each in passes if each.draw.vertex_stages]
    assert len(drawn) == 3 and passes[0].name == first
    with Crew(2) as pool:
        machine = Machine(strips, pool)
        foresight = Foresight(scene, passes, machine)
        assert foresight.mesh(passes[0]) is None
        for each in passes[1:]:
            assert [*foresight.begun] == drawn[:1]
            mesh = foresight.mesh(each)
            drawn = [name for name in drawn if name != each.name]
            if not each.draw.vertex_stages:
                assert mesh is None
                continue
            expected = made_ready(scene, each, {}, machine)
            assert_same_bits(mesh.primitives._asdict(), expected.primitives._asdict())
            assert_same_bits({"members": mesh.bins.members}, {"members": expected.bins.members})
    assert not drawn and not foresight.begun


def test_one_thread_begins_nothing(scene):
    foresight = Foresight(scene, scene.method.passes, Machine(strips))
    assert foresight.mesh(scene.method["camera"]) is None
    assert foresight.begun == {}


def test_vertices_that_read_a_buffer_wait_for_it(scene):
    camera = scene.method["camera"]
    displaced = replace(camera, draw=replace(camera.draw, vertex=camera.draw.vertex.bound(world_from_model="a_buffer")))
    with Crew(2) as pool:
        machine = Machine(strips, pool)
        foresight = Foresight(scene, [scene.method["irradiance_map"], displaced], machine)
        foresight.mesh(scene.method["irradiance_map"])
        assert foresight.begun == {}
        assert foresight.mesh(displaced) is None
        mesh = made_ready(scene, displaced, {"a_buffer": scene.uniforms["world_from_model"]}, machine)
        assert_same_bits(mesh.primitives._asdict(), made_ready(scene, camera, {}, machine).primitives._asdict())
