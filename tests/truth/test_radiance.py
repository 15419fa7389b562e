"""Paths through meshes: the same bits however they are run, and the radiance of closed forms and of photons."""

import math
import os
import time
import zipfile

import numpy as np
import pytest
from boxes import looking_down, parallel_light, write_box
from meeting import Meeting

from sss_ref.errors import SceneError
from sss_ref.numerics.random_numbers import new_stream
from sss_ref.scene.load import load_scene
from sss_ref.truth import radiance
from sss_ref.truth.media import volumes
from sss_ref.truth.path import survived
from sss_ref.truth.photon import REFLECTED, TRANSMITTED, Volume
from sss_ref.truth.radiance import nothing_gathered, read_radiance
from sss_ref.truth.samplers import reflectance
from sss_ref.truth.slab import slab
from sss_ref.truth.tracing import Tracing

SMALL = {"camera.width": 12, "camera.height": 10, "mm_per_unit": 10.0}
WIDE = 60.0  # half the width of what stands for an endless slab, mm


def gray(volume):
    return volume, volume, volume


def traced(scene, volume, samples, border="matched", **more):
    return nothing_gathered(Tracing(load_scene(scene), gray(volume), border, **more)).more(samples)


@pytest.fixture(scope="module")
def sphere():
    return Tracing(load_scene("sphere", **SMALL), volumes("skin1"))


@pytest.fixture(scope="module")
def thick_slab(tmp_path_factory):
    return write_box(tmp_path_factory.mktemp("slab") / "slab.obj", (-WIDE, -WIDE, -1.5), (WIDE, WIDE, 0.0))


def same(one, other):
    return one.samples == other.samples and all(map(np.array_equal, one.sums, other.sums))


def test_the_same_bits_from_one_two_and_three_threads(sphere):
    one, two, three = (nothing_gathered(sphere).more(3, threads) for threads in (1, 2, 3))
    assert same(one, two) and same(one, three)
    assert one.mean.max() > 0


def test_two_goes_are_as_one(sphere, tmp_path):
    half = nothing_gathered(sphere).more(3)
    half.save(tmp_path / "sums.npz")
    assert same(read_radiance(tmp_path / "sums.npz", sphere).more(3), nothing_gathered(sphere).more(6))
    assert [path.name for path in tmp_path.iterdir()] == ["sums.npz"]


def test_progress_is_told_and_a_limit_of_time_kept(sphere):
    told = []
    stopped = nothing_gathered(sphere).more(5, seconds=0.0, on_progress=lambda *found: told.append(found))
    assert told == [(1, 5)] and stopped.samples == 1
    assert np.isinf(stopped.error).all()


def test_other_sums_are_refused(sphere, tmp_path):
    path = tmp_path / "sums.npz"
    nothing_gathered(sphere).more(1).save(path)
    other = Tracing(sphere.scene, sphere.volumes, seed=1)
    with pytest.raises(SceneError, match=r"sums\.npz: expected the sums of this scene, material and seed, got those"):
        read_radiance(path, other)
    for content in (b"", b"PK\3\4", path.read_bytes()[:200]):
        path.write_bytes(content)
        check_is_no_sum(path, sphere)
    path.unlink()
    os.mkfifo(path)
    with pytest.raises(SceneError, match="expected the sums of a tracing, got no regular file"):
        read_radiance(path, sphere)


@pytest.mark.parametrize(
    "change",
    [
        *({"samples": -1}, {"samples": 1.5}, {"total": np.zeros((2, 2, 3))}, {"square": np.zeros(3, np.float32)}),
        *(
            {"total": math.nan},
            {"total": math.inf},
            {"square": -1.0},
            {"counted": -1},
            {"format": "sss_ref radiance 0"},
        ),
    ],
    ids=str,
)
def test_damaged_sums_are_refused(sphere, tmp_path, change):
    """A number is put into the first place of the array that has the name."""
    path = tmp_path / "sums.npz"
    nothing_gathered(sphere).more(1).save(path)
    with np.load(path) as content:
        found = dict(content)
    ((name, value),) = change.items()
    if found[name].shape and np.ndim(value) == 0:
        found[name][0, 0, 0] = value
    else:
        found[name] = value
    np.savez(path, **found)
    check_is_no_sum(path, sphere)


