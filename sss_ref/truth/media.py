"""Materials by name, as a walk takes them: one `Volume` for each of red, green and blue."""

from sss_ref.errors import SceneError
from sss_ref.errors.wording import nearest, told
from sss_ref.scene_file.profiles import MEDIA, Medium
from sss_ref.truth.photon import Volume

Volumes = tuple[Volume, Volume, Volume]

# Skin as it was measured: Jensen et al., "A Practical Model for Subsurface Light Transport" (2001), table 1.
MEASURED_SKIN = {
    "skin1": Medium((0.74, 0.88, 1.01), (0.032, 0.17, 0.48), 1.3),
    "skin2": Medium((1.09, 1.59, 1.79), (0.013, 0.070, 0.145), 1.3),
}
NAMED: dict[str, Medium] = {**MEASURED_SKIN, **{str(name): medium for name, medium in MEDIA.items()}}


def volumes(name: str, ior: float | None = None, where: str = "material") -> Volumes:
    """The volumes (red, green, blue) of the material `name`, with its own index of refraction or another one, `ior`.

    where: what gave the name. Raises SceneError for what is none. Scattering is reduced, so anisotropy is 0. The
    material `skin` of a scene is a sum of Gaussians that no coefficients stand behind: skin1 and skin2 are measured.
    """
    if name not in NAMED:
        raise SceneError(told(where, "the name of a medium", repr(name), nearest(name, NAMED)))
    scattering, absorption, own_ior = NAMED[name]
    border = own_ior if ior is None else ior
    red, green, blue = (Volume(s, a, 0.0, border) for s, a in zip(scattering, absorption, strict=True))
    return red, green, blue
