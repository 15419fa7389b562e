"""What a rendering needs at one time is known before it begins, truthfully, and too much is refused before any work."""

import tracemalloc
from collections import Counter

import numpy as np
import pytest
from alternatives import all_methods
from PIL import Image

from sss_ref.cache.spare_memory import SPARE
from sss_ref.errors import SceneError
from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.rendering import memory
from sss_ref.rendering.fold import render
from sss_ref.rendering.memory import bytes_at_once, check_memory, scene_bytes
from sss_ref.rendering.samples import render_samples
from sss_ref.scene import load_scene
from sss_ref.scene_file import color_texture as textures

# Worked by hand: of each pass, bytes for a pixel of each table. Where the mesh is drawn, 4 of the piece and 4 of depth.
FINAL = {
    "screen_space": [
        {"shadow_map": 4 + 4 + 4 + 4},  # piece, depth; light_triangle, light_distance
        {"shadow_map": 8, "camera": 8 + 1 + 12},  # coverage, lit
        {"camera": 13 + 12},  # scattered
        {"camera": 1 + 12 + 12},  # lit is there no more; image
    ],
    "texture_space": [
        {"shadow_map": 8 + 4 + 4 + 8},  # light_triangle, light_distance, light_uv
        {"shadow_map": 16, "irradiance_map": 8 + 1 + 12},  # irradiance_mask, irradiance
        {"shadow_map": 16, "irradiance_map": 13 + 13},  # irradiance_filled and its mask, of two rounds
        {"shadow_map": 16, "irradiance_map": 1 + 12 + 12},  # scattered_irradiance
        {"shadow_map": 16, "irradiance_map": 12, "camera": 8 + 12},  # image
    ],
}


@pytest.fixture
def small():
    """A scene as a dictionary; its mesh has UVs."""
    return {
        "mesh": {"path": "sphere"},
        "camera": {"type": "orbit", "distance": 5},
        "lights": [{"position": [0, 0, 9]}],
    }


@pytest.mark.parametrize("method", FINAL)
def test_the_final_image_needs_what_is_not_yet_let_go(small, method):
    scene = load_scene(small, preset="robust", method=method)
    assert list(map(dict, bytes_at_once(scene.method, {"image"}))) == FINAL[method]


def test_at_the_end_there_is_all_that_is_kept():
    for method in all_methods():
        written = Counter()
        for one in method.passes:
            for kind in [] if one.on_demand else one.outputs.values():
                written[one.target] += CHANNELS[kind] * dtype_of(kind).itemsize
        *_, counted = bytes_at_once(method, set(method.outputs))
        last = next(one for one in reversed(method.passes) if not one.on_demand)
        assert counted - written == Counter({last.target: 4} if last.draw.vertex_stages else {}), method


@pytest.mark.parametrize(
    ("method", "table", "keep"),
    [
        ("screen_space", "camera", "final"),
        ("screen_space", "camera", "all"),
        ("texture_space", "irradiance_map", "final"),
    ],
)
def test_what_is_counted_is_what_is_taken(small, method, table, keep, monkeypatch):
    """NumPy tells what it takes; masks and the notes on an image are not counted, at most 4 bytes a pixel."""
    sides = {f"{each}.{side}": 64 for each in ("camera", "shadow_map") for side in ("width", "height")}
    sides |= {f"{table}.width": 1024, f"{table}.height": 1024}
    scene = load_scene(small, method=method, **sides)
    render(scene, keep=keep)
    monkeypatch.setattr(SPARE, "blocks", [])
    monkeypatch.setattr(SPARE, "most", 0)
    tracemalloc.start()
    render(scene, threads=1, keep=keep)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    counted = max(each[table] for each in bytes_at_once(scene.method, scene.kept(keep))) * 2**20
    assert 1 <= peak / counted < 1.2


LIGHTS = [{"position": [0, 0, 9]}] * 16
TOO_MUCH = {  # bytes are worked by hand from the buffers, in pixels of 2^20 to 2^26
    "camera": (  # (147 * 2^26 + 12 * 2^20) / 2^30
        "all",
        {"camera.width": 8192, "camera.height": 8192},
        "scene: camera: expected at most 4 GiB of buffers and pictures at one time, got 9.2 GiB, "
        '9.19 GiB of them here; make width and height smaller, or keep the "final" image alone',
    ),
    "shadow maps": (  # the last shadow map: 15 * 8 + 16 bytes for each of its 2^25 pixels
        "final",
        {"lights": LIGHTS, "shadow_map": {"width": 8192, "height": 4096}},
        "scene: shadow_map: expected at most 4 GiB of buffers and pictures at one time, got 4.25 GiB, "
        "4.25 GiB of them here; make width and height smaller or use fewer lights",
    ),
}


