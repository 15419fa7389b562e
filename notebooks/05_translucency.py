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
# # 5. Thickness and translucency
#
# > **Aims.** Derive the thickness from the shadow map, turn it into light, and say where the assumption fails.
# > **Before.** Lessons 2 and 4. **Time.** 60 minutes.
#
# An ear against the sun glows; so do the fingers of a hand before a torch. The blur cannot do that: the light comes
# from the other side, far away on the screen. The paper has a second idea for it (2.1): the shadow map knows where
# the light *entered* the body. From there to the fragment is the **thickness** $d$, and the thicker, the darker.

# %%
import numpy as np

import sss_ref
from sss_ref.course import checks, figures, small_scenes, together
from sss_ref.course.rerun import rerun
from sss_ref.language import length, normalize, select, vec2, vec3
from sss_ref.passes import shadow_map, translucency
from sss_ref.pictures.png_file import plain8
from sss_ref.rendering.samples import render_samples

HEAD = "bust"

# %% [markdown]
# ## From the light to the fragment
#
# The stage `back_point` is paper 3.2 in two lines: from the light's position $L$ go towards the fragment $P$, but
# only as far as the stored distance $t$. There the light entered, at $E$; the rest of the way lies inside.
#
# $$E = L + \frac{P - L}{|P - L|}\,t, \qquad d = |P - E|$$
#
# For a round body the stored distance is known in closed form, so the figure needs no rendering.

# %%
angle = np.radians(np.linspace(-75, 75, 16)).astype(np.float32)
light = vec3(*np.float32([-3, 0, 0]))
fragment = vec3(np.cos(angle), np.sin(angle), np.zeros_like(angle))
along = normalize(fragment - light)
chord = 2 * (along.x * fragment.x + along.y * fragment.y)  # inside the unit circle
stored = np.hypot(fragment.x + 3, fragment.y) - chord
way = shadow_map.back_point(fragment, light, stored, np.True_)
assert np.allclose(way.thickness, chord, atol=1e-6)
figures.ways_through_a_disk(light, way.entry_point, fragment)

# %% [markdown]
# And with a rendering: the shipped sphere, whose thickness every pixel can be checked for. The shadow map has samples
# instead of a surface, so there is an error, of about the size of its texels.

# %%
result = sss_ref.render(small_scenes.load("sphere", **small_scenes.BY_THE_TEXT))
through = (result["shadow_valid"] != 0) & (result["directly_lit"] == 0)
position = result["position_world"]
along = position - result.scene.lights[0].position
along = along / np.linalg.norm(along, axis=-1, keepdims=True)
chord = 2 * (along * position).sum(axis=-1)
error = np.abs(result["thickness"] - chord)[through]
print(f"error of d: median {np.median(error):.4f}, 99 % below {np.quantile(error, 0.99):.4f}")
assert np.median(error) < 0.01

# %%
_, axes = figures.row(2, height=3.1, width=3.9)
figures.picture(axes[0], result.image, "A sphere, lit from the right")
figures.values(axes[1], result["thickness"], "The light's way inside", "$d$, scene units", through)

# %% [markdown]
# ## From the thickness to the light
#
# The paper multiplies by $x^y / d^{0.6}$, "with $x$ and $y$ being constants that determine the rate at which light
# scatters". $x^y$ is one number, so both constants only make the material brighter or darker; the shape of the curve
# is that of $d^{-0.6}$. A physical absorber would follow $e^{-\sigma d}$ (Beer and Lambert). And the printed figures
# read the term as $x^{y/d^{0.6}}$: there $x < 1$ lets *more* light through a thicker body.


# %%
def transmitted(form, *constants):
    on_the_map, neutral = vec2(np.float32(0.5), np.float32(0.5)), np.float32(1)
    rest = [np.float32(value) for value in constants]
    return form(d, np.False_, on_the_map, *rest, neutral).translucency


d = np.linspace(0.005, 2, 400, dtype=np.float32)
ratio = transmitted(translucency.translucency_ratio, 2, 0.5, 0.6, 0.1)
exponent = transmitted(translucency.translucency_exponent, 0.5, 1, 0.6, 0.1)
beer = transmitted(translucency.translucency_beer, 2)
lines = {"$x^y / d^{0.6}$, 2 and 0.5": ratio, "$x^{y/d^{0.6}}$, 0.5 and 1": exponent, "$e^{-2d}$": beer}
axes = figures.curves(("What a thickness leaves", "$d$, scene units", "$T$"), d, lines)
assert ratio[-1] < ratio[50] and exponent[-1] > exponent[50]

