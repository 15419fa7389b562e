"""What the entries of a glTF document may hold: as many numbers as the specification has, and no other types."""

import pytest
from pydantic import TypeAdapter, ValidationError

from sss_ref.mesh.gltf import gltf_document

LENGTHS = {"Vec2": 2, "Vec3": 3, "Vec4": 4, "Mat4": 16}
COMPONENTS = [5120, 5121, 5122, 5123, 5125, 5126]  # glTF 2.0, 3.6.2.2: 5124 is none


def taken(kind, value):
    try:
        return TypeAdapter(getattr(gltf_document, kind)).validate_python(value, strict=True)
    except ValidationError:
        return None


@pytest.mark.parametrize("kind", LENGTHS)
def test_numbers_of_a_vector(kind):
    right = [0.5] * LENGTHS[kind]
    assert taken(kind, right) == right
    for wrong in (right[1:], [*right, 0.5], [*right[1:], "0.5"], [*right[1:], float("inf")]):
        assert taken(kind, wrong) is None


def test_component_types():
    assert [number for number in range(5100, 5140) if taken("ComponentType", number)] == COMPONENTS
    assert taken("ComponentType", 5126.0) == 5126  # JSON has one kind of number


def test_whole_numbers():
    assert [taken("Whole", value) for value in (0, 3.0, -1, 2.5, "1")] == [0, 3, None, None, None]


def test_an_entry_keeps_what_it_does_not_know_out():
    assert gltf_document.GltfPrimitive(attributes={}).mode == 4  # triangles
    view = gltf_document.GltfView.model_validate({"buffer": 1, "byteLength": 8, "name": "x"})
    assert (view.byteOffset, view.byteStride, view.extensions) == (0, None, {})
    with pytest.raises(ValidationError):
        gltf_document.GltfView.model_validate({"buffer": True, "byteLength": 8})
