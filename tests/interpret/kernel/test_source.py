import os
import subprocess
import sys

import pytest
from kernel_sources import passes, sources

from sss_ref.interpret.kernel.source import fragment_source

PRINT_SOURCES = """
import hashlib
from kernel_sources import sources
print(hashlib.sha256("".join(sources("robust")).encode()).hexdigest())
"""


def camera_source(*wanted):
    """The module of the camera pass with only some of its buffers kept."""
    one = passes()["camera"].only(set(wanted))
    varyings = {"fragment_position": 0, "fragment_normal": 3, "fragment_uv": 6}
    return fragment_source(one, {"light_distance", "light_triangle"}, wanted, varyings)


def test_the_source_does_not_depend_on_the_order_of_sets():
    """A source that changed between processes would be compiled again in each of them."""
    paths = os.pathsep.join(sys.path)
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
