"""The shipped lessons about UV maps show what they are there for."""

import numpy as np

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

SMALL = {f"{table}.{side}": 256 for table in ("camera", "shadow_map") for side in ("width", "height")}


def red(name):
    """The red of a lesson's irradiance map, its charts widened, before and after the blur."""
    names = ["irradiance_filled", "scattered_irradiance"]
    result = render(load_scene(name, **SMALL), interpreter="arrays", keep=names)
    return [result[name][..., 0] for name in names]


def test_the_blur_takes_the_stripes_away_only_where_the_uv_map_is_crowded():
    stripes, blurred = red("lesson_stretch")
    crowded, roomy = (200, slice(8, 48)), (200, slice(-128, None))  # 12 to 30 % and 87 to 100 % of the way
    assert np.ptp(blurred[crowded]) < 0.5 * np.ptp(stripes[crowded])
    assert np.ptp(blurred[roomy]) > 0.99 * np.ptp(stripes[roomy])


def test_every_face_of_the_cube_loses_light_toward_its_seams():
    light, blurred = red("lesson_seam")
    left = blurred[light > 0] / light[light > 0]
    assert left.min() < 0.6 and left.max() > 0.95
