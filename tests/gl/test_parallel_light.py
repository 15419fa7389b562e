"""Parallel light and an orthographic camera on a software OpenGL: a fault is found at its stage."""

import pytest
from edited import Fault, blamed, judged
from opengl import needs_mesa

pytestmark = needs_mesa

LIGHT_2 = "dot_(fragment_position - light_position, light_direction)"
FAULTS = {
    "eye on the other side": Fault(
        "parallel", "camera/phong_shading_orthographic", {"to_eye = -camera_direction": "to_eye = camera_direction"}
    ),
    "distance against the rays": Fault(
        "parallel", "shadow_map_2/distance_to_light_directional", {LIGHT_2: f"-{LIGHT_2}"}
    ),
    "entry point as from a point": Fault(
        "parallel",
        "camera/back_point_parallel",
        {"position_world - light_direction * inside": "light_position + light_direction * inside"},
    ),
}


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
def test_a_fault_is_found_at_its_stage(fault, tmp_path):
    found = judged(fault, tmp_path)
    assert not found.passed and blamed(found.culprit) == [fault.at]
