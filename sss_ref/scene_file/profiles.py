"""Sums of Gaussians that say how much light comes through a thickness of a material, and what they are fitted to.

A row is (variance, red, green, blue): mm^2, and the weight for each channel.
"""

from typing import Literal, NamedTuple

Gaussian = tuple[float, float, float, float]
Channels = tuple[float, float, float]
MaterialName = Literal["skin", "marble", "milk", "wax", "jade", "enamel", "dentine"]

# Three-layer skin: d'Eon, Luebke and Enderton, "Efficient Rendering of Human Skin" (EGSR 2007); in GPU Gems 3, chapter
# 14, with these figures. The weights of each channel sum to 1: all light that enters leaves again.
SKIN: tuple[Gaussian, ...] = (
    (0.0064, 0.233, 0.455, 0.649),
    (0.0484, 0.100, 0.336, 0.344),
    (0.187, 0.118, 0.198, 0.000),
    (0.567, 0.113, 0.007, 0.007),
    (1.99, 0.358, 0.004, 0.000),
    (7.41, 0.078, 0.000, 0.000),
)


class Medium(NamedTuple):
    """What light meets in a material."""

    scattering: Channels  # reduced, per mm
    absorption: Channels  # per mm
    ior: float  # index of refraction


# Measured: Jensen et al., "A Practical Model for Subsurface Light Transport" (2001), table 1; milk is their whole milk.
# Enamel's red scattering: Zijp, ten Bosch and Groenhuis (1995), s = 6.6 per mm with g = .68 at 633 nm.
# All else is chosen by eye: an absorption that gives the colour, and as much scattering as lets it shine.
MEDIA: dict[MaterialName, Medium] = {
    "marble": Medium((2.19, 2.62, 3.00), (0.0021, 0.0041, 0.0071), 1.5),
    "milk": Medium((2.55, 3.21, 3.77), (0.0011, 0.0024, 0.014), 1.3),
    "wax": Medium((2.0, 2.2, 2.4), (0.0012, 0.0076, 0.064), 1.4),
    "jade": Medium((1.2, 1.2, 1.2), (0.1, 0.0126, 0.058), 1.6),
    "enamel": Medium((2.1, 2.6, 3.2), (0.0017, 0.0031, 0.0078), 1.62),
    "dentine": Medium((2.0, 2.2, 2.4), (0.005, 0.021, 0.105), 1.54),
}

# How much of the light comes through a slab of each, by the diffusion approximation (rules, Materials):
# data/generate/transmittances.py fits the rows.
PROFILES: dict[MaterialName, tuple[Gaussian, ...]] = {
    "skin": SKIN,
    "marble": (
        (0.5125, 0.0775, 0.0884, 0.1019),
        (1.479, 0.0691, 0.0814, 0.0847),
        (4.268, 0.1075, 0.1091, 0.1201),
        (12.32, 0.1019, 0.1093, 0.1085),
        (35.54, 0.0978, 0.0960, 0.1077),
        (102.6, 0.0808, 0.0864, 0.0592),
        (296, 0.0656, 0.0294, 0.0052),
        (854.1, 0.0160, 0.0006, 0.0000),
    ),
    "milk": (
        (0.3903, 0.1115, 0.1256, 0.1408),
        (1.225, 0.1108, 0.1194, 0.1296),
        (3.844, 0.1291, 0.1216, 0.1288),
        (12.07, 0.1054, 0.1011, 0.1193),
        (37.87, 0.0826, 0.0720, 0.0703),
        (118.9, 0.0567, 0.0617, 0.0059),
        (373, 0.0461, 0.0234, 0.0000),
        (1171, 0.0150, 0.0005, 0.0000),
    ),
    "wax": (
        (0.5125, 0.0889, 0.1030, 0.1572),
        (1.618, 0.0886, 0.0963, 0.1537),
        (5.11, 0.1235, 0.1394, 0.2015),
        (16.14, 0.1092, 0.1212, 0.0871),
        (50.96, 0.0956, 0.1234, 0.0038),
        (160.9, 0.0688, 0.0501, 0.0000),
        (508.2, 0.0571, 0.0015, 0.0000),
        (1605, 0.0135, 0.0001, 0.0000),
    ),
    "jade": (
        (0.3903, 0.1029, 0.0417, 0.0787),
        (1.023, 0.1105, 0.0399, 0.0776),
        (2.681, 0.1665, 0.0761, 0.1379),
        (7.027, 0.1745, 0.0983, 0.1626),
        (18.42, 0.0920, 0.1312, 0.1460),
        (48.28, 0.0086, 0.1398, 0.0450),
        (126.5, 0.0000, 0.0930, 0.0008),
        (331.6, 0.0000, 0.0144, 0.0001),
    ),
    "enamel": (
        (0.5125, 0.0605, 0.0707, 0.0915),
        (1.547, 0.0609, 0.0762, 0.0838),
        (4.67, 0.1000, 0.1027, 0.1240),
        (14.1, 0.1019, 0.1124, 0.1170),
        (42.56, 0.1039, 0.0989, 0.1134),
        (128.5, 0.0865, 0.0922, 0.0377),
        (387.8, 0.0709, 0.0314, 0.0002),
        (1171, 0.0147, 0.0006, 0.0001),
    ),
    "dentine": (
        (0.3903, 0.0563, 0.0774, 0.1413),
        (1.119, 0.0647, 0.0813, 0.1516),
        (3.211, 0.0952, 0.1307, 0.1873),
        (9.208, 0.1124, 0.1450, 0.0913),
        (26.41, 0.1124, 0.1355, 0.0063),
        (75.75, 0.1108, 0.0400, 0.0000),
        (217.3, 0.0620, 0.0000, 0.0000),
        (623.1, 0.0055, 0.0002, 0.0000),
    ),
}
