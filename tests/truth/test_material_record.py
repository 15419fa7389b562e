"""Records of other formats, with values worked out by hand."""

import json
import math

import pytest

from sss_ref.errors import SceneError
from sss_ref.truth.chandrasekhar import diffuse_half_space_reflectance
from sss_ref.truth.material_record import volumes_of, volumes_of_gltf, volumes_of_openpbr
from sss_ref.truth.photon import Volume

GLTF = {
    "KHR_materials_volume": {
        "attenuationColor": [math.exp(-1), math.exp(-2), math.exp(-4)],
        "attenuationDistance": 0.002,
    },
    "KHR_materials_scatter": {"multiscatterColor": [1.0, 0.5, 0.0], "scatterAnisotropy": 0.0},
    "KHR_materials_ior": {"ior": 1.4},
}
OPENPBR = {"subsurface_color": [0.9, 0.5, 0.0], "subsurface_radius": 2.0, "subsurface_radius_scale": [1.0, 0.5, 0.25]}


def test_a_gltf_material_has_its_extinction_per_metre():
    red, green, blue = volumes_of_gltf(GLTF)
    assert [v.scattering + v.absorption for v in (red, green, blue)] == pytest.approx([0.5, 1.0, 2.0], rel=1e-12)
    bent = 4.09712 + 4.20863 * 0.5 - math.sqrt(9.59217 + 41.6808 * 0.5 + 17.7126 * 0.25)
    assert green.absorption == pytest.approx(bent**2, rel=1e-12) and green.ior == 1.4
    assert red.absorption == pytest.approx(0.0, abs=1e-5) and red.absorption > 0  # or a walk had no end
    assert blue.scattering == pytest.approx(0.0, abs=2e-5)  # the formula gives an albedo of 6e-6 for black


def test_the_draft_extension_means_the_same():
    draft = {**GLTF, "KHR_materials_volume_scatter": GLTF["KHR_materials_scatter"]}
    del draft["KHR_materials_scatter"]
    assert volumes_of_gltf(draft) == volumes_of_gltf(GLTF)


def test_openpbrs_radius_is_a_mean_free_path_in_scene_units():
    red, green, blue = volumes_of_openpbr(OPENPBR, mm_per_unit=10.0)
    assert [v.scattering + v.absorption for v in (red, green, blue)] == pytest.approx(
        [1 / 20, 1 / 10, 1 / 5], rel=1e-12
    )
    for volume, color in ((red, 0.9), (green, 0.5)):
        s = math.sqrt(volume.absorption / (volume.scattering + volume.absorption))
        assert (1 - s) * (1 - 0.139 * s) / (1 + 1.17 * s) == pytest.approx(color, rel=1e-12)
    assert blue.scattering == 0 and red.ior == 1.5


@pytest.mark.parametrize("color", [0.3, 0.6, 0.9])
def test_the_colour_is_that_of_a_half_space_lit_from_all_sides(color):
    """Both formats' relations are fits of the same reflectance, without a border: within .002 of Chandrasekhar's."""
    pbr = volumes_of_openpbr({**OPENPBR, "subsurface_color": [color] * 3})[0]
    gltf = volumes_of_gltf({**GLTF, "KHR_materials_scatter": {"multiscatterColor": [color] * 3}})[0]
    for volume in (pbr, gltf):
        albedo = volume.scattering / (volume.scattering + volume.absorption)
        assert diffuse_half_space_reflectance(albedo) == pytest.approx(color, abs=0.002)


def test_an_anisotropic_medium_is_similar_to_the_isotropic_one():
    one, other = (volumes_of_openpbr({**OPENPBR, "subsurface_scatter_anisotropy": g})[1] for g in (0.0, 0.6))
    reduced = other.scattering * 0.4
    albedo = one.scattering / (one.scattering + one.absorption)
    assert reduced / (reduced + other.absorption) == pytest.approx(albedo, rel=1e-12)


def test_files_and_names(tmp_path):
    path = tmp_path / "wax.json"
    path.write_text(json.dumps({"name": "wax", "extensions": GLTF}))
    assert volumes_of(str(path)) == volumes_of_gltf(GLTF)
    path.write_text(json.dumps(OPENPBR))
    assert volumes_of(str(path), ior=1.0, mm_per_unit=10.0)[0] == volumes_of_openpbr(OPENPBR, 10.0)[0]._replace(ior=1.0)
    assert volumes_of("skin1")[0] == Volume(0.74, 0.032, 0.0, 1.3)


@pytest.mark.parametrize(
    ("content", "line"),
    [
        ("{", "expected a material record, got something else"),
        ("[]", "expected a material record, got something else"),
        ('{"extensions": {}}', "expected KHR_materials_scatter and KHR_materials_volume, got none"),
        (
            json.dumps({"extensions": {**GLTF, "KHR_materials_volume": {}}}),
            "expected attenuation in all channels, got none",
        ),
        (json.dumps({**OPENPBR, "subsurface_radius": 0}), "subsurface_radius: expected more than 0 in all channels"),
        (
            json.dumps({**OPENPBR, "subsurface_color": [2, 0, 0]}),
            r"subsurface_color: expected three numbers from 0 to 1, got \[",
        ),
        (json.dumps({**OPENPBR, "specular_ior": "x"}), 'specular_ior: expected a number of at most 1e\\+30, got "x"'),
        (json.dumps({**OPENPBR, "specular_ior": 10**400}), "specular_ior: expected a number of at most"),
        (json.dumps({**OPENPBR, "specular_ior": float("nan")}), "specular_ior: expected a number of at most"),
        (json.dumps({**OPENPBR, "subsurface_scatter_anisotropy": 1}), "anisotropy: expected a number between -1 and 1"),
        (json.dumps({**OPENPBR, "subsurface_radius": 1e-320}), "expected light that goes some way inside, got none"),
        (
            json.dumps({"extensions": {**GLTF, "KHR_materials_ior": "ior"}}),
            'KHR_materials_ior: expected an object, got "ior"',
        ),
        ("[" * 100_000, "expected a material record, got something else"),
    ],
)
def test_what_is_no_record_is_refused(tmp_path, content, line):
    path = tmp_path / "material.json"
    path.write_text(content)
    with pytest.raises(SceneError, match=line):
        volumes_of(str(path))