# %% [markdown]
# At $d = 0$ the ratio is infinite, so the package does not let $d$ fall below `d_min`: the flat beginning of the
# curve.
#
# One thing to take home: **$d^{0.6}$ has a unit.** Measure the same head in millimetres instead of scene units of 150
# mm, and $T$ falls by a factor of twenty. A material belongs to a unit of length; the package never converts.

# %%
factor = 150**0.6
print(f"the same x and y in millimetres: T is {factor:.1f} times smaller")
assert 20 < factor < 21

# %% [markdown]
# ## Skin, wax, glass
#
# Three materials, the light behind the head. Only $y$ and `d_min` differ.

# %%
materials = {"skin": (0.5, 0.1), "wax": (1.5, 0.3), "glass": (2.5, 0.9)}
behind = {"lights.0.position": [1.9, 1.2, -2.2]}
_, axes = figures.row(3, height=3.1, width=3.2)
for panel, (name, (y, d_min)) in zip(axes, materials.items(), strict=True):
    keys = {"translucency.y": y, "translucency.d_min": d_min, **behind}
    result = sss_ref.render(small_scenes.load("figure3_with", HEAD, **(small_scenes.BY_THE_TEXT | keys)))
    figures.picture(panel, result.image, f"{name}: y = {y:g}")

# %% [markdown]
# All three have the same thickness, for that is the mesh's and the light's. Take the fragment with the longest way
# inside, in the ring, and read what the stage did there:

# %%
not_lit = (result["shadow_valid"] != 0) & (result["directly_lit"] == 0)
row, column = np.unravel_index((result["thickness"] * not_lit).argmax(), not_lit.shape)
_, (panel,) = figures.row(1, height=3.4, width=4.4)
figures.values(panel, result["thickness"], "The light's way inside", "$d$, scene units", not_lit)
figures.mark(panel, (column, row))

# %%
figures.explained(sss_ref.explain(result, (int(column), int(row))), "back_point")

# %% [markdown]
# ## Materials that look it
#
# One number $T$ for all colours is the paper's; skin, wax and glass differ in how far *red* gets, and blue. The scenes
# `default`, `wax` and `glass` have preset `robust`, with soft shadows. Behind the ear of the first stands a red lamp;
# the wax has a $T$ for each colour, fitted to walks of photons; in the glass nothing scatters, and $T$ is Beer and
# Lambert's, with red absorbed most. At 512 pixels, with four samples in each, the stairs at the outline are gone, too.


# %%
def smooth(name, head=""):
    return render_samples(small_scenes.load(name, head, 512), 2).image


_, axes = figures.row(3, height=3.2, width=3.2)
for panel, (name, title) in zip(axes, {"default": "skin", "wax": "wax", "glass": "glass"}.items(), strict=True):
    figures.picture(panel, smooth(name, HEAD), title)

# %% [markdown]
# Teeth are what the paper was written for (1.2): painted in one colour they "look like plastic, because they consist of
# several layers with differing translucency". Here is a molar in the light of a lamp, and lit from behind: warm dentine
# seen through enamel, which is clear at the cusps.

# %%
_, axes = figures.row(2, height=3.4, width=3.4)
for panel, name in zip(axes, ("teeth_layers", "teeth_layers_backlit"), strict=True):
    figures.picture(panel, smooth(name), name)

# %% [markdown]
# ## Figure 4
#
# The paper's own glass and wax, computed as its printed figures are. Its shadow map keeps eight bits, so every
# distance beyond 1 is 1 (notebook 1), and $d$ is no thickness at all: it is the distance to the light, less one.
# (Except at the light's own outline, where the map's background is blended in.)

# %%
_, axes = figures.row(2, height=3.4)
for panel, name in zip(axes, ("glass", "wax"), strict=True):
    result = sss_ref.render(small_scenes.load(f"figure4_{name}", HEAD, size=720))
    figures.picture(panel, result.image, name, plain8)

# %%
drawn = result["coverage"] != 0
to_light = result["position_world"] - result.scene.lights[0].position
less_one = np.linalg.norm(to_light, axis=-1) - 1
saturated = np.isclose(result["thickness"], less_one, atol=1e-3)[drawn].mean()
print(f"d is the distance to the light less one on {saturated:.1%} of the head")
assert saturated > 0.8

# %% [markdown]
# ## Your own material
#
# The light starts behind the ear; `azimuth` lets it go round. $x$ and $y$ make one number, $x^y$; the exponent says how
# fast thick parts go dark, and with 0 thickness does not count.
#
# The paper's application has such a menu (3.1): light and material are changed while it runs, and the model is seen
# by an orbiting or a free camera. `sss-ref view figure3_with` opens the like of it in your browser, with every key
# of the scene.


