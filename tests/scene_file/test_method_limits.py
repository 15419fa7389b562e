"""Which presets, layers, shadow tests and profiles go with which method; scenes are read, and nothing is drawn."""

import pytest
from filled_scenes import keys_of

from sss_ref.errors import SceneError

METHODS = ["screen_space", "texture_space", "separable", "burley", "preintegrated", "gaussian_texture"]
LAYER = [{"path": "model.obj", "extinction_per_mm": [0.1, 0.2, 0.3]}]
RISING = [[float(k), 1.0, 1.0, 1.0] for k in (1, 2, 2, 3, 4, 5)]
NOT_WITH = {  # what is given -> the methods that it does not go with, and how the refusal begins
    "published": (
        {"preset": "published", "lights": [{"position": [0, 0, 4], "type": "point"}]},
        ["separable", "burley", "preintegrated", "gaussian_texture"],
        'preset: expected "paper" or "robust" with method = ',
    ),
    "a layer": (
        {"layers": LAYER, "mm_per_unit": 10},
        ["texture_space", "gaussian_texture"],
        "layers: expected no layers",
    ),
    "another test": ({"shadow_map": {"test": "kernel"}}, ["preintegrated"], 'shadow_map.test: expected "slope" with'),
    "seven rows": (
        {"diffusion": {"profile": [*RISING, [9.0, 1.0, 1.0, 1.0]]}},
        ["gaussian_texture"],
        "diffusion.profile: expected six rows, v rising, with",
    ),
    "rows that fall": (
        {"diffusion": {"profile": RISING[::-1]}},
        ["gaussian_texture"],
        "diffusion.profile: expected six rows, v rising, with",
    ),
    "six rows": ({"diffusion": {"profile": RISING}}, [], ""),
    "the usual test": ({"shadow_map": {"test": "slope"}}, [], ""),
}


@pytest.mark.parametrize("given", NOT_WITH)
@pytest.mark.parametrize("method", METHODS)
def test_what_goes_with_a_method(tmp_path, method, given):
    (tmp_path / "model.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    changes, refused, begins = NOT_WITH[given]
    changes = {"mm_per_unit": 10, **changes, "method": method}
    if method not in refused:
        assert keys_of(changes, tmp_path)["method"] == repr(method)
        return
    with pytest.raises(SceneError) as caught:
        keys_of(changes, tmp_path)
    assert begins in str(caught.value).splitlines()[0]
