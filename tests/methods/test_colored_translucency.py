"""T of three channels: in each it is what one number gives for all, in every bit, and on OpenGL too."""

import numpy as np
import pytest
from alternatives import alternatives
from opengl import needs_mesa

import sss_ref
from sss_ref.scene_file import scattering, settings

SMALL = {f"{table}.{side}": 48 for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")}
THREE = {"x": (2.0, 0.7, 1.5), "y": (0.5, -1.0, 0.25), "exponent": (0.6, 1.0, 0.3), "d_min": (0.1, 0.2, 0.4)}
SCALES = (0.2, 0.5, 1.0)
IN_ONE_MAP = {"preset": "robust", "blur.kernel": [[0.0, 0.0, 1.0, 1.0, 1.0]]}  # nothing mixes with the neighbours


def keys(channel=None):
    """The numbers of all channels, or of one for all."""
    named = {**THREE, "scale": SCALES}
    return {f"translucency.{key}": list(three) if channel is None else three[channel] for key, three in named.items()}


def scene(method, channel=None, **chosen):
    return sss_ref.load_scene("figure3_with", method=method, **SMALL, **keys(channel), **chosen)


@pytest.mark.parametrize("form", ["ratio", "exponent", "beer"])
def test_each_channel_has_the_bits_of_its_number(form):
    both = [sss_ref.render(scene("screen_space", **{"translucency.form": form}), i) for i in ("kernel", "arrays")]
    together = both[0]
    assert both[0].hashes == both[1].hashes
    assert together["translucency"].shape == (48, 48, 3)
    for channel in range(3):
        alone = sss_ref.render(
            scene("screen_space", channel, **{"translucency.form": form}), keep=["translucency", "lit"]
        )
        assert np.array_equal(together["translucency"][..., channel], alone["translucency"])
        assert np.array_equal(together["lit"][..., channel], alone["lit"][..., channel])


@pytest.mark.parametrize("combine", alternatives(scattering.TranslucencySettings, "combine"))
def test_it_joins_each_channel_as_its_number_does(combine):
    together = sss_ref.render(scene("screen_space", **{"translucency.combine": combine}), keep=["lit"])["lit"]
    for channel in range(3):
        alone = scene("screen_space", channel, **{"translucency.combine": combine})
        assert np.array_equal(together[..., channel], sss_ref.render(alone, keep=["lit"])["lit"][..., channel])


@pytest.mark.parametrize("image", alternatives(settings.IrradianceMap, "image"))
def test_in_texture_space(image):
    chosen = {**IN_ONE_MAP, "irradiance_map.image": image}
    together = sss_ref.render(scene("texture_space", **chosen), keep=["image"]).image
    for channel in range(3):
        alone = sss_ref.render(scene("texture_space", channel, **chosen), keep=["image"]).image
        assert np.array_equal(together[..., channel], alone[..., channel])


@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
def test_as_the_printed_figures_have_it(method):
    def printed(x):
        chosen = {"preset": "published", "translucency.scale": 1.0, "translucency.x": x}
        return sss_ref.render(sss_ref.load_scene("figure4_wax", method=method, **SMALL, **chosen), keep="final").image

    together = printed([0.3, 0.5, 0.7])
    for channel, x in enumerate((0.3, 0.5, 0.7)):
        assert np.array_equal(together[..., channel], printed(x)[..., channel])


def test_gaussians_are_in_mm():
    """Twice the mm per unit, with four times the variances: the same thickness, and the same T."""
    rows = [[0.5, 0.75, 0.5, 0.25], [8.0, 0.25, 0.5, 0.75]]
    wide = [[4 * variance, *weights] for variance, *weights in rows]

    def T(unit, gaussians):
        chosen = {"translucency.form": "gaussians", "translucency.gaussians": gaussians, "mm_per_unit": unit}
        return sss_ref.render(sss_ref.load_scene("sphere", **SMALL, **chosen), keep=["translucency"])["translucency"]

    assert T(4.0, rows).any() and np.array_equal(T(4.0, rows), T(8.0, wide))


@needs_mesa
@pytest.mark.parametrize("form", ["ratio", "gaussians"])
@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
def test_opengl_passes_and_a_wrong_channel_is_named(method, form):
    from sss_ref.gl import draw

    right = scene(method, **{"translucency.form": form})
    drawn = draw(right)
    assert sss_ref.validate(right, drawn, explain=False).passed
    wrong = {**drawn, "translucency": drawn["translucency"] * np.float32([1, 1, 1.25])}
    report = sss_ref.validate(right, wrong)
    assert f"stage translucency_{form}" in report.summary
