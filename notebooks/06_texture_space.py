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
# # 6. Texture space
#
# > **Aims.** Shade a model laid out flat, and show what seams and stretched charts do. **Before.** Lesson 4.
# > **Time.** 50 minutes.
#
# The other method of the paper blurs not the picture but the surface itself, spread out flat: "If two points' UV
# coordinates are close to each other, the points are close to each other on the object. This is of course broken by
# UV seams" (2.2). We lay the head out, shine on it, and find out what seams and stretching do.

# %%
import numpy as np

import sss_ref
from sss_ref.course import checks, figures, small_scenes, together
from sss_ref.language import mat3, mat4, vec2, vec3
from sss_ref.mesh.uv_facts import uv_facts
from sss_ref.passes import texture_image, vertex

HEAD = "bust"
MAP = {"irradiance_map.width": 512, "irradiance_map.height": 512}

# %% [markdown]
# ## The layout
#
# Every corner of a triangle has a place on the body and one on the map, $(u, v)$. To cover a closed body, the map
# needs cuts; a piece between cuts is a **chart**.

# %%
result = sss_ref.render(small_scenes.load("figure2", HEAD, **MAP))
mesh = result.scene.mesh
_, axes = figures.row(2, height=4.0, width=4.1)
figures.layout(axes[0], mesh.uvs, mesh.triangles, "The head, laid out")
uv, drawn = result["uv"], result["coverage"]
figures.texture_coordinates(axes[1], uv, "(u, v) on the head, red and green", drawn)
print(f"{uv_facts(mesh).seams} of its edges are cut")

# %% [markdown]
# Listing 1 of the paper is a vertex shader: it puts each vertex where its UV says, with $0 \ldots 1$ brought to the
# $-1 \ldots 1$ of the screen. The package's stage is `layout_vertex`; where the vertex is in the world travels along.

# %%
place = vec3(*np.float32([0.2, 0.7, 0.4]))  # on the body
for uv in ((0, 0), (1, 0), (0.5, 0.75)):
    out = vertex.layout_vertex(place, place, vec2(*np.float32(uv)), mat4(np.eye(4)), mat3(np.eye(3)))
    print(f"uv {uv} goes to {out.clip_position}, with {out.fragment_position} along")

# %% [markdown]
# ## Irradiance: Figure 2
#
# Draw this layout, and compute at every texel how much light falls on its point of the surface. The paper's Figure 2
# shows such a map. Three readings (notebook 1): the printed figure's $D$, the text's $D \max(N \cdot \ell, 0)$, and
# Lambert's law with the shadow map.

# %%
_, axes = figures.row(3, height=3.2, width=3.2)
for panel, mode in zip(axes, ("distance", "paper", "lambert"), strict=True):
    keys = {"irradiance_map.mode": mode, **MAP}
    result = sss_ref.render(small_scenes.load("figure2", HEAD, **keys))
    irradiance = result["irradiance"]
    figures.picture(panel, irradiance / irradiance.max(), f"{mode}, at most {irradiance.max():.2f}")

# %% [markdown]
# ## The blur, and what lies between the charts
#
# Now the thirteen taps of notebook 4 run over the map. Between the charts it is black, and the blur would carry this
# black onto the head. So the charts are first widened: in every round of **dilation** an empty texel copies a
# neighbour. (An edge keeps more than all of its light where what lies further inside is brighter.)

# %%
rounds = (0, 2, 8)
results = []
for count in rounds:
    keys = {"irradiance_map.dilate": count, "blur.mask": "output", **MAP}
    results.append(sss_ref.render(small_scenes.load("figure5", HEAD, **keys)))
mask = results[0]["irradiance_mask"] != 0
edge = mask & ~np.roll(mask, 1, axis=1)
brightness = results[0]["irradiance"].sum(axis=-1) * edge
row, column = np.unravel_index(brightness[40:-40, 40:-40].argmax(), (432, 432))
near = slice(row, row + 80), slice(column, column + 80)  # around the brightest left edge

# %%
_, axes = figures.row(3, height=2.9, width=3.2)
for panel, result, count in zip(axes, results, rounds, strict=True):
    figures.picture(panel, result["irradiance_filled"][near], f"{count} rounds, before the blur")
_, axes = figures.row(3, height=2.9, width=3.2)
for panel, result in zip(axes, results, strict=True):
    kept = result["scattered_irradiance"][edge].sum() / result["irradiance"][edge].sum()
    title = f"after it: the edge keeps {kept:.0%}"
    figures.picture(panel, result["scattered_irradiance"][near], title)

# %% [markdown]
# ## Seams
#
# Widening hides the black, but what a tap finds there is a copy, and not what lies on the *other side* of the cut.
# The shipped cube has a chart for each face, no dilation and a coarse map, to see it well: each face darkens toward
# its edges. With eight rounds and taps that must hit a chart, little is left to see, though the light still does not
# pass from face to face.

# %%
_, axes = figures.row(3, height=3.0, width=3.2)
plain = sss_ref.render(small_scenes.load("lesson_seam"))
keys = {"irradiance_map.dilate": 8, "blur.mask": "taps"}
widened = sss_ref.render(small_scenes.load("lesson_seam", **keys))
figures.picture(axes[0], plain["scattered_irradiance"], "the cube's map, blurred")
figures.picture(axes[1], plain.image, "on the cube")
figures.picture(axes[2], widened.image, "widened, taps on charts only")
mask = plain["irradiance"] > 0
left = plain["scattered_irradiance"][mask] / plain["irradiance"][mask]
print(f"what a face keeps: {left.max():.0%} in its middle, {left.min():.0%} in a corner")
assert left.min() < 0.6 and left.max() > 0.95

