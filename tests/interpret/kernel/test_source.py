import os
import subprocess
import sys

import pytest
from scenes import settings_with

from sss_ref.interpret.kernel.source import fragment_source, vertex_source
from sss_ref.language.pipeline import MeshDraw
from sss_ref.scene.catalogue import method_of

PRINT_SOURCES = """
import hashlib
from test_source import sources
print(hashlib.sha256("".join(sources("robust")).encode()).hexdigest())
"""


def passes(preset="robust"):
    return {one.name: one for one in method_of(settings_with({"preset": preset})).passes}


def sources(preset):
    """The modules of all passes of a preset, everything kept."""
    written, there = [], set()
    for one in passes(preset).values():
        varyings = {}
        if isinstance(one.draw, MeshDraw):
            varyings = {name: 3 * k for k, name in enumerate(one.draw.varyings)}
            written.append(vertex_source(one, varyings))
        by_stages = [name for name in one.outputs if name not in ("depth", "light_depth")]  # the rasterizer's
        written.append(fragment_source(one, there, by_stages, varyings))
        there |= set(one.outputs)
    assert len(written) > 5
    return written


def camera_source(*wanted):
    """The module of the camera pass with only some of its buffers kept."""
    one = passes()["camera"].only(set(wanted))
    varyings = {"fragment_position": 0, "fragment_normal": 3, "fragment_uv": 6}
    return fragment_source(one, {"light_distance", "light_triangle"}, wanted, varyings)


def test_the_source_does_not_depend_on_the_order_of_sets():
    """A source that changed between processes would be compiled again in each of them."""
    paths = os.pathsep.join([*sys.path, os.path.dirname(__file__)])
    printed = [
        subprocess.run(
            [sys.executable, "-c", PRINT_SOURCES],
            env=os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": paths},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2", "3")
    ]
    assert len(printed[0]) == 65 and len(set(printed)) == 1


@pytest.mark.parametrize("preset", ["paper", "robust"])
def test_every_source_is_python(preset):
    assert len(sources(preset)) == len(passes(preset)) + 2  # two draws of the mesh
    for source in sources(preset):
        compile(source, "<source>", "exec")


def test_a_buffer_that_is_not_kept_is_not_written():
    assert "out_thickness[row, column] = " in camera_source("thickness")
    assert "out_entry_point" not in camera_source("thickness")
    assert "out_entry_point[row, column, 2] = " in camera_source("entry_point", "thickness")


def test_a_stage_that_nothing_kept_depends_on_is_not_computed():
    thickness = camera_source("thickness")
    assert "# back_point" in thickness and "# surface" in thickness
    assert "phong" not in thickness and "pow_scalar(" not in thickness
    assert "# phong_shading" in camera_source("lit") and "pow_scalar(" in camera_source("lit")


def test_float_literals_are_float32_constants():
    """A bare literal would make numba compute in float64."""
    source = camera_source("shadow_uv")
    assert "F_0_5 = np.float32(0.5)" in source
    assert "F_0_5" in source.split("def fragments")[1] and " 0.5" not in source.split("def fragments")[1]


@pytest.mark.parametrize(
    ("wanted", "stages"),
    [
        (set(), []),
        ({"coverage", "depth"}, []),
        ({"uv"}, ["surface"]),
        ({"stored_distance"}, ["surface", "shadow_lookup_nearest"]),
        ({"thickness", "uv"}, ["surface", "shadow_lookup_nearest", "back_point"]),
        ({"phong"}, ["surface", "albedo_constant", "light_constant", "phong_shading"]),
        (
            {"translucency"},
            ["surface", "shadow_lookup_nearest", "back_point", "directly_lit_slope", "translucency_ratio"],
        ),
    ],
)
def test_only_what_the_wanted_buffers_depend_on_is_left(wanted, stages):
    one = passes()["camera"].only(wanted)
    assert [stage.name for stage in one.stages] == stages
    assert one.draw is passes()["camera"].draw


def test_all_stages_are_left_for_the_last_buffer():
    one = passes()["camera"]
    assert one.only({"lit"}).stages == one.stages