def test_an_array_and_a_header_without_end_are_no_sums(sphere, tmp_path):
    path = tmp_path / "sums.npz"
    with path.open("wb") as file:
        np.save(file, np.zeros(3))
    check_is_no_sum(path, sphere)
    nothing_gathered(sphere).save(path)
    with zipfile.ZipFile(path) as archive:
        names = {name: archive.read(name) for name in archive.namelist()}
    with zipfile.ZipFile(path, "w") as archive:
        for name, content in names.items():
            archive.writestr(name, content.replace(b", }", b",  "))
    check_is_no_sum(path, sphere)
    with zipfile.ZipFile(path, "w") as archive:
        for name, content in (names | {"total.npy": b"no array"}).items():
            archive.writestr(name, content)
    check_is_no_sum(path, sphere)


def check_is_no_sum(path, tracing):
    with pytest.raises(SceneError, match="expected the sums of a tracing, got something else"):
        read_radiance(path, tracing)


def test_without_scattering_no_light_turns_round(sphere, thick_slab):
    assert not nothing_gathered(Tracing(sphere.scene, gray(Volume(0.0, 1.0)))).more(2).mean.any()
    front = looking_down(thick_slab, [parallel_light((0.0, 0.6, 0.8))])
    assert not traced(front, Volume(0.0, 1.0), 2, border="diffuse").mean.any()


def test_a_light_path_goes_on_as_often_as_keeps_its_weight():
    stream = new_stream(8)
    assert survived(stream, 0.1) == 0.1 and survived(stream, 0.7) == 0.7
    drawn = np.array([survived(stream, 0.03) for _ in range(4000)])
    assert set(drawn) == {0.0, 0.1}
    assert abs(drawn.mean() - 0.03) < 4 * drawn.std() / math.sqrt(len(drawn))


def test_single_scattering_along_rays_through_a_slab(thick_slab):
    """Of a medium that scatters hardly: s/4 * e^(-t*z) * e^(-t*(d - z)/m), summed over z; twice is below 1 % of it."""
    albedo, cosine = 0.01, 0.8
    light = parallel_light((math.sqrt(1 - cosine**2), 0.0, -cosine))
    found = traced(looking_down(thick_slab, [light]), Volume(albedo, 1 - albedo), 100)
    z = (np.arange(2000) + 0.5) * 1.5 / 2000
    expected = albedo / 4 * (np.exp(-z) * np.exp(-(1.5 - z) / cosine)).sum() * 1.5 / 2000
    mean, error = found.mean.mean(), math.sqrt((found.error**2).sum()) / found.error.size
    assert abs(mean - expected) < 4 * error + 0.01 * expected


@pytest.mark.parametrize("g", [0.0, 0.7])
@pytest.mark.parametrize(("side", "fate"), [(1, REFLECTED), (-1, TRANSMITTED)])
def test_a_slab_lit_from_all_sides_is_as_bright_as_photons_say(thick_slab, g, side, fate):
    """Reciprocity: lit by radiance 1 from all sides, what is seen straight down is the share of a beam that gets there.

    Eight directions of Gauss and Legendre stand for all sides; a matched border does not turn their light.
    """
    nodes, weights = np.polynomial.legendre.leggauss(8)
    lights = [
        parallel_light((math.sqrt(1 - m * m), 0.0, side * m), 2 * math.pi * w / math.pi)  # pi * e is the irradiance
        for m, w in zip((nodes + 1) / 2, weights / 2, strict=True)
    ]
    volume = Volume(2.0, 0.5, g)
    found = traced(looking_down(thick_slab, lights), volume, 60)
    beam = slab(volume, 1.5, 30_000, diffuse=False)
    expected = beam.share(fate) - (beam.counts[fate, 0].sum() / beam.photons)  # lights are no radiance to be seen
    mean, error = found.mean.mean(), math.sqrt((found.error**2).sum()) / found.error.size
    assert abs(mean - expected) < 4 * math.hypot(error, beam.share_error(fate))


