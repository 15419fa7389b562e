"""`sss-ref fit`: the numbers of a scene file that come nearest to a material's truth."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter
from rich.markup import escape

from sss_ref.cli.console import err, out, progress
from sss_ref.errors import SceneError

if TYPE_CHECKING:
    from sss_ref.truth.kernel_fit import KernelFit
    from sss_ref.truth.media import Volumes
    from sss_ref.truth.searchlight import RadialProfile
    from sss_ref.truth.transmittance_fit import TransmittanceFit

COLORS = ("red", "green", "blue")
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
    mm_per_unit: Annotated[float, Parameter(help="Of the scene that the numbers are for.")] = 1.0,
    photons: Annotated[int, Parameter(help="Of each walk.")] = 200_000,
    threads: Annotated[int | None, Parameter(show_default=False, help="One per processor if not given.")] = None,
) -> int:
    """Walk through a material and print the kernel and the translucency that come nearest to it, and how far off."""
    from sss_ref.truth.kernel_fit import fitted_kernel
    from sss_ref.truth.searchlight import searchlight
    from sss_ref.truth.transmittance_fit import fitted_transmittance

    _check(photons, threads, mm_per_unit)
    found = _volumes(material, scattering, absorption, anisotropy, ior, mm_per_unit)
    with progress("walking") as show:
        profiles, laws = [], []
        for color, volume in zip(COLORS, found, strict=True):
            show(f"walking: {color}")
            profiles.append(searchlight(volume, photons, threads=threads))
            laws.append(fitted_transmittance(volume, photons, threads))
        show("fitting the kernel")
        kernel = fitted_kernel(profiles)
    err.print(escape("\n".join(_said(profiles, kernel, laws))))
    out.print(escape("\n".join(_toml(profiles, kernel, laws, mm_per_unit))))
    return 0


def _check(photons: int, threads: int | None, mm_per_unit: float) -> None:
    if photons < 1000:
        raise SceneError(f"--photons: expected at least 1000, got {photons}; 200000 are known to 1 %")
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


def _said(profiles: Sequence["RadialProfile"], kernel: "KernelFit", laws: Sequence["TransmittanceFit"]) -> list[str]:
    """How far off the fits stay, one line for each channel and thing."""
    lines = [f"kernel: of a disc of {kernel.disc:.2f} mm, lit on the surface, so much comes to lie at a wrong radius"]
    for k, color in enumerate(COLORS):
        own = f"hbh09's own weights: {kernel.published_misplaced[k]:.1%}, at their best {kernel.published_mm[k]:.2f} mm"
        lines.append(f"  {color:5} {kernel.misplaced[k]:.1%} ({own} an offset)")
    lines.append("translucency: the largest deviation from the light that comes through slabs")
    for color, law in zip(COLORS, laws, strict=True):
        ways = f"{law.worst:.0%} by the power law, {law.fading_worst:.0%} by e^(-{law.fading:.3g}*d)"
        lines.append(f"  {color:5} {ways}; it falls as d^-0.6 at {law.paper_at:.2f} mm")
    worst = max(profile.reflectance_error / max(profile.reflectance, 1e-9) for profile in profiles)
    return [*lines, f"reflectances are known to {worst:.1%} (a standard error)"]


def _toml(
    profiles: Sequence["RadialProfile"],
    kernel: "KernelFit",
    laws: Sequence["TransmittanceFit"],
    mm_per_unit: float,
) -> list[str]:
    """A scene file's keys. T holds the colour already, so scale is 1/color: the surface multiplies by it again."""
    from sss_ref.truth.transmittance_fit import BASE

    colors = [profile.reflectance for profile in profiles]
    powers = [law.y(mm_per_unit) for law in laws]
    bare = [law.amplitude / max(color, 1e-9) for law, color in zip(laws, colors, strict=True)]
    return [
        f"mm_per_unit = {mm_per_unit:g}",
        "[mesh]",
        f"color = {_row(colors)}",
        "[blur]",
        'unit = "mm"',
        f"mm_per_offset = {kernel.mm_per_offset:.4g}",
        "kernel = [",
        *(f"  {_row(tap, 6)}," for tap in kernel.taps),
        "]",
        "[translucency]",
        'form = "ratio"',
        f"x = {BASE}",
        f"y = {_row(powers)}",
        f"exponent = {_row([law.exponent for law in laws])}",
        f"d_min = {_row([law.d_min / mm_per_unit for law in laws])}",
        f"scale = {_row([1 / max(color, 1e-9) for color in colors])}",
        f'# or form = "beer", x = {_row([law.fading * mm_per_unit for law in laws])}, scale = {_row(bare)}',
    ]


def _row(values: Sequence[float], digits: int = 4) -> str:
    return "[" + ", ".join(f"{value:.{digits}g}" for value in map(float, values)) + "]"
