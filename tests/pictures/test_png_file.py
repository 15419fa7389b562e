import imageio.v3 as imageio
import numpy as np
import pytest
from mpmath import mp, mpf
from scenes import settings_with

from sss_ref.pictures.png_file import encoding_of, image_encoding_of, plain8, srgb8, srgb_edges, write_png


def encoded(linear):
    """The standard's encoding, forward, at 50 digits; times 255."""
    x = mpf(float(linear))
    with mp.workdps(50):
        return 255 * (
            mpf("12.92") * x if x <= mpf("0.0031308") else mpf("1.055") * x ** (1 / mpf("2.4")) - mpf("0.055")
        )


def test_edges_are_the_least_values_that_round_up():
    edges = srgb_edges()
    assert edges.dtype == np.float32 and edges.shape == (255,)
    for code, edge in enumerate(edges, start=1):
        assert encoded(edge) >= code - mpf("0.5") > encoded(np.nextafter(edge, np.float32(0)))
    assert srgb8(edges).tolist() == list(range(1, 256))
    assert srgb8(np.nextafter(edges, np.float32(0))).tolist() == list(range(255))


def test_codes_at_and_beyond_the_ends():
    values = np.array([-1, -0.0, 0, 1, 2, 65504], np.float32)
    assert srgb8(values).tolist() == [0, 0, 0, 255, 255, 255]
    # 0.5 encodes to 1.055 * 0.5^(1/2.4) - 0.055 = 0.7353569..., times 255 = 187.516
    assert srgb8(np.float32([0.5])).tolist() == [188]


@pytest.mark.parametrize("height", [5, 39])  # fewer rows than are encoded at a time, and more
@pytest.mark.parametrize("channels", [3, 4])
def test_file_is_top_row_first_and_alpha_is_coverage(tmp_path, channels, height):
    generator = np.random.default_rng(1)
    image = generator.random((height, 7, 3), np.float32)
    coverage = generator.integers(0, 2, (height, 7), np.uint8)
    write_png(tmp_path / "x.png", image, coverage if channels == 4 else None)
    pixels = imageio.imread(tmp_path / "x.png")
    assert pixels.shape == (height, 7, channels)
    assert np.array_equal(pixels[::-1, :, :3], srgb8(image))
    if channels == 4:
        assert np.array_equal(pixels[::-1, :, 3], coverage * 255)


def test_share_of_coverage_is_rounded_to_the_nearest_alpha(tmp_path):
    share = np.float32([[0, 0.25, 0.5, 1]])  # 255 times it: 0, 63.75, 127.5 (to the even neighbour), 255
    write_png(tmp_path / "x.png", np.zeros((1, 4, 3), np.float32), share)
    assert imageio.imread(tmp_path / "x.png")[0, :, 3].tolist() == [0, 64, 128, 255]


def test_values_of_other_types_and_strides_are_rounded_first():
    values = np.linspace(-0.2, 1.3, 600).reshape(20, 30)
    assert np.array_equal(srgb8(values), srgb8(values.astype(np.float32)))
    assert np.array_equal(srgb8(values.astype(np.float32)[::-2, ::3]), srgb8(values)[::-2, ::3])
    assert srgb8(np.float32(0.5)).item() == 188


@pytest.mark.parametrize(("stops", "factor"), [(1.0, 2.0), (-3.0, 0.125), (0.5, 1.41421354)])
def test_exposure_counts_stops_and_only_of_the_image(stops, factor):
    values = np.linspace(0, 9, 500, dtype=np.float32)
    settings = settings_with({"output.exposure": stops})
    assert settings.output.gain == np.float32(factor)
    assert np.array_equal(image_encoding_of(settings)(values), srgb8(values * np.float32(factor)))
    assert np.array_equal(encoding_of(settings)(values), srgb8(values))


def test_exposure_of_nothing_of_the_printed_figures_and_of_what_overflows():
    assert image_encoding_of(settings_with({})) is srgb8
    published = {"preset": "published", "output.exposure": 1.0}
    assert image_encoding_of(settings_with(published))(np.float32([0.25, 0.6])).tolist() == [128, 255]
    assert plain8(np.float32([0.5])).item() == 128
    brightest = image_encoding_of(settings_with({"output.exposure": 20.0}))
    assert brightest(np.float32([3e38, 0])).tolist() == [255, 0]
