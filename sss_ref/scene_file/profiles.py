"""Sums of Gaussians that say how far light scatters in a material.

A row is (variance, red, green, blue): mm^2, and the weight for each channel.
"""

Gaussian = tuple[float, float, float, float]

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

PROFILES = {"skin": SKIN}