def changed(table, **values):
    """GLTF with other values in one of its tables."""
    return {**GLTF, table: {**GLTF[table], **values}}


def test_what_a_gltf_material_leaves_out():
    """Black, and the usual index of refraction; the draft's name comes second."""
    bare = {key: value for key, value in GLTF.items() if key != "KHR_materials_ior"} | {"KHR_materials_scatter": {}}
    found = volumes_of_gltf(bare)
    assert all(volume.ior == 1.5 and volume.anisotropy == 0 for volume in found)
    assert [v.scattering for v in found] == pytest.approx([0, 0, 0], abs=1e-4)
    assert volumes_of_gltf({**GLTF, "KHR_materials_volume_scatter": {}}) == volumes_of_gltf(GLTF)


def test_what_openpbr_leaves_out():
    """Its own defaults: .8 of white, (1, .5, .25) of a length of 1."""
    red, green, blue = volumes_of_openpbr({})
    lengths = [1 / (v.scattering + v.absorption) for v in (red, green, blue)]
    assert lengths == pytest.approx([1, 0.5, 0.25], rel=1e-12) and (red.ior, red.anisotropy) == (1.5, 0)
    assert [v.absorption * length for v, length in zip((red, green, blue), lengths, strict=True)] == pytest.approx(
        [volumes_of_openpbr({"subsurface_color": [0.8] * 3})[0].absorption] * 3, rel=1e-12
    )


def test_what_scatters_forward_by_the_formula():
    """albedo = (1 - s^2) / (1 - g s^2) in both formats."""
    one, other = (volumes_of_gltf(changed("KHR_materials_scatter", scatterAnisotropy=g))[1] for g in (0.0, 0.5))
    square = one.absorption / (one.absorption + one.scattering)
    assert other.scattering / (other.absorption + other.scattering) == pytest.approx(
        (1 - square) / (1 - 0.5 * square), rel=1e-12
    )
    assert other.anisotropy == 0.5


@pytest.mark.parametrize("lightest", [1.0, 0.9999999])
def test_the_whitest_body_absorbs_a_millionth(lightest):
    volume = volumes_of_openpbr({"subsurface_color": [lightest] * 3})[0]
    assert volume.absorption / (volume.scattering + volume.absorption) == pytest.approx(1e-6, rel=1e-9)


@pytest.mark.parametrize("color", [[0, 0, 0], [1, 1, 1]])
@pytest.mark.parametrize("distance", [0.002, 0.0, -1.0])
def test_light_that_is_not_dimmed_is_refused(color, distance):
    """As is what is dimmed at once, or backwards."""
    with pytest.raises(SceneError) as error:
        volumes_of_gltf(changed("KHR_materials_volume", attenuationColor=color, attenuationDistance=distance))
    assert str(error.value) == (
        "material: expected attenuation in all channels, got none; give attenuationColor and attenuationDistance"
    )


@pytest.mark.parametrize("distance", [0.0, -0.002])
def test_a_length_of_nothing_is_refused(distance):
    with pytest.raises(SceneError, match="expected attenuation in all channels, got none"):
        volumes_of_gltf(changed("KHR_materials_volume", attenuationDistance=distance))


@pytest.mark.parametrize("g", [-0.99, 0.99])
def test_how_far_light_may_be_scattered_forward_and_back(g):
    assert volumes_of_openpbr({"subsurface_scatter_anisotropy": g})[0].anisotropy == g


@pytest.mark.parametrize(
    ("record", "line"),
    [
        ({"subsurface_scatter_anisotropy": -1}, "anisotropy: expected a number between -1 and 1, got -1.0; correct it"),
        ({"specular_ior": True}, "specular_ior: expected a number of at most 1e+30, got true; correct it"),
        ({"specular_ior": -2e30}, "specular_ior: expected a number of at most 1e+30, got -2e+30; correct it"),
        (
            {"subsurface_color": [0.5, 0.5]},
            "subsurface_color: expected three numbers from 0 to 1, got [0.5,0.5]; correct it",
        ),
        (
            {"subsurface_color": [True, 0, 0]},
            "subsurface_color: expected three numbers from 0 to 1, got [true,0,0]; correct it",
        ),
        (
            {"subsurface_color": [0.5, -0.1, 0]},
            "subsurface_color: expected three numbers from 0 to 1, got [0.5,-0.1,0]; correct it",
        ),
        (
            {"subsurface_radius_scale": [1, 0, 1]},
            "subsurface_radius: expected more than 0 in all channels, got none; enlarge it",
        ),
    ],
    ids=str,
)
def test_numbers_that_mean_nothing_are_refused(record, line):
    with pytest.raises(SceneError) as error:
        volumes_of_openpbr(record)
    assert str(error.value).replace(", ", ",").endswith(line.replace(", ", ","))


def test_the_largest_number_is_taken():
    assert volumes_of_openpbr({"specular_ior": 1e30})[0].ior == 1e30
