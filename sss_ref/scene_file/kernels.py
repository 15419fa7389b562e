"""The thirteen-tap skin blurs as published: rows (X, Y, red, green, blue), X and Y in pixels or texels.

None of them is centred or a true Gaussian, and only the second one sums to about 1: that is how they were printed.
"""

Tap = tuple[float, float, float, float, float]

# The table of the paper (3.2), digit for digit; its channels sum to .9977, 1.0494 and .9996.
TABLE1: tuple[Tap, ...] = (
    (0.0000, 0.0000, 0.2204, 0.4870, 0.6350),
    (1.6339, 0.0367, 0.0763, 0.0644, 0.0390),
    (0.1778, 1.7175, 0.1165, 0.1032, 0.0649),
    (-0.1949, 0.0910, 0.0648, 0.0863, 0.0622),
    (-0.2397, -0.2202, 0.1317, 0.1516, 0.1036),
    (-0.0035, -0.1182, 0.0256, 0.0427, 0.0330),
    (1.3201, -0.1815, 0.0485, 0.0647, 0.0461),
    (5.9706, 0.2533, 0.0480, 0.0030, 0.0004),
    (-1.0892, 4.9583, 0.0488, 0.0054, 0.0012),
    (-4.0154, 4.1566, 0.0513, 0.0060, 0.0014),
    (-4.0630, -4.1101, 0.0614, 0.0091, 0.0025),
    (-0.6386, -6.2976, 0.0309, 0.0028, 0.0006),
    (2.5423, -3.2459, 0.0735, 0.0232, 0.0097),
)

# Hable, Borshukov and Hejl, "Fast Skin Shading" (ShaderX7, 2009): the kernel the paper took over.
HBH09: tuple[Tap, ...] = (
    (0.000000, 0.000000, 0.220441, 0.437000, 0.635000),
    (1.633992, 0.036795, 0.076356, 0.064487, 0.039097),
    (0.177801, 1.717593, 0.116515, 0.103222, 0.064912),
    (-0.194906, 0.091094, 0.064844, 0.086388, 0.062272),
    (-0.239737, -0.220217, 0.131798, 0.151695, 0.103676),
    (-0.003530, -0.118219, 0.025690, 0.042728, 0.033003),
    (1.320107, -0.181542, 0.048593, 0.064740, 0.046131),
    (5.970690, 0.253378, 0.048092, 0.003042, 0.000400),
    (-1.089250, 4.958349, 0.048845, 0.005406, 0.001222),
    (-4.015465, 4.156699, 0.051322, 0.006034, 0.001420),
    (-4.063099, -4.110150, 0.061428, 0.009152, 0.002511),
    (-0.638605, -6.297663, 0.030936, 0.002868, 0.000652),
    (2.542348, -3.245901, 0.073580, 0.023239, 0.009703),
)

# What the printed figures used: the original with the green centre misread, which brightens green by 4.9 %.
SCHOENBERGER: tuple[Tap, ...] = ((0.000000, 0.000000, 0.220441, 0.487000, 0.635000), *HBH09[1:])

KERNELS = {"table1": TABLE1, "hbh09": HBH09, "schoenberger": SCHOENBERGER}


def channel_sums(taps: tuple[Tap, ...]) -> tuple[float, float, float]:
    """The sums of the red, green and blue weights, added in row order in float64."""
    red = green = blue = 0.0
    for _, _, r, g, b in taps:
        red, green, blue = red + r, green + g, blue + b
    return red, green, blue


def normalized(taps: tuple[Tap, ...]) -> tuple[Tap, ...]:
    """`taps` with each channel's weights divided by their sum, which must not be 0."""
    red, green, blue = channel_sums(taps)
    return tuple((x, y, r / red, g / green, b / blue) for x, y, r, g, b in taps)
