"""The lessons' figures of diffusion show the numbers of the walks, and of kernels."""

from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib import pyplot

from sss_ref.course import diffusion_figures, figures
from sss_ref.truth.photon import Volume
from sss_ref.truth.searchlight import searchlight


@pytest.fixture(autouse=True)
def no_window():
    pyplot.switch_backend("agg")
    yield
    pyplot.close("all")


@pytest.fixture(scope="module")
def walked():
    return searchlight(Volume(0.8, 0.2), 2000)


@pytest.fixture
def axes():
    return figures.row(1)[1][0]


def test_ways_that_end_above_the_skin_are_counted(axes):
    inside, outside = np.array([[0.0, 0, 0], [0, 0, 1]]), np.array([[0.0, 0, 0], [0, 0, 1], [1, 0, -1]])
    assert diffusion_figures.paths(axes, [inside, outside, outside], reach=2.0) == 2
    assert axes.get_ylim() == (2.0, -0.5)  # what is deep is low


def test_broader_rings_keep_every_photon(walked):
    middles, density, error = diffusion_figures.ringed(walked)
    edges = walked.radii[:: diffusion_figures.TOGETHER]
    counts = density * np.pi * np.diff(edges**2) * walked.tally.photons
    assert np.allclose(counts.sum(), walked.counts[:-1].sum())
    assert np.allclose(error[counts > 0], (density / np.sqrt(np.maximum(counts, 1)))[counts > 0])
    assert ((edges[:-1] < middles) & (middles < edges[1:])).all()


def test_a_profile_is_drawn_in_its_colour_with_its_name(axes, walked):
    diffusion_figures.profile(axes, walked, figures.RED, "red")
    assert axes.get_yscale() == "log" and axes.lines[0].get_label() == "red"


def test_stairs_rise_at_each_tap_by_its_weight(axes):
    diffusion_figures.stairs(axes, np.array([2.0, 0.0, 1.0]), np.array([1.0, 2.0, 1.0]), figures.RED)
    radius, share = axes.lines[0].get_data()
    assert radius[:4].tolist() == [0.0, 0.0, 1.0, 2.0]
    assert share.tolist() == [0.0, 0.5, 0.75, 1.0, 1.0]


def test_what_slabs_let_through_has_a_point_and_a_line_for_each_channel(axes):
    d, share = np.array([1.0, 2.0]), np.array([0.5, 0.25])
    law = SimpleNamespace(thickness=d, share=share, error=share / 10)
    diffusion_figures.transmittance(axes, [law] * 3, [share] * 3, "")
    assert len(axes.containers) == 3 and axes.get_yscale() == "log"
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["red", "green", "blue"]


def test_the_first_bar_is_on_top():
    diffusion_figures.bars({"first": 3.0, "second": 1.0}, "", "delta E", noise=0.5)
    axes = pyplot.gcf().axes[0]
    heights = [axes.transData.transform((0, bar.get_y()))[1] for bar in axes.containers[0]]
    assert heights[0] > heights[1]
    assert [bar.get_width() for bar in axes.containers[0]] == [3.0, 1.0]


def test_sixteen_rings_are_one_by_hand():
    """Of 32 rings an eighth wide: 16 photons within 2 mm of 100, 48 between 2 and 4."""
    walked = SimpleNamespace(
        radii=np.arange(33) / 8, counts=np.repeat([1, 3, 9], [16, 16, 1]), tally=SimpleNamespace(photons=100)
    )
    middles, density, error = diffusion_figures.ringed(walked)
    areas = np.pi * np.array([4, 12])
    assert middles.tolist() == [1, 3]
    assert density == pytest.approx(np.array([0.16, 0.48]) / areas, rel=1e-12)
    assert error == pytest.approx(np.array([0.04, 48**0.5 / 100]) / areas, rel=1e-12)
