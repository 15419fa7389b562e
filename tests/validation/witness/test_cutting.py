"""What a witness takes to write down: it goes into bug reports, so a stage that reads much must stay small too."""

import numpy as np
import pytest

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.rebased import Check, last_round
from sss_ref.validation.accept.walk import run_stage
from sss_ref.validation.profile_file import profile_of
from sss_ref.validation.witness.cutting import cut_down
from sss_ref.validation.witness.recording import recorded

SIZES = {f"{table}.{side}": 48 for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")}
PIXELS = 5  # that are tried of a buffer
USUAL, LARGEST = 2100, 2800  # bytes of JSON
READING_MUCH = {  # stage -> scene, method, pass and buffer of it, and its limit: 12 to 64 samples of several buffers
    "scatter_burley": ("figure3_with", "burley", "blur", "scattered", LARGEST),
    "scatter_along": ("figure3_with", "separable", "blur_rows", "scattered_rows", USUAL),
    "scatter_inside_surface": ("wax", "screen_space", "blur", "scattered", LARGEST),
    "light_visible_kernel": ("figure3_with", "screen_space", "camera", "light_visible", USUAL),
    "irradiance_of_gaussians": ("figure3_with", "gaussian_texture", "camera", "irradiance_used", LARGEST),
}
QUICK = "scatter_burley"  # the one that reads most


@pytest.mark.parametrize("stage", [pytest.param(s, marks=() if s == QUICK else pytest.mark.full) for s in READING_MUCH])
def test_the_witness_of_a_stage_that_reads_much_is_small(stage):
    scene, method, pass_name, buffer, limit = READING_MUCH[stage]
    result = render(load_scene(scene, method=method, preset="robust", **SIZES), "arrays")
    case = Case(result, Drawing(dict(result.buffers)), profile_of("vulkan"))
    drawn = last_round(case, result.scene.method[pass_name])
    rows, columns = np.nonzero(result[buffer].reshape(*result[buffer].shape[:2], -1).any(axis=-1))
    chosen = np.linspace(0, len(rows) - 1, PIXELS).astype(int)
    right, everywhere = result[buffer], np.ones(result[buffer].shape[:2], bool)
    check = Check(pass_name, stage, buffer, everywhere, right, right, np.zeros(right.shape))
    runs = [run_stage(drawn, (rows[k : k + 1], columns[k : k + 1]), buffer) for k in chosen]
    found = [cut_down(check, (int(columns[k]), int(rows[k])), run, drawn) for k, run in zip(chosen, runs, strict=True)]
    sizes = [len(recorded(each).model_dump_json(exclude_defaults=True)) for each in found]
    assert limit // 2 < max(sizes) < limit
