"""A body seen through another one on a software OpenGL: a fault is found at its stage."""

import pytest
from edited import Fault, blamed, drawn, judged, rendered
from opengl import needs_mesa

from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_mesa

WAY = "max_(behind, 0.0) * mm_per_unit"
MATERIAL = {"albedo_constant(inner_mesh_color)": "albedo_constant(vec3(0.30, 0.34, 0.38))"}
FAULTS = {
    "light is not weakened on its way in": Fault(
        "tooth", "inner_camera/light_inside", {"max_(stored_distance - entered, 0.0)": "0.0"}, "inner_camera"
    ),
    "way in cm": Fault("tooth", "camera/seen_through", {WAY: f"{WAY} * 0.1"}, "camera"),
    "the inner body hides the outer one": Fault("tooth", "camera/seen_through", {"lit + passed(": "passed("}, "camera"),
    "the material of the outer body": Fault("tooth", "inner_camera/albedo_constant", MATERIAL, "inner_camera"),
}


def test_our_own_drawing_passes():
    found = validate(rendered("tooth"), drawn("tooth"))
    assert found.passed and {"inner_lit", "way_to_inner", "seen"} <= {verdict.buffer for verdict in found.verdicts}


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
def test_a_fault_is_found_at_its_stage(fault, tmp_path):
    found = judged(fault, tmp_path)
    assert not found.passed and blamed(found.culprit) == [fault.at]
