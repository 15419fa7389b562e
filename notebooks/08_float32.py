# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     name: python3
# ---

# %% [markdown]
# # 8. Why two graphics processors differ
#
# > **Aims.** Count in units in the last place, and say what two right processors may disagree on. **Before.** Lesson
# > 3. **Time.** 50 minutes.
#
# The paper's formulas are about real numbers. Shaders compute with `float`, 32 bits, and every operation rounds.
# Where it rounds, and how often, is partly left to the processor: two of them, both right, give different bits. This
# notebook measures by how much, so that the next one can tell such differences from mistakes.

# %%
import numpy as np

import sss_ref
from sss_ref.course import checks, figures, small_scenes, together
from sss_ref.course.rerun import inputs_of
from sss_ref.language import dot, normalize, pow, sqrt, vec3
from sss_ref.passes import shadow_map
from sss_ref.results.diff import bits

HEAD = "bust"

# %% [markdown]
# ## A ruler whose marks move apart
#
# A float is a whole number times a power of two. Between two powers of two the marks are equally far apart; at each
# power the distance doubles. That distance is the **unit in the last place**, ULP. With three significant bits, it
# can be drawn:

# %%
numbers = np.concatenate([2.0**power * np.arange(4, 8) / 4 for power in range(-3, 3)])
figures.number_line(numbers, "All numbers with three significant bits between 1/8 and 7")

# %% [markdown]
# A float32 has 1 bit for the sign, 8 for the power of two, and 23 for what follows the leading one, which need not be
# stored: 24 significant bits. The paper's exponent 0.6 is not among its numbers; what a shader has instead differs in
# the eighth digit.

# %%
exponent = np.float32(0.6)
pattern = f"{exponent.view(np.uint32):032b}"
print(f"0.6 is stored as {float(exponent):.12f}: {pattern[0]} {pattern[1:9]} {pattern[9:]}")
for value in np.float32([0.1, 1, 3, 1000]):
    print(f"at {value:g} the next number is {np.spacing(value):.3g} away")

# %% [markdown]
# ## The order of a sum
#
# A dot product has two additions, and each rounds. The package's rule is $(x x' + y y') + z z'$ (rule A3). GLSL does
# not say. Here are both orders, for the head's normals and the direction to the light: what Lambert's law needs for
# every lit pixel.

# %%
result = sss_ref.render(small_scenes.load("figure3_with", HEAD, **small_scenes.BY_THE_TEXT))
drawn = result["coverage"] != 0
N = vec3(*result["normal_world"][drawn].T)
light = vec3(*np.float32(result.scene.settings.lights[0].position))
L = normalize(light - vec3(*result["position_world"][drawn].T))
by_rule = dot(N, L)
other_order = N.x * L.x + (N.y * L.y + N.z * L.z)

# %%
counted = f"of {by_rule.size} dot products"
print(f"other bits in the other order: {np.mean(by_rule != other_order):.0%} {counted}")
print(f"largest difference: {np.abs(by_rule - other_order).max():.2g}, with terms up to 1")
assert (by_rule != other_order).any()

# %% [markdown]
# ## Multiply and add at once
#
# Most processors have an instruction for $a b + c$ that rounds once instead of twice: the **fused multiply-add**. It
# is faster and more accurate, and the compiler decides where to use it. So the same source, on the same processor,
# may change its bits with a driver update. In float64 the product of two float32 is exact, so a sum in float64 that is
# rounded to float32 is what the instruction computes (but for ties, rarer than one in $2^{28}$).


# %%
def fused(a, b, c):
    return (a.astype(np.float64) * b + c).astype(np.float32)


with_fused = fused(N.z, L.z, fused(N.y, L.y, N.x * L.x))
print(f"other bits with fused multiply-add: {np.mean(by_rule != with_fused):.0%} {counted}")
assert (by_rule != with_fused).any()

# %% [markdown]
# A GLSL compiler keeps its hands off what is declared `precise`; GLSL ES 3.00 has no such word.
#
# ## A power
#
# $d^{0.6}$ has infinitely many digits. The nearest float32 is a well defined answer, the **correctly rounded** one,
# and the package's `pow` gives it (rule A2). Libraries need not. NumPy's `power` depends on the processor it runs on:

# %%
d = np.linspace(0.1, 3, 200_001, dtype=np.float32)
nearest, library = pow(d, exponent), np.power(d, exponent)
apart = np.abs(bits(nearest).astype(int) - bits(library).astype(int))
missed = f"{np.mean(apart > 0):.1%} of the d, by at most {apart.max()} ULP"
print(f"np.power misses the nearest float32 for {missed}")

# %% [markdown]
# A graphics processor may be much farther off. Vulkan defines `pow(x, y)` as $2^{y \log_2 x}$, where the logarithm
# may err by $2^{-21}$ near 1, and the power of two by $3 + 2|t|$ ULP at $t$. The exponent multiplies the logarithm's
# error: $x^{32}$, the highlight of our scenes, may be off by $32 \cdot 2^{-21} \ln 2$, relatively, before the rest
# is added. `Profile.arithmetic` is that text of the standard as intervals.

# %%
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.numerics.interval import point

x = np.linspace(0.5, 1, 500).astype(np.float32)
allowed = {}
for y in np.float32([0.6, 2, 8, 32]):
    interval = PROFILES["vulkan"].arithmetic.pow(point(x.astype(np.float64)), point(np.float64(y)))
    exact = pow(x, y)
    allowed[f"$x^{{{y:g}}}$"] = (interval.high - exact) / np.spacing(exact)