# %%
def material(x, y, exponent, azimuth):
    turn = np.radians(azimuth)
    light = [float(2.9 * np.sin(turn)), 1.2, float(2.9 * np.cos(turn))]
    keys = {"translucency.x": x, "translucency.y": y, "translucency.exponent": exponent}
    scene = small_scenes.load("figure3_with", HEAD, **(small_scenes.BY_THE_TEXT | keys), **{"lights.0.position": light})
    figure, (panel,) = figures.row(1, height=3.8)
    title = f"$T = {x:.2f}^{{{y:.2f}}} / d^{{{exponent:.2f}}}$"
    figures.picture(panel, sss_ref.render(scene, keep="final").image, title)
    return figure


ranges = {"x": (0.5, 2, 4), "y": (-2, 1.5, 4), "exponent": (0, 0.6, 2)}
figures.Sliders(material, azimuth=(-180, 135, 180), **ranges)

# %% [markdown]
# ## Nearly zero
#
# Notebook 2 showed lit fragments that take themselves for shadow, because the map has texels. Their "thickness" is a
# rounding error, and a small $d$ means a large $T$: with the text's $T$ as a factor, the speckles shine. A bias keeps
# them out, and `d_min` bounds what is left.

# %%
kinds = {
    "literal test, d_min 0.001": {"shadow_map.test": "literal", "translucency.d_min": 0.001},
    "literal test, d_min 0.1": {"shadow_map.test": "literal"},
    "with a bias, d_min 0.1": {},
}
_, axes = figures.row(3, height=3.1, width=3.2)
for panel, (title, keys) in zip(axes, kinds.items(), strict=True):
    result = sss_ref.render(small_scenes.load("figure3_with", HEAD, preset="paper", **keys))
    figures.picture(panel, result.image, title)
    brightest = result["translucency"].max()
    panel.set_xlabel(f"largest T: {brightest:.3g}")

# %% [markdown]
# ## Where the assumption fails
#
# "This of course assumes, that the object is convex, because any spaces present between the two points will not be
# considered" (paper 2.1). Two slabs with air between them: the light enters the rear one, leaves it, crosses the gap,
# and goes through the front one. The shadow map only knows the first point.

# %%
result = sss_ref.render(small_scenes.load("lesson_nonconvex", **small_scenes.BY_THE_TEXT))
front = np.isclose(result["position_world"][..., 2], 0.6, atol=1e-3) & (result["coverage"] != 0)
both = front & np.isclose(result["entry_point"][..., 2], -0.6, atol=1e-2)
_, axes = figures.row(2, height=3.2, width=3.9)
figures.picture(axes[0], result.image, "Two slabs, the light behind them")
figures.values(axes[1], result["thickness"], "the thickness assumed", "$d$, scene units", front)

# %% [markdown]
# Each slab is 0.3 thick and the gap 0.6: where the light crosses both, half of the assumed way is air. How much too
# dark is the picture there? Run the stage again with half the thickness.

# %%
truth = np.where(both, result["thickness"] / 2, result["thickness"])
T = rerun(translucency.translucency_ratio, result, thickness=truth)["translucency"]
too_dark = (T / np.maximum(result["translucency"], 1e-6))[both]
print(f"T would be {too_dark.mean():.3f} times as large; 2^0.6 = {2**0.6:.3f}")
assert np.allclose(too_dark, 2**0.6, rtol=1e-4)

# %% [markdown]
# ## Exercises
#
# ### A line
#
# A ray tracer knows more: the distances from the light at which a ray goes in, out, in, out ... of bodies. How long
# is its way *inside*? (The last crossing is the fragment, on the way out.)


# %%
def answer(crossings):
    return crossings[-1] - crossings[0]  # change this line


checks.verdict(checks.way_inside, answer)

# %% [markdown]
# ### A stage
#
# The heart of the paper. Give $E$, where the light entered, and the way from there to the fragment; where the map
# holds nothing (`shadow_valid` is false) the light enters at the fragment itself.


# %%
def behind(
    position_world: vec3, light_position: vec3, stored_distance: float, shadow_valid: bool
) -> shadow_map.BackPoint:
    direction = position_world - light_position  # change these lines
    entry_point = select(shadow_valid, light_position + direction * stored_distance, position_world)
    return shadow_map.BackPoint(entry_point, length(position_world - light_position))


checks.verdict(checks.where_light_entered, behind)
together.right_and_yours(checks.where_light_entered, behind, HEAD)

# %% [markdown]
# ### A shader
#
# The ratio $x^y / d^{\,\text{exponent}}$, with a $d$ that does not fall below `d_min`.

# %%
RATIO = """
float translucency(float thickness, float x, float y, float exponent, float d_min) {
    return pow(x, y) / (thickness * exponent);  // change this line
}
"""
checks.verdict(checks.ratio_in_glsl, RATIO)