@pytest.mark.parametrize("ior", [1.0, 1.4])
@pytest.mark.parametrize(("side", "fate"), [(1, REFLECTED), (-1, TRANSMITTED)])
def test_a_slab_with_a_diffuse_border_is_as_bright_as_photons_say(thick_slab, ior, side, fate):
    """F * F * e * cos * R: of what enters, so much leaves; F twice, the light's and the eye's share that enters."""
    volume, cosine, intensity = Volume(2.0, 0.5, 0.3, ior), 0.15, 2.5  # low, where much is reflected
    light = parallel_light((math.sqrt(1 - cosine**2), 0.0, side * cosine), intensity)
    found = traced(looking_down(thick_slab, [light]), volume, 100, border="diffuse")
    photons = slab(volume, 1.5, 30_000)
    entering = (1 - reflectance(1.0, 1 / ior)) * (1 - reflectance(cosine, 1 / ior)) * intensity * cosine
    mean, error = found.mean.mean(), math.sqrt((found.error**2).sum()) / found.error.size
    assert abs(mean - entering * photons.share(fate)) < 4 * math.hypot(error, entering * photons.share_error(fate))


@pytest.mark.parametrize(("side", "fate"), [(1, REFLECTED), (-1, TRANSMITTED)])
def test_of_the_light_that_has_entered_as_much_leaves_as_photons_say(thick_slab, side, fate):
    """e * cos * R: the same without F, though light is thrown back inside."""
    volume, cosine, intensity = Volume(2.0, 0.5, 0.3, 1.4), 0.15, 2.5
    light = parallel_light((math.sqrt(1 - cosine**2), 0.0, side * cosine), intensity)
    found = traced(looking_down(thick_slab, [light]), volume, 100, border="entered")
    photons, entering = slab(volume, 1.5, 30_000), intensity * cosine
    mean, error = found.mean.mean(), math.sqrt((found.error**2).sum()) / found.error.size
    assert abs(mean - entering * photons.share(fate)) < 4 * math.hypot(error, entering * photons.share_error(fate))


