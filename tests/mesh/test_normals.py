import numpy as np

from sss_ref.mesh.normals import vertex_normals


def naive_normals(positions, triangles):
    """Rule R6, triangle by triangle with Python floats."""
    sums = {}
    for triangle in triangles:
        a, b, c = ([float(x) for x in positions[i]] for i in triangle)
        u, v = [y - x for x, y in zip(a, b, strict=True)], [y - x for x, y in zip(a, c, strict=False)]
        area = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        for i in triangle:
            key = tuple(float(x) + 0.0 for x in positions[i])
            sums[key] = tuple(s + x for s, x in zip(sums.get(key, (0.0, 0.0, 0.0)), area, strict=True))
    result = []
    for position in positions:
        x, y, z = sums.get(tuple(float(p) + 0.0 for p in position), (0.0, 0.0, 0.0))
        length = np.sqrt((x * x + y * y) + z * z)
        result.append([x / length, y / length, z / length] if length else [0.0, 0.0, 0.0])
    return np.array(result, np.float32)


def test_equals_the_naive_loop_in_every_bit():
    generator = np.random.default_rng(1)
    positions = generator.standard_normal((200, 3)).astype(np.float32)
    positions[150:] = positions[:50]  # a seam
    triangles = generator.integers(0, 200, (600, 3)).astype(np.int32)
    ours = vertex_normals(positions, triangles)
    assert ours.dtype == np.float32
    assert ours.tobytes() == naive_normals(positions, triangles).tobytes()


def test_weights_are_areas_not_angles_or_counts():
    # Two right triangles at the origin: in z = 0 with area 1/2, in x = 0 with area 2: normal (4, 0, 1) / sqrt 17.
    positions = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 2, 0], [0, 0, 2]], np.float32)
    normals = vertex_normals(positions, np.array([[0, 1, 2], [0, 3, 4]], np.int32))
    assert np.array_equal(normals[0], np.array([4 / np.sqrt(17), 0, 1 / np.sqrt(17)], np.float32))


def test_no_area_leaves_zero():
    positions = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0]], np.float32)
    assert not vertex_normals(positions, np.array([[0, 1, 2]], np.int32)).any()


def test_both_sides_of_a_seam_get_the_same_normal():
    positions = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-0.0, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
    normals = vertex_normals(positions, np.array([[0, 1, 2], [3, 4, 5]], np.int32))
    half = np.float32(np.sqrt(0.5))
    assert np.array_equal(normals[0], normals[3]) and np.array_equal(normals[0], np.array([half, 0, half]))
