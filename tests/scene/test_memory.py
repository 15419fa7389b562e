"""What a scene needs is known from its file, truthfully, and too much is refused before any work."""

from collections import Counter

import pytest
from alternatives import methods_with_settings
from PIL import Image

from sss_ref.errors import SceneError
from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.scene import load_scene
from sss_ref.scene.catalogue import METHODS
from sss_ref.scene.memory import bytes_per_pixel
from sss_ref.scene_file import color_texture as textures
from sss_ref.scene_file.presets import ROBUST
from sss_ref.scene_file.scattering import Blur
from sss_ref.scene_file.settings import MeshSettings
from sss_ref.scene_file.viewpoints import PointLight


def problems(scene, **overrides):
    with pytest.raises(SceneError) as error:
        load_scene(scene, **overrides)
    return str(error.value).split("\n")


BYTES = {  # per pixel or texel, worked by hand from the list of buffers: those there once, and those of each light
    "screen_space": {"camera": (89, 83), "shadow_map": (0, 12)},
    "texture_space": {"camera": (77, 91), "shadow_map": (0, 20), "irradiance_map": (1, 37)},
}
IN_MM = {"screen_space": {"camera": 8}, "texture_space": {"irradiance_map": 29}}  # more where the kernel is in mm
PHONG_SUM = 12  # several lights have a `phong` each, and one together


@pytest.mark.parametrize("unit", ["pixel", "mm"])
@pytest.mark.parametrize("lights", [*range(1, 17), 64])
@pytest.mark.parametrize("method", METHODS)
def test_every_buffer_counts(method, lights, unit):
    worked = {table: once + each * lights for table, (once, each) in BYTES[method].items()}
    worked["camera"] += PHONG_SUM if lights > 1 else 0
    for table, more in IN_MM[method].items():
        worked[table] += more if unit == "mm" else 0
    tables = {"method": method, "preset": "robust", "lights": (PointLight.model_construct(),) * lights}
    blur = Blur.model_construct(**ROBUST["blur"] | {"unit": unit})
    assert bytes_per_pixel({**tables, "blur": blur}) == worked
    assert unit == "mm" or bytes_per_pixel(tables) == worked


@pytest.mark.parametrize("method", METHODS)
def test_maps_add_a_normal_and_a_weight(method):
    tables = {"method": method, "preset": "robust"}
    mapped = MeshSettings.model_construct(path="", normal_map="a.png", specular_map="b.png")
    without, both = bytes_per_pixel(tables), bytes_per_pixel({**tables, "mesh": mapped})
    assert both == {**without, "camera": without["camera"] + 12 + 4}


def test_what_is_counted_is_what_is_written():
    for method, settings in methods_with_settings():
        written = Counter()
        for one in method.passes:
            for kind in [] if one.on_demand else one.outputs.values():
                written[one.target] += CHANNELS[kind] * dtype_of(kind).itemsize
        assert written == bytes_per_pixel(dict(settings))


LIGHTS = [{"position": [0, 0, 9]}] * 16
# 2^30 bytes are 1 GiB; the sums are worked by hand from the table of bytes. The textured mesh has UVs.
TOO_MUCH = {
    "camera": (  # 147 * 2^26 + 12 * 2^20
        {"camera.width": 8192, "camera.height": 8192},
        "camera: expected at most 4 GiB of buffers and textures, got 9.20 GiB, 9.19 GiB of them here; "
        "make width and height smaller",
    ),
    "shadow maps": (  # 1029 * 2^16 + 16 * 12 * 2^25
        {"lights": LIGHTS, "shadow_map": {"width": 8192, "height": 4096}},
        "shadow_map: expected at most 4 GiB of buffers and textures, got 6.06 GiB, 6.00 GiB of them here; "
        "make width and height smaller or use fewer lights",
    ),
    "irradiance maps": (  # 1145 * 2^16 + 320 * 2^20 + (1 + 16 * 37) * 2^24
        {"method": "texture_space", "lights": LIGHTS, "irradiance_map.width": 4096, "irradiance_map.height": 4096},
        "irradiance_map: expected at most 4 GiB of buffers and textures, got 9.65 GiB, 9.27 GiB of them here; "
        "make width and height smaller or use fewer lights",
    ),
}


@pytest.mark.parametrize("case", TOO_MUCH)
def test_the_largest_part_is_named(small, case):
    small["camera"].update(width=256, height=256)
    small["shadow_map"] = {"width": 1024, "height": 1024}
    overrides, message = TOO_MUCH[case]
    assert problems(small, **overrides) == [f"override: {message}"]


def test_up_to_the_last_pixel(small):
    small["shadow_map"] = {"width": 1024, "height": 1024}
    # (4 * 2^30 - 12 * 2^20) / 147 = 29131866.6 pixels, between 5397 * 5397 and 5397 * 5398.
    small["camera"].update(width=5397, height=5398)
    assert problems(small)
    small["camera"].update(height=5397)
    assert load_scene(small).camera.height == 5397


def test_a_texture_counts_by_what_it_declares(small, tmp_path, monkeypatch):
    Image.new("1", (16384, 10000)).save(tmp_path / "a.png")
    monkeypatch.setattr(textures, "srgb_decoded", None)  # nothing is decoded
    small["mesh"]["texture"] = str(tmp_path / "a.png")
    # 12 * 16384 * 10000 + 147 * 3 * 2^22 + 12 * 2^26
    small["shadow_map"] = {"width": 8192, "height": 8192}
    small["camera"].update(width=4096, height=3072)
    assert problems(small) == [
        "scene: mesh.texture: expected at most 4 GiB of buffers and textures, "
        "got 4.30 GiB, 1.83 GiB of them here; scale the picture down"
    ]


def test_every_picture_counts(small, tmp_path):
    """Three times 12 * 16384 * 10000 bytes, and (147 + 16) * 2^20 + 12 * 2^22."""
    Image.new("1", (16384, 10000)).save(tmp_path / "a.png")
    small["mesh"] |= dict.fromkeys(("texture", "normal_map", "specular_map"), str(tmp_path / "a.png"))
    assert problems(small) == [
        "scene: mesh.texture: expected at most 4 GiB of buffers and textures, "
        "got 5.70 GiB, 1.83 GiB of them here; scale the picture down"
    ]


def test_too_much_is_told_with_all_other_problems(small):
    lines = problems(small, **{"camera.width": 16384, "camera.height": 16384, "phong.shininess": 0})
    assert [line.split(": expected")[0] for line in lines] == ["override: phong.shininess", "override: camera"]