@pytest.mark.parametrize("case", TOO_MUCH)
def test_the_largest_part_is_named(small, case):
    keep, overrides, message = TOO_MUCH[case]
    small["camera"].update(width=256, height=256)
    small["shadow_map"] = {"width": 1024, "height": 1024}
    with pytest.raises(SceneError) as error:
        render(load_scene(small, **overrides), keep=keep)
    assert str(error.value) == message


def test_up_to_the_last_pixel(small):
    """(4 * 2^30 - 12 * 2^20) / 147 = 29131866.6 pixels, between 5397 * 5397 and 5397 * 5398."""
    small["shadow_map"] = {"width": 1024, "height": 1024}
    small["camera"].update(width=5397, height=5397)
    scene = load_scene(small)
    check_memory(scene, scene.kept("all"))
    scene = load_scene(small, **{"camera.height": 5398})
    with pytest.raises(SceneError, match="camera"):
        check_memory(scene, scene.kept("all"))


def test_the_final_image_of_8192_squared_fits(small):
    scene = load_scene(small, **{"camera.width": 8192, "camera.height": 8192})
    check_memory(scene, {"image"})
    with pytest.raises(SceneError, match=r"camera: expected at most 4 GiB .*; make width and height smaller$"):
        render_samples(scene, 2)


def test_pictures_count_by_what_they_declare(small, tmp_path, monkeypatch):
    """Three times 12 * 16384 * 10000 bytes, told with all other problems."""
    Image.new("1", (16384, 10000)).save(tmp_path / "a.png")
    monkeypatch.setattr(textures, "srgb_decoded", None)  # nothing is decoded
    small["mesh"] |= dict.fromkeys(("texture", "normal_map", "specular_map"), str(tmp_path / "a.png"))
    with pytest.raises(SceneError) as error:
        load_scene(small, **{"phong.shininess": 0})
    first, second = str(error.value).split("\n")
    assert first == (
        "scene: mesh.texture: expected at most 4 GiB of pictures, got 5.49 GiB, 1.83 GiB of them here; "
        "scale the picture down"
    )
    assert second.startswith("override: phong.shininess: expected")


def test_pictures_count_beside_buffers(small, tmp_path):
    """12 * 1000 * 1000 bytes are too many beside 147 * 5397^2 + 12 * 2^20."""
    Image.fromarray(np.zeros((1000, 1000, 3), np.uint8)).save(tmp_path / "a.png")
    small["mesh"]["texture"] = str(tmp_path / "a.png")
    small["shadow_map"] = {"width": 1024, "height": 1024}
    scene = load_scene(small, **{"camera.width": 5397, "camera.height": 5397})
    with pytest.raises(SceneError, match="camera"):
        check_memory(scene, scene.kept("all"))


@pytest.mark.parametrize(
    ("kept", "lights", "remedy"),
    [
        ({"image"}, 1, "make width and height smaller"),
        ({"image", "coverage"}, 1, "make width and height smaller"),
        ({"image", "lit"}, 1, 'make width and height smaller, or keep the "final" image alone'),
        ({"image"}, 2, "make width and height smaller or use fewer lights"),
    ],
)
def test_the_limit_itself_is_not_too_much(small, monkeypatch, kept, lights, remedy):
    """Beside the buffers there are 12 bytes, of the mesh's one colour."""
    scene = load_scene(small, **{"shadow_map.width": 64, "lights": LIGHTS[:lights]})
    needed = 12 + max(scene_bytes(scene, each).total() for each in bytes_at_once(scene.method, kept))
    monkeypatch.setattr(memory, "MEMORY_LIMIT", needed)
    check_memory(scene, kept)
    with pytest.raises(SceneError):
        check_memory(scene, kept, 1)
    monkeypatch.setattr(memory, "MEMORY_LIMIT", needed - 1)
    with pytest.raises(SceneError) as error:
        check_memory(scene, kept)
    assert str(error.value).endswith(f"of them here; {remedy}")