# %% [markdown]
# ## Stretching
#
# A flat map of a round body is too large in some places and too small in others. The taps are counted in texels; so
# how far the light reaches on the *body* depends on the place. For each triangle the side of a texel on the body is
# the square root of its area there over its area on the map:

# %%
scene = results[0].scene
mesh, tall = scene.mesh, scene.settings.irradiance_map.height
a, b, c = np.moveaxis(mesh.positions[mesh.triangles].astype(float), 1, 0)
on_body = np.linalg.norm(np.cross(b - a, c - a), axis=1)
(au, av), (bu, bv) = (np.diff(mesh.uvs[mesh.triangles], axis=1)[:, k].T for k in (0, 1))
on_map = np.abs(au * bv - av * bu) * tall * tall
texel = np.sqrt(on_body / np.maximum(on_map, 1e-9))
low, high = np.quantile(texel, [0.01, 0.99])
print(f"98 % of the triangles have texels of {low:.4f} to {high:.4f} units: 1 to {high / low:.2f}")

# %%
relative = texel / np.median(texel)
shown, drawn = relative[results[0]["triangle"]], results[0]["coverage"]
_, axes = figures.row(2, height=3.3, width=4.0)
figures.picture(axes[0], results[0].image, "The head, without dilation")
title = "the side of a texel on it"
figures.values(axes[1], shown, title, "relative to the median", drawn, (0.7, 1.4))

# %% [markdown]
# (The thin lines on the left picture are seams: it is the one without dilation.)
#
# This head was laid out with care. The shipped sheet was not: its map is crowded on the left. Stripes of shadow, all
# of one width and equally sharp, are blurred away there and stay on the right.

# %%
result = sss_ref.render(small_scenes.load("lesson_stretch"))
_, axes = figures.row(3, height=2.9, width=3.2)
figures.picture(axes[0], result["irradiance_filled"], "its map before the blur")
figures.picture(axes[1], result["scattered_irradiance"], "its map after the blur")
figures.picture(axes[2], result.image, "the sheet")
before, after = (result[name][200, :, 0] for name in ("irradiance_filled", "scattered_irradiance"))
kept = {"left": slice(8, 48), "right": slice(-128, None)}
kept = {side: np.ptp(after[at]) / np.ptp(before[at]) for side, at in kept.items()}
print(", ".join(f"{side}: {share:.0%} of the contrast left" for side, share in kept.items()))
assert kept["left"] < 0.5 < 0.99 < kept["right"]

# %% [markdown]
# ## From the map to the picture
#
# A fragment reads the blurred map at its own UV: $i$. The paper mixes it with the Phong colour $c$ as $\sqrt{i\,c}$
# "to get a normalized result" (2.2). Twice the light gives twice the result, for it is in $i$ and in $c$ (but for the
# ambient light). The albedo is in $c$ alone, and so under the root: dark surfaces turn lighter, and colours paler.

# %%
albedo = np.linspace(0, 1, 101, dtype=np.float32)
gray = vec3(albedo, albedo, albedo)
white, none = vec3(*np.float32([1, 1, 1])), vec3(*np.float32([0, 0, 0]))
lines = {
    "$\\sqrt{i\\,c}$ (2.2)": texture_image.image_sqrt(white, gray).image.x,
    "$i$ times albedo": texture_image.image_product(white, none, np.float32(0), gray).image.x,
}
axes = figures.curves(("A surface in full light", "albedo", "what the picture shows"), albedo, lines)

# %% [markdown]
# ## Figure 5
#
# The head with texture-space scattering, and the light in your hand. `scale` widens the kernel, `dilate` the charts.


# %%
def in_texture_space(azimuth, scale, dilate):
    turn = np.radians(azimuth)
    light = [float(2.7 * np.sin(turn)), 1.5, float(2.7 * np.cos(turn))]
    keys = {"blur.pixel_scale": scale, "irradiance_map.dilate": int(dilate), **MAP}
    result = sss_ref.render(small_scenes.load("figure5", HEAD, **keys, **{"lights.0.position": light}))
    figure, (left, right) = figures.row(2, height=3.5, width=3.6)
    figures.picture(left, result.image, "texture space (Figure 5)")
    figures.picture(right, result["scattered_irradiance"], "its blurred irradiance")
    return figure


figures.Sliders(in_texture_space, azimuth=(-180, 65, 180), scale=(0, 2, 8), dilate=(0, 8, 16))

# %% [markdown]
# ## Exercises
#
# ### A line
#
# In which column of a map with `width` columns does `u` lie? It is between 0 and 1, both included.


# %%
def answer(u, width):
    return round(u * width)  # change this line


checks.verdict(checks.texel_that_holds, answer)

# %% [markdown]
# ### A stage
#
# The picture of paper 2.2, from the irradiance $i$ and the Phong colour $c$. Both work component by component, and so
# do `sqrt` and `max`; a root needs what is not negative.


# %%
def mixed(irradiance_used: vec3, phong: vec3) -> texture_image.Image:
    return texture_image.Image(irradiance_used * phong)  # change this line


checks.verdict(checks.mixed_with_phong, mixed)
together.right_and_yours(checks.mixed_with_phong, mixed, HEAD)

# %% [markdown]
# ### A shader
#
# Listing 1 of the paper in one line: the clip position at which a vertex with these texture coordinates is drawn.

# %%
LAYOUT = """
vec4 layout_position(vec2 uv) {
    return vec4(uv, 0.0, 1.0);  // change this line
}
"""
checks.verdict(checks.layout_in_glsl, LAYOUT)
