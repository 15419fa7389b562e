"""A kernel in mm: the material is the same, however large its picture is and however near the camera."""

import numpy as np
import pytest
from scenes import wall, written

import sss_ref

IN_PIXELS = {"blur.unit": "pixel", "blur.follow_surface": False}
IN_MM = {"blur.unit": "mm", "blur.follow_surface": True}


def averaged(buffer, count):
    """Means of count x count pixels, float64."""
    height, width = buffer.shape[:2]
    return buffer.reshape(height // count, count, width // count, count, -1).mean(axis=(1, 3), dtype=np.float64)


def difference(size, **blur):
    """How far a picture of the bust is from one of four times its size, on average inside the silhouette."""
    pictures = []
    for side in (size, 4 * size):
        fixed = {"camera.width": side, "camera.height": side, "shadow_map.width": 1024, "shadow_map.height": 1024}
        scene = sss_ref.load_scene("default", preset="robust", **fixed, **blur)
        pictures.append(sss_ref.render(scene, keep=["image", "coverage"]))
    small, large = pictures
    inside = (small["coverage"] != 0) & (averaged(large["coverage"], 4)[..., 0] == 1)
    return np.abs(small["image"] - averaged(large["image"], 4))[inside].mean()


@pytest.mark.parametrize("size", [128, pytest.param(512, marks=pytest.mark.full)])
def test_a_picture_of_four_times_the_size_shows_the_same(size):
    assert difference(size, **IN_MM) <= 1 / 255 < difference(size, **IN_PIXELS)


@pytest.fixture
def edge(tmp_path):
    """A wall that is black on the left and white on the right, seen and lit from the front."""
    positions, triangles = wall()
    left, right = (np.clip(positions, low, high) for low, high in (((-8, -8, 0), (0, 8, 0)), ((0, -8, 0), (8, 8, 0))))
    path = tmp_path / "wall.obj"
    written(path, np.concatenate([left, right]), np.concatenate([triangles, triangles + 4]))
    lines = path.read_text().splitlines()
    faces = [number for number, line in enumerate(lines) if line.startswith("f ")]
    lines[faces[2]] = f"usemtl white\n{lines[faces[2]]}"
    lines[faces[0]] = f"mtllib wall.mtl\nusemtl black\n{lines[faces[0]]}"
    path.write_text("\n".join(lines))
    (tmp_path / "wall.mtl").write_text("newmtl black\nKd 0 0 0\nnewmtl white\nKd 1 1 1\n")
    return {
        "preset": "robust",
        "mm_per_unit": 10.0,
        "mesh": {"path": str(path), "color": "material"},
        "camera": {"type": "orbit", "distance": 4.0, "fov_y": 0.3, "width": 256, "height": 9},
        "lights": [{"position": [0.0, 0.0, 50.0]}],
        "phong": {"specular": 0.0},
        "shadow_map": {"width": 64, "height": 64},
    }


def widths(scene, **blur):
    """Of the edge seen from 40 and from 80 units: how far it is from a tenth to nine tenths of the light, mm."""
    found = []
    for distance in (40.0, 80.0):
        image = sss_ref.render(sss_ref.load_scene(scene, **{"camera.distance": distance}, **blur)).image[4, :, 0]
        dark, bright = (np.interp(share * image[-1], image, np.arange(256)) for share in (0.1, 0.9))
        found.append((bright - dark) * pixel_length(distance))
    return found


def pixel_length(distance):
    return 10 * distance * 2 * np.tan(np.radians(0.3 / 2)) / 9


def test_a_plane_at_two_distances_is_softened_over_the_same_length(edge):
    near, far = widths(edge, **IN_MM)
    assert near > 4 and abs(near - far) <= pixel_length(80)
    near, far = widths(edge, **IN_PIXELS)
    assert far == pytest.approx(2 * near, rel=0.01)


def test_a_texel_is_as_long_as_the_surface_it_shows(tmp_path):
    positions, triangles = wall()
    path = written(tmp_path / "wall.obj", positions, triangles, uvs=(positions[:, :2] + 8) / (16, 32))
    scene = {
        "method": "texture_space",
        "preset": "robust",
        "mm_per_unit": 2.0,
        "mesh": {"path": path},
        "camera": {"type": "orbit", "distance": 4.0, "width": 16, "height": 16},
        "lights": [{"position": [0.0, 0.0, 50.0]}],
        "shadow_map": {"width": 64, "height": 64},
        "irradiance_map": {"width": 64, "height": 32, "dilate": 1},
        "blur": {"unit": "mm", "mm_per_offset": 4.0},
    }
    result = sss_ref.render(sss_ref.load_scene(scene))
    # The wall is 32 mm high and wide; the map shows it 64 texels wide and, on its lower half, 16 high.
    laid_out, filled = result["irradiance_mask"] != 0, result["texels_per_offset_mask"] != 0
    assert laid_out[:16].all() and not laid_out[16:].any()
    assert (result["mm_per_texel"][laid_out] == (0.5, 2)).all() and not result["mm_per_texel"][~laid_out].any()
    assert (result["texels_per_offset_filled"][filled] == (8, 2)).all()
    assert filled[:17].all() and not filled[17:].any()
    assert not result["scattered_irradiance"][~filled].any()
