"""`sss-ref fit`: the numbers of a scene file that come nearest to a material's truth."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter
from rich.markup import escape

from sss_ref.cli.console import err, out, progress
from sss_ref.cli.options import Threads
from sss_ref.errors import SceneError

if TYPE_CHECKING:
    from sss_ref.truth.material_fit import MaterialFit
    from sss_ref.truth.media import Volumes

Channels = tuple[float, float, float]
PER_MM = Parameter(show_default=False, help="Per mm, of red, green and blue, instead of a material; reduced if g is 0.")


def fit(
    material: Annotated[
        str | None, Parameter(show_default=False, help="A medium's name, or a .json file: a glTF or OpenPBR material.")
    ] = None,
    *,
    scattering: Annotated[Channels | None, PER_MM] = None,
    absorption: Annotated[Channels | None, PER_MM] = None,
    anisotropy: Annotated[float, Parameter(help="g of Henyey and Greenstein, of such numbers.")] = 0.0,
    ior: Annotated[float | None, Parameter(show_default=False, help="Index of refraction; 1: no border.")] = None,
    lit: Annotated[
        Literal["straight_down", "all_sides"],
        Parameter(help="How light enters the half-space; all_sides is what `measure` holds techniques against."),
    ] = "straight_down",
    mm_per_unit: Annotated[float, Parameter(help="Of the scene that the numbers are for.")] = 1.0,
    photons: Annotated[int, Parameter(help="Of each walk.")] = 200_000,
    threads: Threads = None,
) -> int:
    """Walk through a material and print the kernel and the translucency that come nearest to it, and how far off."""
    from sss_ref.truth.material_fit import fitted_material

    check_walks(photons)
    _check(threads, mm_per_unit)
    found = _volumes(material, scattering, absorption, anisotropy, ior, mm_per_unit)
    with progress("walking") as show:
        fitted = fitted_material(found, photons, threads, lit == "all_sides", show)
    err.print(escape("\n".join(_said(fitted))))
    out.print(escape("\n".join(_toml(fitted, mm_per_unit))))
    return 0


def check_walks(photons: int) -> None:
    """Raise SceneError for fewer photons than tell anything."""
    if photons < 1000:
        raise SceneError(f"--photons: expected at least 1000, got {photons}; 200000 are known to 1 %")


def _check(threads: int | None, mm_per_unit: float) -> None:
    if threads is not None and threads < 1:
        raise SceneError(f"--threads: expected at least 1, got {threads}; leave it out for one per processor")
    if not mm_per_unit > 0:
        raise SceneError(f"--mm-per-unit: expected more than 0, got {mm_per_unit:g}; say how many mm a unit is")


def _volumes(
    material: str | None,
    scattering: Channels | None,
    absorption: Channels | None,
    anisotropy: float,
    ior: float | None,
    mm_per_unit: float,
) -> "Volumes":
    """What is walked: a material, or numbers."""
    from sss_ref.truth.material_record import volumes_of
    from sss_ref.truth.photon import Volume

    if material is not None and scattering is None and absorption is None:
        return volumes_of(material, ior, mm_per_unit)
    if material is not None or scattering is None or absorption is None:
        raise SceneError("fit: expected a material, or --scattering and --absorption, got something else; try skin1")
    border = 1.0 if ior is None else ior
    red, green, blue = (Volume(s, a, anisotropy, border) for s, a in zip(scattering, absorption, strict=True))
    return red, green, blue


def _said(fitted: "MaterialFit") -> list[str]:
    """How far off the fits stay, one line for each channel and thing."""
    from sss_ref.truth.material_fit import COLORS

    kernel, by_color = fitted.kernel, dict(zip(COLORS, range(3), strict=True))
    lines = [f"kernel: of a disc of {kernel.disc:.2f} mm, lit on the surface, so much comes to lie at a wrong radius"]
    for color, k in by_color.items():
        own = f"hbh09's own weights: {kernel.published_misplaced[k]:.1%}, at their best {kernel.published_mm[k]:.2f} mm"
        lines.append(f"  {color:5} {kernel.misplaced[k]:.1%} ({own} an offset)")
    lines.append("six Gaussians: of a beam's light so much comes to lie at a wrong radius")
    lines += [f"  {color:5} {fitted.gaussians.misplaced[k]:.1%}" for color, k in by_color.items()]
    lines.append("translucency: the largest deviation from the light that comes through slabs")
    for color, law in zip(COLORS, fitted.laws, strict=True):
        ways = f"{law.worst:.0%} by the power law, {law.fading_worst:.0%} by e^(-{law.fading:.3g}*d)"
        lines.append(f"  {color:5} {ways}; it falls as d^-0.6 at {law.paper_at:.2f} mm")
    worst = max(profile.reflectance_error / max(profile.reflectance, 1e-9) for profile in fitted.profiles)
    return [*lines, f"reflectances are known to {worst:.1%} (a standard error)"]


def _toml(fitted: "MaterialFit", mm_per_unit: float) -> list[str]:
    """A scene file's keys, and the other form of T as a comment."""
    lines: list[str] = []
    for key, value in fitted.keys(mm_per_unit).items():
        lines += _table(key, value) if isinstance(value, dict) else [f"{key} = {_written(value)}"]
        if key == "translucency":
            other = fitted.fading_law(mm_per_unit)
            lines.append("# or " + "; ".join(f"{name} = {_written(value)}" for name, value in other.items()))
    return lines


def _table(name: str, keys: dict[str, Any]) -> list[str]:
    lines = [f"[{name}]"]
    for key, value in keys.items():
        lines += _rows(key, value) if key in ("kernel", "profile") else [f"{key} = {_written(value)}"]
    return lines


def _rows(key: str, rows: Sequence[Sequence[float]]) -> list[str]:
    return [f"{key} = [", *(f"  {_written(row, 6)}," for row in rows), "]"]


def _written(value: Any, digits: int = 4) -> str:
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, float | int):
        return f"{float(value):.{digits}g}"
    return "[" + ", ".join(f"{float(each):.{digits}g}" for each in value) + "]"
