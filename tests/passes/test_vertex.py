"""The vertex stages: worked by hand, and the three ways of running it."""

import naive_stages
import numpy as np
import pytest
from one_stage import assert_same_bits, call

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips as kernel
from sss_ref.language.pipeline import MeshDraw, Pass
from sss_ref.passes.vertex import layout_vertex, mesh_vertex, tangent_layout_vertex, tangent_vertex

VARYINGS = {"fragment_position": 0, "fragment_normal": 3, "fragment_uv": 6}


def test_mesh_vertex():
    clip_position, position, normal, uv = call(
        mesh_vertex,
        position=(1, 2, 3),
        normal=(0, 0, 1),
        uv=(0.25, 0.75),
        # Twice as large, then moved by (10, 20, 30): (12, 24, 36).
        world_from_model=[[2, 0, 0, 10], [0, 2, 0, 20], [0, 0, 2, 30], [0, 0, 0, 1]],
        # Its third column.
        normal_from_model=[[1, 2, 3], [4, 5, 6], [7, 8, 9]],
        # Rows times (1, 2, 3, 1): 1 + 2 + 3 + 1 = 7, 2*2 = 4, -3 + .5 = -2.5, -3.
        clip_from_model=[[1, 1, 1, 1], [0, 2, 0, 0], [0, 0, -1, 0.5], [0, 0, -1, 0]],
    )
    assert clip_position == (7, 4, -2.5, -3)
    assert position == (12, 24, 36)
    assert normal == (3, 6, 9)
    assert uv == (0.25, 0.75)


@pytest.mark.parametrize(
    ("uv", "flat"),
    [((0, 0), (-1, -1)), ((1, 1), (1, 1)), ((0.5, 0.75), (0, 0.5)), ((2**-24, 1.25), (-1 + 2**-23, 1.5))],
)
def test_layout_vertex(uv, flat):
    # The same matrices as above, but the position is where the UV lies, in front of no camera.
    assert call(
        layout_vertex,
        position=(1, 2, 3),
        normal=(0, 0, 1),
        uv=uv,
        world_from_model=[[2, 0, 0, 10], [0, 2, 0, 20], [0, 0, 2, 30], [0, 0, 0, 1]],
        normal_from_model=[[1, 2, 3], [4, 5, 6], [7, 8, 9]],
    ) == ((*flat, 0, 1), (12, 24, 36), (3, 6, 9), uv)


@pytest.mark.parametrize("handedness", [1, -1, 0.5])
def test_tangent_vertex(handedness):
    # As above; the tangent is not moved, and its fourth component is a product: turned over in a mirror.
    *seen, tangent = call(
        tangent_vertex,
        position=(1, 2, 3),
        normal=(0, 0, 1),
        uv=(0.25, 0.75),
        tangent=(0, 1, 3, -1),
        world_from_model=[[2, 0, 0, 10], [0, 2, 0, 20], [0, 0, 2, 30], [0, 0, 0, 1]],
        normal_from_model=[[1, 2, 3], [4, 5, 6], [7, 8, 9]],
        handedness=handedness,
        clip_from_model=[[1, 1, 1, 1], [0, 2, 0, 0], [0, 0, -1, 0.5], [0, 0, -1, 0]],
    )
    assert seen == [(7, 4, -2.5, -3), (12, 24, 36), (3, 6, 9), (0.25, 0.75)]
    assert tangent == (0, 2, 6, -handedness)


def test_tangent_layout_vertex():
    assert call(
        tangent_layout_vertex,
        position=(1, 2, 3),
        normal=(0, 0, 1),
        uv=(0.5, 0.75),
        tangent=(0, 1, 3, -1),
        world_from_model=[[2, 0, 0, 10], [0, 2, 0, 20], [0, 0, 2, 30], [0, 0, 0, 1]],
        normal_from_model=[[1, 2, 3], [4, 5, 6], [7, 8, 9]],
        handedness=-0.5,
    ) == ((0, 0.5, 0, 1), (12, 24, 36), (3, 6, 9), (0.5, 0.75), (0, 2, 6, 0.5))


def random_mesh(seed):
    rng = np.random.default_rng(seed)
    counts = {"position": 3, "normal": 3, "uv": 2, "tangent": 4}
    mesh = {name: rng.normal(size=(100, count)).astype(np.float32) for name, count in counts.items()}
    for vertices in mesh.values():
        vertices[:20] = rng.choice(np.float32([0, -0.0, 1, 1e-30]), vertices[:20].shape)
    sizes = {"world_from_model": 4, "normal_from_model": 3, "clip_from_model": 4}
    matrices = {name: rng.normal(size=(size, size)).astype(np.float32) for name, size in sizes.items()}
    return mesh, {**matrices, "handedness": np.float32(-1)}


@pytest.mark.parametrize("stage", [mesh_vertex, layout_vertex, tangent_vertex, tangent_layout_vertex])
@pytest.mark.parametrize("interpreter", [arrays, kernel])
def test_both_interpreters_give_the_bits_of_the_naive_form(interpreter, stage):
    mesh, matrices = random_mesh(seed=3)
    matrices = {name: matrix for name, matrix in matrices.items() if name in stage.parameters}
    one = Pass("vertices", "", MeshDraw(stage, "triangle", "depth"), ())
    more = {"fragment_tangent": 8} if "tangent" in stage.parameters else {}
    clip_position, attributes = interpreter.run_vertices(one, mesh, matrices, VARYINGS | more, 12 if more else 8)
    clip_expected, attributes_expected = [], []
    for vertex in zip(*(mesh[name] for name in stage.parameters if name in mesh), strict=True):
        clip, *varyings = getattr(naive_stages, stage.name)(*vertex, **matrices)
        clip_expected.append(clip)
        attributes_expected.append(np.concatenate(varyings))
    assert_same_bits({"clip": clip_position}, {"clip": np.array(clip_expected)})
    assert_same_bits({"varyings": attributes}, {"varyings": np.array(attributes_expected)})
