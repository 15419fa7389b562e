"""What a material is made of, from its name, from a glTF material or from OpenPBR's parameters in a JSON file."""

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sss_ref.errors import SceneError
from sss_ref.errors.text_file import text_of
from sss_ref.errors.wording import shown, told
from sss_ref.truth.media import Volumes, volumes
from sss_ref.truth.photon import Volume

SCATTERING = ("KHR_materials_scatter", "KHR_materials_volume_scatter")  # drafts of one extension
MM_PER_METRE = 1000.0  # glTF's unit of length
USUAL_IOR = 1.5  # of both formats
LARGEST = 1e30  # of a number in a record: no product of two overflows
LIGHTEST = 1e-6  # the least absorption, as a share of the extinction: at albedo 1 walks have no end
Channels = tuple[float, float, float]


def volumes_of(material: str, ior: float | None = None, mm_per_unit: float = 1.0) -> Volumes:
    """The volumes of a material: a name as `media.volumes` has them, or a .json file with a record.

    ior: another index of refraction. mm_per_unit: of OpenPBR's radius, in scene units. Raises SceneError for neither.
    """
    if not material.endswith(".json"):
        return volumes(material, ior)
    try:
        record = json.loads(text_of(Path(material), "a material", SceneError))
    except (ValueError, RecursionError):
        record = None
    if isinstance(record, dict) and isinstance(record.get("extensions"), dict):
        return _bordered(volumes_of_gltf(record["extensions"], material), ior)
    if isinstance(record, dict) and "subsurface_color" in record:
        return _bordered(volumes_of_openpbr(record, mm_per_unit, material), ior)
    remedy = "give a material of a glTF file, or OpenPBR's subsurface_color, subsurface_radius and so on"
    raise SceneError(told(material, "a material record", "something else", remedy))


def volumes_of_gltf(extensions: Mapping[str, Any], where: str = "material") -> Volumes:
    """KHR_materials_scatter (or its draft _volume_scatter) with KHR_materials_volume, lengths in metres.

    The extinction is -ln(attenuationColor)/attenuationDistance; the albedo is that of `multiscatterColor` by Kulla and
    Conty (2017), as the extension says: 1 - (4.09712 + 4.20863*c - sqrt(9.59217 + 41.6808*c + 17.7126*c^2))^2, for an
    anisotropy by similarity. Raises SceneError for values that give no medium.
    """
    scatter = next((extensions[name] for name in SCATTERING if name in extensions), None)
    volume = extensions.get("KHR_materials_volume")
    if not isinstance(scatter, Mapping) or not isinstance(volume, Mapping):
        came = ", ".join(map(str, extensions)) or "none"
        raise SceneError(told(where, "KHR_materials_scatter and KHR_materials_volume", came, "add what is missing"))
    color = _channels(scatter, "multiscatterColor", (0.0, 0.0, 0.0), where)
    dimmed = _channels(volume, "attenuationColor", (1.0, 1.0, 1.0), where)
    distance = _number(volume, "attenuationDistance", math.inf, where) * MM_PER_METRE
    anisotropy = _anisotropy(scatter, "scatterAnisotropy", where)
    border = extensions.get("KHR_materials_ior", {})
    if not isinstance(border, Mapping):
        raise SceneError(told(f"{where}: KHR_materials_ior", "an object", shown(border), "correct it"))
    ior = _number(border, "ior", USUAL_IOR, where)
    extinctions = [-math.log(each) / distance if 0 < each < 1 and distance > 0 else 0.0 for each in dimmed]
    if not all(extinctions):
        raise SceneError(
            told(where, "attenuation in all channels", "none", "give attenuationColor and attenuationDistance")
        )
    bent = [4.09712 + 4.20863 * c - math.sqrt(9.59217 + 41.6808 * c + 17.7126 * c * c) for c in color]
    return _volumes(extinctions, bent, anisotropy, ior, where)


def volumes_of_openpbr(record: Mapping[str, Any], mm_per_unit: float = 1.0, where: str = "material") -> Volumes:
    """OpenPBR's subsurface: the mean free path is subsurface_radius * subsurface_radius_scale, in scene units.

    The albedo is the one whose half-space has the reflectance C = `subsurface_color` by the specification's relation,
    C = (1 - s)*(1 - 0.139*s)/(1 + 1.17*s), s = sqrt((1 - albedo)/(1 - g*albedo)). Raises SceneError as for glTF.
    """
    color = _channels(record, "subsurface_color", (0.8, 0.8, 0.8), where)
    scale = _channels(record, "subsurface_radius_scale", (1.0, 0.5, 0.25), where)
    radius = _number(record, "subsurface_radius", 1.0, where)
    anisotropy = _anisotropy(record, "subsurface_scatter_anisotropy", where)
    ior = _number(record, "specular_ior", USUAL_IOR, where)
    lengths = [radius * each * mm_per_unit for each in scale]
    if not min(lengths) > 0:
        raise SceneError(told(f"{where}: subsurface_radius", "more than 0 in all channels", "none", "enlarge it"))
    return _volumes([1 / length for length in lengths], [_bent(c) for c in color], anisotropy, ior, where)


def _bent(color: float) -> float:
    """s of a reflectance: the smaller root of 0.139*s^2 - (1.139 + 1.17*C)*s + 1 - C = 0."""
    half = 1.139 + 1.17 * color
    return 2 * (1 - color) / (half + math.sqrt(half * half - 4 * 0.139 * (1 - color)))


def _volumes(extinctions: list[float], bent: list[float], anisotropy: float, ior: float, where: str) -> Volumes:
    """From s = sqrt((1 - albedo)/(1 - g*albedo)): the albedo is (1 - s^2)/(1 - g*s^2)."""
    if math.inf in extinctions:
        raise SceneError(told(where, "light that goes some way inside", "none", "enlarge the distance or radius"))
    albedos = [max(0.0, (1 - s * s) / (1 - anisotropy * s * s)) for s in bent]
    absorbed = [extinction * max(1 - albedo, LIGHTEST) for extinction, albedo in zip(extinctions, albedos, strict=True)]
    red, green, blue = (
        Volume(extinction - each, each, anisotropy, ior) for extinction, each in zip(extinctions, absorbed, strict=True)
    )
    return red, green, blue


def _bordered(found: Volumes, ior: float | None) -> Volumes:
    red, green, blue = found if ior is None else tuple(volume._replace(ior=ior) for volume in found)
    return red, green, blue


def _channels(table: Mapping[str, Any], key: str, default: Channels, where: str) -> Channels:
    value = table.get(key, default)
    if isinstance(value, list | tuple) and len(value) == 3 and all(_is_share(each) for each in value):
        return float(value[0]), float(value[1]), float(value[2])
    raise SceneError(told(f"{where}: {key}", "three numbers from 0 to 1", shown(value), "correct it"))


def _is_share(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value <= 1


def _anisotropy(table: Mapping[str, Any], key: str, where: str) -> float:
    value = _number(table, key, 0.0, where)
    if not -1 < value < 1:
        raise SceneError(told(f"{where}: {key}", "a number between -1 and 1", shown(value), "correct it"))
    return value


def _number(table: Mapping[str, Any], key: str, default: float, where: str) -> float:
    if key not in table:
        return default
    value = table[key]
    if isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= LARGEST:
        return float(value)
    raise SceneError(told(f"{where}: {key}", f"a number of at most {LARGEST:g}", shown(value), "correct it"))