def test_a_sphere_that_scatters_hardly():
    """In its middle: s/4 * sum over the ray of e^(-t*z) * e^(-t*length towards the light); twice is below 2 % of it."""
    albedo, size = 0.02, 5
    scene = load_scene("sphere", **{"camera.width": size, "camera.height": size, "mm_per_unit": 1.0})
    found = nothing_gathered(Tracing(scene, gray(Volume(albedo, 1 - albedo)))).more(1500)
    eye, light = scene.camera.eye, scene.lights[0]
    ahead = scene.camera.direction
    corners = np.asarray(scene.mesh.positions, float)
    radius = np.sqrt((corners**2).sum(axis=1)).max()
    along = eye @ ahead
    root = math.sqrt(along**2 - (eye @ eye - radius**2))
    z = (np.arange(4000) + 0.5) * 2 * root / 4000
    points = eye + (-along - root + z)[:, None] * ahead
    to_light = light.position - points
    distance = np.sqrt((to_light**2).sum(axis=1))
    inward = (points * to_light).sum(axis=1) / distance
    length = -inward + np.sqrt(inward**2 - (points**2).sum(axis=1) + radius**2)
    expected = light.intensity * albedo / 4 * np.exp(-z - length).sum() * 2 * root / 4000
    middle = found.mean[size // 2, size // 2, 0], found.error[size // 2, size // 2, 0]
    assert abs(middle[0] - expected) < 4 * middle[1] + 0.02 * expected


def test_the_light_of_a_scene_makes_a_white_surface_as_bright_as_its_stages_do(thick_slab):
    """e * N.L of a body that absorbs nothing and that light hardly enters; 5 % of it comes out on the other side."""
    light = parallel_light((0.6, 0.0, 0.8), 1.5)
    found = traced(looking_down(thick_slab, [light]), Volume(20.0, 0.0), 10, border="diffuse")
    assert found.mean.mean() == pytest.approx(1.5 * 0.8, rel=0.08)


def test_light_fades_with_the_square_of_the_distance_where_the_scene_says_so(thick_slab):
    near, far = (
        traced(
            looking_down(thick_slab, [{"position": [0.0, 0.0, height], "falloff": "inverse_square"}], view_height=0.1),
            Volume(20.0, 1.0),
            300,
        )
        for height in (500.0, 1000.0)
    )
    assert near.mean.mean() / far.mean.mean() == pytest.approx(4, rel=1e-2)  # the same paths, nearly the same angles


def test_a_pixels_row_0_is_at_the_bottom(tmp_path):
    box = write_box(tmp_path / "low.obj", (-1.0, -1.0, -1.0), (1.0, -0.5, 1.0))
    found = traced(looking_down(box, [parallel_light((0.0, 0.6, 0.8))], view_height=2.0), Volume(5.0, 1.0), 4)
    assert (found.mean[0] > 0).all() and not found.mean[1:].any()


def test_samples_across_a_pixel_see_its_edges(tmp_path):
    box = write_box(tmp_path / "half.obj", (-1.0, -1.0, -1.0), (1.0, 0.2, 1.0))
    scene = looking_down(box, [parallel_light((0.0, 0.6, 0.8))], size=2, view_height=2.0)
    centres = traced(scene, Volume(5.0, 1.0), 50)
    across = traced(scene, Volume(5.0, 1.0), 50, across_pixel=True)
    assert not centres.mean[1].any() and across.mean[1].all()


def test_a_mesh_turned_inside_out_is_the_same_body(tmp_path):
    right = write_box(tmp_path / "right.obj", (-1.0, -1.0, -1.0), (1.0, 1.0, 1.0))
    lines = right.read_text().splitlines()
    turned = [f"f {' '.join(reversed(line.split()[1:]))}" if line.startswith("f") else line for line in lines]
    (tmp_path / "turned.obj").write_text("\n".join(turned))
    lights = [parallel_light((0.0, 0.6, 0.8))]
    one, other = (
        traced(looking_down(tmp_path / name, lights), Volume(2.0, 0.5), 40) for name in ("right.obj", "turned.obj")
    )
    error = math.sqrt((one.error**2).sum() + (other.error**2).sum()) / one.error.size
    assert other.lost == 0 and abs(one.mean.mean() - other.mean.mean()) < 4 * error


@pytest.mark.parametrize(
    ("scene", "border", "line"),
    [
        ("wedge", "smooth", r"border: expected matched or diffuse or entered, got 'smooth'"),
        ("teeth_layers", "matched", r"layers: expected one body, got another inside it"),
        (
            "lesson_stretch",
            "matched",
            r"mesh: expected a closed surface, so that there is an inside, got one with holes",
        ),
    ],
)
def test_what_cannot_be_traced_is_refused(scene, border, line):
    with pytest.raises(SceneError, match=line):
        Tracing(load_scene(scene), volumes("skin1"), border)


@pytest.mark.parametrize(("asked", "used"), [(1, 1), (2, 2), (None, 3)])
def test_so_many_threads_share_the_rows(sphere, monkeypatch, asked, used):
    """As many at a time as are asked for, else one per processor: none goes on before all are there."""
    work = Meeting(used)
    monkeypatch.setattr(os, "cpu_count", lambda: 3)
    monkeypatch.setattr(radiance, "gather_row", work)
    short = Tracing(load_scene("sphere", **SMALL | {"camera.height": 6}), sphere.volumes)
    found = nothing_gathered(short).more(2, asked)
    assert len(work.threads) == used and found.samples == 2


def test_time_that_is_over_ends_it_after_a_sample(sphere, monkeypatch):
    """The clock is looked at before each but the first: at 0, 1, 2 and 3 s."""
    monkeypatch.setattr(radiance, "gather_row", lambda *_: None)
    for seconds, samples in ((0.5, 1), (1.0, 1), (1.5, 2), (3.5, 4), (math.inf, 5)):
        monkeypatch.setattr(time, "monotonic", iter(range(9)).__next__)
        assert nothing_gathered(sphere).more(5, seconds=seconds).samples == samples
