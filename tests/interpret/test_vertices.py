import numpy as np
import pytest

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips as kernel
from sss_ref.language.pipeline import MeshDraw, Pass
from sss_ref.passes.vertex import mesh_vertex

DRAW = MeshDraw(mesh_vertex.bound(clip_from_model="camera_clip_from_model"), "triangle", "depth")
ALL = ({"fragment_position": 0, "fragment_normal": 3, "fragment_uv": 6}, 8)
SOME = ({"fragment_uv": 0, "fragment_position": 2}, 5)


def random_vertices(count):
    rng = np.random.default_rng(20130)
    scale = 10.0 ** rng.integers(-20, 18, (count, 1))
    mesh = {name: (rng.normal(size=(count, width)) * scale).astype(np.float32) for name, width in WIDTHS.items()}
    mesh["position"][:4] = [(0, 0, 0), (-0.0, 0, -0.0), (1e-45, -1e-45, 3e38), (1, 1, 1)]
    matrices = {name: rng.normal(size=(size, size)).astype(np.float32) for name, size in MATRICES.items()}
    return mesh, matrices


WIDTHS = {"position": 3, "normal": 3, "uv": 2}
MATRICES = {"world_from_model": 4, "normal_from_model": 3, "camera_clip_from_model": 4}


@pytest.mark.parametrize(("varyings", "columns"), [ALL, SOME, ({}, 0)])
def test_both_interpreters_give_the_same_vertices(varyings, columns):
    mesh, matrices = random_vertices(20_000)
    one = Pass("camera", "camera", DRAW, ())
    compiled = kernel.run_vertices(one, mesh, matrices, varyings, columns)
    plain = arrays.run_vertices(one, mesh, matrices, varyings, columns)
    for left, right, width in zip(compiled, plain, (4, columns), strict=True):
        assert left.shape == right.shape == (20_000, width)
        assert left.dtype == right.dtype == np.float32
        assert left.tobytes() == right.tobytes()


@pytest.mark.parametrize("interpreter", [arrays, kernel])
def test_a_vertex_worked_by_hand(interpreter):
    """World: moved by (0, 0, 1). Clip: twice that, w = -z. Normal: its x doubled. UV: as it is."""
    mesh = {"position": [[1, 2, 3]], "normal": [[1, 0, 2]], "uv": [[0.25, 0.75]]}
    matrices = {
        "world_from_model": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]],
        "normal_from_model": [[2, 0, 0], [0, 1, 0], [0, 0, 1]],
        "camera_clip_from_model": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 2], [0, 0, -1, -1]],
    }
    mesh, matrices = ({name: np.array(v, np.float32) for name, v in table.items()} for table in (mesh, matrices))
    clip_position, attributes = interpreter.run_vertices(Pass("camera", "camera", DRAW, ()), mesh, matrices, *ALL)
    assert clip_position.tolist() == [[2, 4, 8, -4]]
    assert attributes.tolist() == [[1, 2, 4, 2, 0, 2, 0.25, 0.75]]
