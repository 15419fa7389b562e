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
# # 1. Light and distance
#
# > **Aims.** Compute how far the light is and how much of it arrives, and tell a distance from a depth. **Before.**
# > Dot product, length of a vector. **Time.** 40 minutes.
#
# Skin, wax and teeth let light in and give it back somewhere else (paper 1). The paper's shortcut for this needs only
# two things to begin with: **how far** a point of the surface lies from the light, and **how much** light falls on
# it. This notebook is about these two. Keep the paper beside you; the numbers in brackets are its sections.
#
# The notebooks draw the shipped head. Point `HEAD` to a mesh of your own, and it takes the same place.

# %%
import math

import numpy as np

import sss_ref
from sss_ref.course import checks, figures, small_scenes, together
from sss_ref.language import length, vec3
from sss_ref.methods.published import byte_targets as encoding
from sss_ref.passes import irradiance, phong, shadow_map

HEAD = "bust"

# %% [markdown]
# ## How far
#
# A light at $L$ reaches a point of the surface at $P$ after the distance
#
# $$D = |P - L| = \sqrt{(P - L) \cdot (P - L)}.$$
#
# In the package that is a **stage**: a Python function in the words of a shader. It takes single numbers ...

# %%
light = vec3(np.float32(0), np.float32(0), np.float32(0))
point = vec3(np.float32(2), np.float32(3), np.float32(-6))
distance = shadow_map.distance_to_light(point, light)
assert distance.light_distance == 7.0  # 4 + 9 + 36 = 49
distance

# %% [markdown]
# ... and it takes arrays, one number for each point. Here are the points of a flat wall, two units in front of the
# light. Their *depth*, the coordinate along the light's axis, is 2 everywhere; their *distance* is not. The paper's
# shadow map stores the distance (paper 3.2), and that is not what a depth buffer holds.

# %%
x = np.linspace(-4, 4, 201, dtype=np.float32)
wall = vec3(x, np.zeros_like(x), np.full_like(x, -2))
far = shadow_map.distance_to_light(wall, light).light_distance
labels = "A wall two units in front of the light", "place on the wall $x$, scene units", "scene units"
axes = figures.curves(labels, x, {"distance $D$": far, "depth": -wall.z})
# %% [markdown]
# ## The light's picture of the head: Figure 1
#
# Draw the mesh from the light's position and keep $D$ in every pixel: that is the shadow map, the paper's Figure 1.
# The scene `figure1` puts the camera where the light is, so both see the same.

# %%
result = sss_ref.render(small_scenes.load("figure1", HEAD, size=512))
distance, drawn = result["light_distance"], result["light_triangle"] >= 0
_, (left, right) = figures.row(2, height=3.6, width=4.2)
figures.picture(left, result.image, "What the light sees")
figures.values(right, distance, "Its distance to what it sees (Figure 1)", "$D$, scene units", drawn)

# %% [markdown]
# The paper stores $D$ "as a brightness value". A brightness has eight bits and ends at 1; this head lies farther away
# than that. The stage `stored_r8` is such a target: what comes back is 1 wherever there is a head. Keep this in mind
# for the printed figures. Every other scene of the package keeps $D$ as a 32-bit float.

# %%
stored = encoding.stored_r8(distance).stored_value
near, far = distance[drawn].min(), distance[drawn].max()
print(f"D of the head: {near:.2f} to {far:.2f}; in eight bits it is {stored[drawn].max():g} everywhere")
assert (stored[drawn] == 1.0).all()

# %% [markdown]
# ## How much
#
# Two laws of optics and one choice.
#
# *Inverse square.* The light of a point spreads over a sphere whose area grows with $D^2$. The paper leaves this out:
# its light has no falloff (`light_constant`). `light_inverse_square` has it.
#
# *Cosine.* A beam that falls on the surface at an angle covers more of it, so each point gets less: the factor is
# $\max(N \cdot \ell, 0)$, with the unit normal $N$ and the unit direction $\ell$ to the light.
#
# *The choice.* For texture space the paper multiplies "the distance to the light source by the dot product" (2.2).
# Taken literally, $D\,\max(N \cdot \ell, 0)$ *grows* with the distance. The package can do both and says which it
# did.

# %%
D = np.linspace(0.6, 4, 200, dtype=np.float32)
surface = vec3(np.zeros_like(D), np.zeros_like(D), -D)
normal, white = vec3(*np.float32([0, 0, 1])), vec3(*np.float32([1, 1, 1]))
falling = phong.light_inverse_square(surface, light, white, np.float32(1)).incident_light.x
paper = irradiance.irradiance_paper(surface, normal, light, white).irradiance.x
labels = "Light on a surface that faces it", "distance $D$, scene units", "relative to $D = 1$"
lines = {"no falloff (3.2)": np.ones_like(D), "inverse square": falling, "irradiance of 2.2": paper}
axes = figures.curves(labels, D, lines)

# %%
angle = np.radians(np.linspace(-180, 180, 361)).astype(np.float32)
normal = vec3(np.sin(angle), np.zeros_like(angle), np.cos(angle))
below = vec3(*np.float32([0, 0, -1]))
lit = irradiance.irradiance_lambert(below, normal, light, white, np.True_, np.True_).irradiance.x
labels = "Lambert's cosine law", "angle between $N$ and the light, degrees", "light received"
axes = figures.curves(labels, np.degrees(angle), {"": lit})
# %% [markdown]
# ## Move the light
#
# The camera stays, the light goes round the head. Watch the distance map turn with it: the light is a second camera.


# %%
def seen_from(azimuth, height):
    turn = math.radians(azimuth)
    place = [3.2 * math.sin(turn), height, 3.2 * math.cos(turn)]
    scene = small_scenes.load("figure3_with", HEAD, size=288, **{"lights.0.position": place})
    result = sss_ref.render(scene)
    figure, (left, right) = figures.row(2, height=3.2, width=3.9)
    figures.picture(left, result.image, "The camera's picture")
    drawn = result["light_triangle"] >= 0
    figures.values(right, result["light_distance"], "The light's map", "$D$, scene units", drawn)
    return figure


figures.Sliders(seen_from, azimuth=(-180, 60, 180), height=(-2, 1.5, 3))

# %% [markdown]
# ## Exercises
#
# ### A line
#
# A game engine gives you a depth buffer of the light: for every ray, the *depth* of what it hit. Give back the
# *distance* that the paper's shadow map would store, for a ray at `angle` radians off the light's axis.


# %%
def answer(depth, angle):
    return depth  # change this line


checks.verdict(checks.distance_of_a_wall, answer)

# %% [markdown]
# ### A stage
#
# A stage's first line is its contract: what it reads, by name and type, and what it writes. Let the light spread, as
# the inverse square law says: `light_color` times `light_intensity` is what arrives at distance 1. The picture on the
# left is the right one.


# %%
def falloff(
    position_world: vec3, light_position: vec3, light_color: vec3, light_intensity: float
) -> phong.IncidentLight:
    distance = length(position_world - light_position)
    return phong.IncidentLight(light_color * (light_intensity / distance))  # change this line


checks.verdict(checks.light_that_spreads, falloff)
together.right_and_yours(checks.light_that_spreads, falloff, HEAD)

# %% [markdown]
# ### A shader
#
# The same in the language of graphics processors, GLSL: types stand before names, and every statement ends with a
# semicolon. It is compiled and run by this machine's OpenGL. Lambert's factor is never negative.

# %%
LAMBERT = """
float lambert(vec3 normal, vec3 to_light) {
    return dot(normal, to_light);  // change this line
}
"""
checks.verdict(checks.lambert_in_glsl, LAMBERT)
