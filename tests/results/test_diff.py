import math
import struct

import numpy as np
import pytest

from sss_ref.errors import DumpError
from sss_ref.rendering.fold import render
from sss_ref.results.diff import ULP_CLASSES, bits, buffer_files, compared, diff, first_difference, ulp_class
from sss_ref.results.folder import save
from sss_ref.scene.load import load_scene


def naive_class(a, b):
    """The index in ULP_CLASSES of two float32, from their bytes."""
    patterns = [struct.unpack("<I", struct.pack("<f", x))[0] for x in (a, b)]
    if patterns[0] == patterns[1]:
        return 0
    if math.isnan(a) or math.isnan(b) or math.copysign(1, a) != math.copysign(1, b):
        return 6
    distance = abs(patterns[0] - patterns[1])
    return 1 if distance == 1 else 2 if distance < 4 else 3 if distance < 16 else 4 if distance < 256 else 5


def test_classes_of_floats_agree_with_a_naive_loop():
    generator = np.random.default_rng(3)
    a = generator.integers(0, 2**32, 4000, np.uint32)
    steps = np.array([0, 1, 2, 3, 4, 15, 16, 255, 256, 2**31], np.uint32)
    b = a + generator.choice(steps, a.size) * generator.choice(np.array([1, 2**32 - 1], np.uint32), a.size)
    b[:50] = generator.integers(0, 2**32, 50, np.uint32)
    a, b = a.view(np.float32), b.view(np.float32)
    keep = np.isfinite(a) & np.isfinite(b)  # the bytes of NaN may change on their way through a Python float
    found = ulp_class(a[keep], b[keep]).tolist()
    assert found == [naive_class(*both) for both in zip(a[keep].tolist(), b[keep].tolist(), strict=True)]
    assert set(found) == set(range(len(ULP_CLASSES)))


def test_classes_of_what_has_no_distance():
    nan, inf = math.nan, math.inf
    a, b = np.array([0, nan, nan, inf, inf, 1], np.float32), np.array([-0.0, nan, 1, inf, -inf, inf], np.float32)
    assert ulp_class(a, b).tolist() == [6, 0, 6, 0, 6, 5]


def test_classes_of_integers():
    a, b = np.array([-1, 5, 5, -1, 7], np.int32), np.array([3, 5, 6, -3, 300], np.int32)
    assert ulp_class(a, b).tolist() == [6, 0, 1, 2, 5]
    assert ulp_class(np.array([0, 1], np.uint8), np.array([1, 1], np.uint8)).tolist() == [1, 0]


def test_a_buffer_by_hand():
    a = np.zeros((2, 3, 3), np.float32)
    b = a.copy()
    b[0, 2, 1], b[1, 0], b[1, 2, 0] = np.float32(2**-149), (-0.0, 2, math.inf), math.nan
    found = compared("lit", a, b)
    assert (found.pixels, found.differing, found.largest) == (6, 3, 2)
    assert found.ulps == (13, 1, 0, 0, 0, 2, 2)
    assert found.first.startswith("first at pixel 2,0 (column,row; row 0 at the bottom): A 0.0 (0x00000000) 0.0")
    assert "B 0.0 (0x00000000) 1e-45 (0x00000001) 0.0 (0x00000000); 3 of 6 pixels differ" in found.first


def test_the_largest_difference_does_not_wrap():
    low, high = np.array([[-(2**31), 0]], np.int32), np.array([[2**31 - 1, 0]], np.int32)
    assert compared("triangle", low, high).largest == 2**32 - 1
    assert compared("coverage", np.zeros((1, 1), np.uint8), np.ones((1, 1), np.uint8)).largest == 1
    assert compared("depth", np.float32([[math.nan]]), np.float32([[1]])).largest == 0


