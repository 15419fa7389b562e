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
# # 13. Project: write the method yourself
#
# > **Aims.** Write the paper's screen-space method from an empty file, in NumPy, and have every stage of it judged as
# > another renderer's would be. **Before.** Lesson 2; a milestone after each lesson up to 5. **Time.** 90 minutes.
#
# You play the other renderer. Its rasterizer is there: for every pixel you know which point of the head it shows.
# Everything after it you write, eight functions, each a *milestone* that you can reach once you know its lesson. None
# is compared with the package's numbers: `validate` asks of each pixel whether a right processor may have drawn it,
# so write your sums in whatever order you like.

# %%
import numpy as np

import sss_ref
from sss_ref.course import checks, figures, project

oracle = project.oracle(192)
_, axes = figures.row(3, height=3.0, width=3.2)
drawn = oracle["coverage"]
figures.triangles(axes[0], oracle["triangle"], "where you begin: triangles")
figures.directions(axes[1], oracle["normal_world"], "and their normals", drawn)
figures.picture(axes[2], oracle.image, "where you will arrive")

# %% [markdown]
# ## What a function is given
#
# It asks by name, and gets arrays of the whole picture: `def thickness(position_world, light_position)` gets positions
# (H, W, 3) and the light's (3,). It may ask for every uniform, and for the buffers that are written before its own.
# What it gives is an array of the picture's size. Beside the model the numbers do not matter, but in the last two.
#
# Here is all that there is before the first milestone:

# %%
for name, value in sorted(project.readable("stored_distance").items()):
    if not name.startswith(("tap_0", "tap_1", "gaussian", "kernel", "camera_")):
        print(f"{name:24} {np.shape(value)}")

# %% [markdown]
# ## Milestone 1, after lesson 2: what the map stores
#
# Bring each fragment into the light's clip space, multiply $(x/w, y/w)$ by `lookup_inset`, and go from $-1 \ldots 1$
# to 0 ... 1. Texel $i$ of $n$ holds $i/n$ to $(i + 1)/n$. Give the `light_distance` of that texel; give $|P - L|$
# where the fragment is outside the map or its texel shows no triangle (`light_triangle` is $-1$).


# %%
def stored_distance(): ...  # its arguments, and its body


checks.verdict(checks.own_stored_distance, stored_distance)

# %% [markdown]
# ## Milestone 2, after lesson 2: lit or not
#
# Lit is what faces the light, $c = N \cdot \ell > 0$, and lies no further behind the stored distance than $b_0 +
# b_1\, s\,(1 + \sqrt{1 - c^2}/c)$, with `bias_abs`, `bias_slope`, $c$ not below 0.05, and $s$ = `light_texel_size`
# times the clip space's $w$.


# %%
def directly_lit(): ...  # its arguments, and its body


checks.verdict(checks.own_directly_lit, directly_lit)

# %% [markdown]
# ## Milestone 3, after lesson 3: three terms
#
# `ambient`, `diffuse` and `specular`, the latter to the power of `shininess`, with `incident_light` on the last two and
# `albedo` on all. No highlight where the light or its mirror image is behind.


# %%
def phong(): ...  # its arguments, and its body


checks.verdict(checks.own_phong, phong)

# %% [markdown]
# ## Milestone 4, after lesson 5: the way inside
#
# From the light towards the fragment by the stored distance: there the light entered. Where `shadow_valid` is 0 the
# thickness is 0.


# %%
def thickness(): ...  # its arguments, and its body


checks.verdict(checks.own_thickness, thickness)

# %% [markdown]
# ## Milestone 5, after lesson 5: what the way leaves
#
# $x^y / d^{\,\text{exponent}}$ with $d$ not below `d_min`. `translucency_neutral` where the fragment is lit directly,
# and outside the map (where `shadow_uv` is negative).


# %%
def translucency(): ...  # its arguments, and its body


checks.verdict(checks.own_translucency, translucency)

# %% [markdown]
# ## Milestone 6, after lesson 5: both lights
#
# Phong where the light falls, `ambient` times albedo elsewhere; plus what comes through: albedo, incident light,
# translucency and `translucency_scale`, times $\max(-N \cdot \ell, 0)$, for it enters from behind.


# %%
def lit(): ...  # its arguments, and its body


checks.verdict(checks.own_lit, lit)

# %% [markdown]
# ## Milestone 7, after lesson 4: thirteen taps
#
# Each tap reads `lit` at its `tap_offset` times `pixel_scale` from the pixel, between the four pixels around that
# place, and counts by its `tap_weight`. A place outside the picture is the nearest pixel at its border. 0 where
# `coverage` is 0.


# %%
def scattered(): ...  # its arguments, and its body


checks.verdict(checks.own_scattered, scattered)

# %% [markdown]
# ## Milestone 8, after lesson 4: the picture
#
# The scattered light where the model is, the `background` elsewhere.


# %%
def image(): ...  # its arguments, and its body


checks.verdict(checks.own_image, image)

# %% [markdown]
# ## All together
#
# So far each function was given right buffers. Now each gets what the ones before it gave, on a larger picture; the
# dump is judged as in lesson 9. As long as something is missing, this says up to where you are.

# %%
functions = (stored_distance, directly_lit, phong, thickness, translucency, lit, scattered, image)
dump = project.chained(dict(zip(project.MILESTONES, functions, strict=True)))
print(f"{len(dump)} of {len(project.MILESTONES)} stages written: {', '.join(dump) or 'none yet'}")
if dump:
    print(sss_ref.validate(oracle, dump, profile="gl", explain=False).summary)

# %%
_, (left, right) = figures.row(2, height=3.6, width=3.9)
figures.picture(left, oracle.image, "right")
figures.picture(right, dump.get("image", 0 * oracle.image), "yours")

# %% [markdown]
# All eight right? Then you have written a renderer of translucent bodies. Write it again as shaders: `sss-ref glsl -o
# shaders` gives the passes, `sss-ref validate default mine --run-glsl` draws yours and judges them in the same way.
