"""Two scenes as another path tracer sees them: Mitsuba 3, with its own random walks, rays and mesh (extra `truth`)."""

import math

import numpy as np
import pytest

from sss_ref.scene.load import load_scene
from sss_ref.truth.media import volumes
from sss_ref.truth.photon import Volume
from sss_ref.truth.radiance import nothing_gathered
from sss_ref.truth.tracing import Tracing

SIZE, BLOCKS, PASSES = 32, 4, 8
INDEX_MATCHED = volumes("skin1", ior=1.0)
FORWARD = tuple(Volume(s, a, 0.6) for s, a in ((2.0, 0.03), (2.4, 0.1), (3.0, 0.3)))
SCENES = {  # with mean free paths of .03 units and more: Mitsuba moves the start of a ray by about 10^-4 (float32)
    "a sphere and a point": ("sphere", 10.0, INDEX_MATCHED, {"lights.0.falloff": "inverse_square"}),
    "a head, parallel rays and forward scattering": (
        "figure3_with",
        10.0,
        FORWARD,
        {"lights": [{"type": "directional", "azimuth": 120.0, "elevation": 30.0, "distance": 5.0}]},
    ),
}


@pytest.fixture
def mitsuba():
    found = pytest.importorskip("mitsuba", reason="pip install sss_ref[truth]")
    found.set_variant("scalar_rgb")  # llvm_ad_rgb wants a newer LLVM than many systems have, and dies without
    return found


def theirs(mi, tracing, passes):
    """Pictures (P, H, W, 3), row 0 at the bottom, each of its own seed."""
    camera, (light,) = tracing.scene.camera, tracing.scene.lights
    film = {"type": "hdrfilm", "width": SIZE, "height": SIZE, "rfilter": {"type": "box"}, "pixel_format": "rgb"}
    view = mi.ScalarTransform4f().look_at(origin=list(camera.eye), target=list(camera.target), up=list(camera.up))
    sensor = {"type": "perspective", "fov": camera.lens.fov_y, "fov_axis": "y", "to_world": view, "film": film}
    power = [float(math.pi * light.intensity * each) for each in light.color]
    if light.view.lens.is_parallel:
        lamp = {
            "type": "directional",
            "direction": list(light.view.direction),
            "irradiance": {"type": "rgb", "value": power},
        }
    else:
        lamp = {"type": "point", "position": list(light.position), "intensity": {"type": "rgb", "value": power}}
    scene = {
        "type": "scene",
        "integrator": {"type": "volpathmis", "max_depth": -1, "rr_depth": 1000},
        "sensor": {**sensor, "sampler": {"type": "independent", "sample_count": 64}},
        "light": lamp,
        "body": mesh_of(mi, tracing),
    }
    loaded = mi.load_dict(scene)
    return np.array([np.array(mi.render(loaded, seed=seed))[::-1] for seed in range(passes)])


def mesh_of(mi, tracing):
    """The triangles that ours meets, with nothing at the border and the medium inside."""
    tree = tracing.scenery.tree
    corners = np.stack((tree.corner, tree.corner + tree.edge1, tree.corner + tree.edge2), axis=1)
    per_unit = np.array([(v.scattering, v.scattering + v.absorption) for v in tracing.volumes_per_unit])
    largest = float(per_unit[:, 1].max())
    medium = {
        "type": "homogeneous",
        "albedo": {"type": "rgb", "value": list(per_unit[:, 0] / per_unit[:, 1])},
        "sigma_t": {"type": "rgb", "value": list(per_unit[:, 1] / largest)},
        "scale": largest,
        "phase": {"type": "hg", "g": tracing.volumes[0].anisotropy},
    }
    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict({"type": "null"})
    properties["interior"] = mi.load_dict(medium)
    mesh = mi.Mesh("body", vertex_count=3 * len(corners), face_count=len(corners), props=properties)
    parameters = mi.traverse(mesh)
    parameters["vertex_positions"] = corners.astype(np.float32).ravel()
    parameters["faces"] = np.arange(3 * len(corners), dtype=np.uint32)
    parameters.update()
    return mesh


def blocks(picture):
    """Means over BLOCKS x BLOCKS parts of a picture (..., H, W, 3)."""
    part = SIZE // BLOCKS
    return picture.reshape(*picture.shape[:-3], BLOCKS, part, BLOCKS, part, 3).mean(axis=(-4, -2))


@pytest.mark.full
@pytest.mark.parametrize("name", SCENES)
def test_the_mean_radiance_is_mitsubas(name, mitsuba):
    """Within 1 % or three standard errors, of the picture and of each of 16 parts of it that is not nearly black."""
    scene, unit, medium, keys = SCENES[name]
    loaded = load_scene(scene, **{"camera.width": SIZE, "camera.height": SIZE, "mm_per_unit": unit, **keys})
    ours = nothing_gathered(Tracing(loaded, medium, across_pixel=True)).more(512)
    passes = theirs(mitsuba, ours.of, PASSES)
    for reduce in (lambda picture: picture.mean(axis=(-3, -2)), blocks):
        own, other = reduce(ours.mean), reduce(passes)
        share = own.size / ours.mean.size
        own_error = np.sqrt(reduce(ours.error**2) * share)
        error = np.sqrt(own_error**2 + other.var(axis=0, ddof=1) / PASSES)
        other = other.mean(axis=0)
        bright = other > 0.02 * other.max()
        off = np.abs(own - other)
        assert ((off < 0.01 * other) | (off < 3 * error))[bright].all()