def test_first_difference_by_hand():
    recorded = np.array([[0, 1], [2, 3]], np.int32)
    computed = np.array([[0, 1], [-1, 4]], np.int32)
    assert first_difference(recorded, computed) == (
        "first at pixel 0,1 (column,row; row 0 at the bottom): recorded 2 (0x00000002), now -1 (0xffffffff); "
        "2 of 4 pixels differ"
    )


def test_zeros_of_either_sign_differ():
    zeros = np.array([[0.0, -0.0]], np.float32)
    assert bits(zeros).tolist() == [[0, 0x80000000]]
    assert "recorded 0.0 (0x00000000), now -0.0 (0x80000000); 1 of 2" in first_difference(np.abs(zeros), zeros)
    assert "recorded 1 (0x01), now 0 (0x00)" in first_difference(np.ones((1, 1), "u1"), np.zeros((1, 1), "u1"))


@pytest.fixture
def lighter(scene_file, saved):
    """The session's scene with more ambient light: everything up to phong is the same."""
    scene = load_scene(scene_file, **{"phong.ambient": 0.25})
    return save(render(scene), scene_file.parent / "lighter")


@pytest.mark.parametrize("inner", ["", "buffers"])
def test_two_results(result, saved, lighter, inner):
    found = diff(saved / inner, lighter)
    assert [one.name for one in found.buffers] == list(result.buffers)
    assert found.first.name == "phong" and (found.only_in_a, found.only_in_b) == ((), ())
    changed = {one.name for one in found.buffers if one.differing}
    assert changed == {"phong", "lit", "scattered", "image"}
    coverage = np.count_nonzero(result["coverage"])
    assert found.first.differing == coverage > 0


def test_a_result_equals_itself(saved):
    found = diff(saved, saved)
    assert found.first is None and all(one.ulps[0] == sum(one.ulps) > 0 for one in found.buffers)


def test_order_without_manifest_and_lonely_buffers(tmp_path):
    for folder, names in (("a", ("lit", "depth", "uv_2", "uv_1")), ("b", ("image", "uv_1", "lit", "albedo"))):
        (tmp_path / folder).mkdir()
        for name in names:
            np.save(tmp_path / folder / f"{name}.npy", np.zeros((1, 2), np.float32))
    found = diff(tmp_path / "a", tmp_path / "b")
    assert [one.name for one in found.buffers] == ["uv_1", "lit"]
    assert (found.only_in_a, found.only_in_b) == (("depth", "uv_2"), ("albedo", "image"))


@pytest.mark.parametrize(
    "name, array, told",
    [
        (
            "depth",
            np.zeros((2, 4), "f4"),
            r"b/depth\.npy: expected float32 2 x 3 as in .*a/depth\.npy, got float32 2 x 4",
        ),
        ("depth", np.zeros((2, 3), "i4"), r"expected float32 2 x 3 as in .*, got int32 2 x 3; render both in one size"),
        ("depth", np.zeros((2, 3), "f8"), r"depth\.npy: expected float32, int32 or .*, got float64 2 x 3; convert it"),
        ("depth", np.zeros((2, 3, 4), "f4"), r"or 3 channels, got float32 2 x 3 x 4"),
        ("depth", np.zeros((0, 3), "f4"), r"got float32 0 x 3"),
        ("sunlight", np.zeros((2, 3), "f4"), r"b/sunlight\.npy: expected the name of a buffer \(.*\), got sunlight"),
        ("lit", np.zeros((2, 3), "f4"), r"b: expected a buffer that .*a has \(depth\), got lit"),
    ],
)
def test_what_cannot_be_compared(tmp_path, name, array, told):
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
    np.save(tmp_path / "a" / "depth.npy", np.zeros((2, 3), np.float32))
    np.save(tmp_path / "b" / f"{name}.npy", array)
    with pytest.raises(DumpError, match=told):
        diff(tmp_path / "a", tmp_path / "b")


def test_no_folder(tmp_path):
    with pytest.raises(DumpError, match="expected a result folder or a folder of buffers, got one without NPY files"):
        buffer_files(tmp_path / "nowhere")
