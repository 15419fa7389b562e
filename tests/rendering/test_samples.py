from dataclasses import replace
from itertools import pairwise

import imageio.v3 as imageio
import numpy as np
import pytest
from scenes import around, sphere, written

from sss_ref.errors import SceneError
from sss_ref.pictures.png_file import srgb8
from sss_ref.rendering import samples
from sss_ref.rendering.fold import render
from sss_ref.rendering.samples import MovedView, moved, offsets, render_samples
from sss_ref.results.folder import save
from sss_ref.results.manifest import read_manifest
from sss_ref.results.verify import verify
from sss_ref.scene.load import load_scene


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    path = written(tmp_path_factory.mktemp("mesh") / "sphere.obj", *sphere(8)[:2])
    return load_scene(around(path, size=32, output={"background": [0.1, 0.2, 0.3]}))


@pytest.fixture(scope="module")
def sampled(scene):
    return render_samples(scene, 2)


def test_offsets_are_the_middles_of_equal_parts_x_fastest():
    assert list(offsets(1)) == [(0, 0)]
    assert list(offsets(2)) == [(-0.25, -0.25), (0.25, -0.25), (-0.25, 0.25), (0.25, 0.25)]
    assert list(offsets(4))[6] == (0.125, -0.125)


def test_a_moved_view_moves_every_point_by_the_offset(scene):
    """In pixels, right and up, whatever the point's distance; depth and w stay."""
    view = moved(scene, (0.25, -0.375)).camera
    assert isinstance(view, MovedView) and view.view.tolist() == scene.camera.view.tolist()
    half = np.array([view.width, view.height]) / 2
    for point in ([0.0, 0, -3, 1], [1, -2, -5, 1], [-0.5, 0.25, -0.75, 1]):
        before, after = (m.projection @ np.array(point) for m in (scene.camera, view))
        assert after[2:].tolist() == before[2:].tolist()
        # The matrix is float64 and rounded: 1e-12 pixels is far below 2^-8, the step of the viewport.
        assert ((after[:2] / after[3] - before[:2] / before[3]) * half).tolist() == pytest.approx(
            [0.25, -0.375], abs=1e-12
        )


def test_a_whole_pixel_moves_the_picture(scene):
    """To the right and upwards; the rounding of positions within a pixel may touch its edges."""
    stay, go = (render(each, keep=["coverage"])["coverage"] for each in (scene, moved(scene, (3.0, 1.0))))
    assert np.count_nonzero(stay[:-1, :-3] != go[1:, 3:]) <= 2 < np.count_nonzero(stay != go)


def test_one_sample_is_a_plain_rendering(scene):
    sampled, plain = render_samples(scene, 1), render(scene)
    assert sampled.image.tobytes() == plain.image.tobytes()
    assert sampled.hashes == {"image": plain.hashes["image"]}
    assert np.array_equal(sampled.coverage, plain["coverage"])
    assert sampled.foreground.tobytes() == plain.image.tobytes()


def test_average_agrees_with_a_naive_loop(scene, sampled):
    images = []
    for y in (-0.25, 0.25):
        for x in (-0.25, 0.25):
            images.append(render(replace(scene, camera=moved(scene, (x, y)).camera)))
    total = images[0].image
    covered = images[0].image * images[0]["coverage"][..., None]
    for one in images[1:]:
        total = total + one.image
        covered = covered + one.image * one["coverage"][..., None]
    assert sampled.image.dtype == np.float32
    assert sampled.image.tobytes() == (total / np.float32(4)).tobytes()
    count = sum(one["coverage"].astype(int) for one in images)
    assert np.array_equal(sampled.coverage * 4, count) and set(np.unique(count)) >= {0, 1, 4}
    some = count > 0
    assert np.array_equal(
        sampled.foreground[some], (covered / np.maximum(count, 1).astype(np.float32)[..., None])[some]
    )
    assert np.array_equal(sampled.foreground[~some], sampled.image[~some])
    assert not all(np.array_equal(a.image, b.image) for a, b in pairwise(images))


@pytest.mark.parametrize("interpreter, threads", [("arrays", 1), ("kernel", 2)])
def test_the_bits_are_the_same_however_it_is_run(scene, sampled, interpreter, threads):
    assert render_samples(scene, 2, interpreter, threads).hashes == sampled.hashes


def test_passes_are_told_with_their_sample(scene):
    told = []
    render_samples(scene, 2, on_pass=told.append)
    assert len(told) == 16 and told[0] == "shadow_map, sample 1 of 4" and told[-1] == "composite, sample 4 of 4"


def test_durations_add_up(sampled):
    assert list(sampled.timings) == ["shadow_map", "camera", "blur", "composite"]
    assert all(seconds > 0 for seconds in sampled.timings.values())


@pytest.mark.parametrize("n", [0, -2])
def test_no_samples(scene, n):
    with pytest.raises(SceneError, match=f"samples: expected at least 1, got {n}"):
        render_samples(scene, n)


def test_saved_and_verified(scene, sampled, tmp_path):
    folder = save(sampled, tmp_path / "out", "kernel", 1)
    manifest = read_manifest(folder)
    assert manifest.samples == 2 and [record.name for record in manifest.buffers] == ["image"]
    pixels = imageio.imread(folder / "image.png")[::-1]
    assert np.array_equal(pixels[..., :3], srgb8(sampled.foreground))
    assert np.array_equal(pixels[..., 3], np.rint(sampled.coverage * 255))
    assert set(np.unique(pixels[..., 3])) >= {0, 64, 255}
    assert verify(folder, "kernel", 1).message == "verified: 1 buffer equal in every bit"
    path = folder / "manifest.json"
    path.write_text(path.read_text().replace('"samples": 2', '"samples": 3'))
    assert verify(folder, "kernel", 1).message.startswith("computation differs: buffer image, first at pixel")


def test_the_sum_needs_84_bytes_of_each_pixel(scene, monkeypatch):
    """Seven float32, of a sample, of all before it, and of their sum; told before any is drawn."""
    asked = []

    def refuse(*given):
        asked.append(given)
        raise SceneError("too much")

    monkeypatch.setattr(samples, "check_memory", refuse)
    with pytest.raises(SceneError, match="too much"):
        render_samples(scene, 2)
    assert asked == [(scene, {"coverage", "image"}, 84)]
