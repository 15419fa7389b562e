"""Scenes of a named material, drawn."""

import sss_ref
from sss_ref.scene_file.substances import layer_of

SCENE = {
    "preset": "robust",
    "mesh": {"path": "sphere"},
    "camera": {"type": "orbit", "distance": 6.0, "width": 32, "height": 32},
    "lights": [{"position": [3.0, 2.0, -4.0]}],
    "shadow_map": {"width": 32, "height": 32},
}


def drawn(**chosen):
    return sss_ref.render(sss_ref.load_scene(SCENE, **chosen))


def test_a_material_is_the_same_as_its_keys():
    named = drawn(material="jade", mm_per_unit=20.0)
    assert named.hashes == drawn(mm_per_unit=20.0, **layer_of("jade", in_mm=True)).hashes
    assert named.hashes != drawn(mm_per_unit=20.0).hashes


def test_a_larger_body_lets_less_light_through():
    small, large = (drawn(material="wax", mm_per_unit=unit) for unit in (5.0, 50.0))
    inside = small["thickness"] > 0
    assert inside.any() and (small["translucency"][inside] > large["translucency"][inside])[:, 0].any()
    assert (small["translucency"] >= large["translucency"]).all()