# %%
axes = figures.curves(("What Vulkan allows a power", "$x$", "ULP above the nearest float32"), x, allowed)
axes.set(yscale="log", ylim=(1, 2000))
axes.legend(loc="upper right", ncols=4)
assert allowed["$x^{32}$"].min() > 90

# %% [markdown]
# The teeth are where the *result* passes a power of two and its ULP doubles. No eye sees any of this: 256 ULP are at
# most one part in 32768. But a test whose tolerance was guessed too small fails on a correct processor.
#
# ## Corners on a grid
#
# Before a triangle is filled, its corners move to the nearest point of a grid within the pixel (notebook 2). Standards
# ask for at least 1/16 of a pixel; many have 1/256. Positions, normals and UVs are then interpolated, on the moved
# triangle or on the one before it: also not said. The same head on both grids:

# %%
coarse = sss_ref.render(result.scene, subpixel_bits=4)
same = drawn & (coarse["triangle"] == result["triangle"])
moved = np.linalg.norm(coarse["position_world"].astype(float) - result["position_world"], axis=-1)
away = np.linalg.norm(result["position_world"] - result.scene.camera.eye, axis=-1)
in_pixels = moved / (away * float(result.scene.camera.pixel_size))
turned = np.argwhere((coarse["directly_lit"] != result["directly_lit"]) & same)

# %%
_, (left, right) = figures.row(2, height=3.4, width=4.2)
figures.values(left, in_pixels, "How far the surface under a pixel moved", "pixels", same, (0, 0.1))
figures.picture(right, result.image, "Rings: lit on one of the two grids only")
for row, column in turned:
    figures.mark(right, (column, row))

# %%
others, all_drawn = np.count_nonzero(drawn & ~same), np.count_nonzero(drawn)
print(f"{others} of {all_drawn} pixels see another triangle, {len(turned)} turn from lit to shadow or back")
assert 0 < len(turned) < 0.02 * all_drawn

# %% [markdown]
# A few hundredths of a pixel, and yet some pixels change from lit to shadow: a comparison turns a small difference
# into a large one. No tolerance on the *result* can cover that.
#
# ## Everything a right processor may compute
#
# So the package does not ask "how large a difference is acceptable?". It runs the stage on **intervals**: every
# operation gives the least and the greatest number that the standard allows, and where a comparison is undecided,
# both ways are taken. What comes out holds the result of every right processor. A **profile** says what is known of
# it: `ieee` rounds each operation once in the order written, `vulkan` is that standard's text, `gl` OpenGL's
# "about 1 part in $10^5$" on top.

# %%
from sss_ref.interpret.intervals.evaluate import run_intervals
from sss_ref.passes import phong, translucency


def reach(stage, name, profile, at):
    """Below and above the oracle, in ULP."""
    outcome = run_intervals(stage, inputs_of(stage, result, at), PROFILES[profile])[name].value
    part = outcome.x if stage is phong.phong_shading else outcome
    oracle = result[name][at] if result[name].ndim == 2 else result[name][at][:, 0]
    low, high = (end.astype(np.float64) - oracle for end in (part.low, part.high))
    assert (low <= 0).all() and (high >= 0).all()  # the oracle is inside
    return low / np.spacing(oracle), high / np.spacing(oracle)


# %%
row = drawn.shape[0] // 2
columns = np.flatnonzero(drawn[row])
at = np.full_like(columns, row), columns
stages = {"translucency": translucency.translucency_ratio, "phong": phong.phong_shading}
_, axes = figures.row(2, height=3.6, width=4.4)
for panel, (name, stage) in zip(axes, stages.items(), strict=True):
    bands = {profile: reach(stage, name, profile, at) for profile in ("gl", "vulkan", "ieee")}
    figures.bands(panel, columns, bands, f"{name}, row {row}")

# %% [markdown]
# `ieee` leaves a single number, that of the package, the **oracle**; its band is a line. For translucency the others
# have none either where the light falls directly: there $T$ is 1 or 0 without any computation. Phong's band is narrow
# where it is a sum of two simple terms, and swells in the highlight, where the 32nd power joins.
#
# ## Exercises
#
# ### A line
#
# Differences are counted in ULP all over the next notebook. Given two positive float32, how many steps lead from one
# to the other? (`a.view(np.int32)` is the bit pattern of `a` as a whole number.)


# %%
def answer(a, b):
    return round(abs(float(a) - float(b)) / float(np.spacing(a)))  # change this line


checks.verdict(checks.ulps_between, answer)

# %% [markdown]
# ### A stage
#
# Judged to the last bit: the distance to the light, from its components. Your formula is right; its bits are not yet
# the package's.


# %%
def far(fragment_position: vec3, light_position: vec3) -> shadow_map.LightDistance:
    way = fragment_position - light_position
    return shadow_map.LightDistance(sqrt(way.x * way.x + (way.y * way.y + way.z * way.z)))  # change this line


checks.verdict(checks.same_bits, far)
together.right_and_yours(checks.same_bits, far, HEAD)

# %% [markdown]
# ### A shader
#
# $a^2 - b^2$ for two numbers that are nearly the same. Each square is rounded, and what is left of their difference is
# mostly those roundings. The answer needs no more than 21 right bits.

# %%
SQUARES = """
float difference_of_squares(float a, float b) {
    return a * a - b * b;  // change this line
}
"""
checks.verdict(checks.difference_of_squares_in_glsl, SQUARES)
