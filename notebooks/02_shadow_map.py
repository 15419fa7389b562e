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
# # 2. The shadow map, and a triangle by hand
#
# > **Aims.** Cover a triangle's samples by hand, look a fragment up in a shadow map, and choose a bias. **Before.**
# > Lesson 1; matrices. **Time.** 60 minutes.
#
# The light draws the model before the camera does (paper 2.1). "Draw" means: find out which triangle each pixel of
# the shadow map sees. We do this by hand for one triangle, then let the package do it for the head, and then ask what
# the map tells a point of the surface.

# %%
import numpy as np

import sss_ref
from sss_ref.course import checks, figures, small_scenes, together
from sss_ref.course.rerun import rerun
from sss_ref.language import length, vec3
from sss_ref.passes import shadow_map
from sss_ref.raster.coverage import at, edge_function, owns_its_samples

HEAD = "bust"

# %% [markdown]
# ## Three half-planes
#
# The edge from $a$ to $b$ splits the plane, and the **edge function**
#
# $$e(p) = (b_x - a_x)(p_y - a_y) - (b_y - a_y)(p_x - a_x)$$
#
# says on which side $p$ lies: positive on the left. A point is inside a counter-clockwise triangle where all three
# are positive. The numbers are whole, so nothing rounds and nothing is ever *nearly* inside.


# %%
def edges_of(corners):
    ends = zip(corners, corners[1:] + corners[:1], strict=True)
    return [edge_function(start, end, 1, 1) for start, end in ends]


columns, rows = np.meshgrid(np.arange(16), np.arange(12))
corners = [(1, 1), (14, 3), (5, 10)]
e = np.stack([at(edge, columns, rows) for edge in edges_of(corners)])

# %%
inside = (e > 0).all(axis=0)
_, axes = figures.row(4, height=2.2, width=2.4)
for number in range(3):
    figures.samples(axes[number], e[number] > 0, corners, f"$e_{number + 1} > 0$")
figures.samples(axes[3], inside, corners, "all three: covered")

# %% [markdown]
# Divided by their sum, the same three numbers weigh the corners: they are the **barycentric coordinates**, by which
# positions, normals and UVs are interpolated. Each edge weighs the corner opposite to it, in red, green and blue.

# %%
weights = np.moveaxis(e / e.sum(axis=0), 0, -1)
assert np.allclose(weights.sum(axis=-1), 1)
_, (left,) = figures.row(1, height=2.6, width=3.6)
figures.picture(left, np.where(inside[..., None], weights, 0.9), "Each corner's share")

# %% [markdown]
# ## On the edge
#
# Where $e = 0$, the sample lies on the edge. If two triangles share that edge, one of them has to draw it, and only
# one: drawn twice, a transparent surface shows a line; drawn never, a hole. The **fill rule** gives a sample on an
# edge to the triangle of which it is a *left* edge, where $e$ grows with the column (or a horizontal one at the
# bottom).

# %%
square = [(2, 1), (12, 1), (12, 11), (2, 11)]
drawn = np.zeros((3, 12, 16), int)  # how often, by three rules
for half in (square[:3], [square[0], *square[2:]]):
    e = np.stack([at(edge, columns, rows) for edge in edges_of(half)])
    owned = np.array([owns_its_samples(edge) for edge in edges_of(half)])[:, None, None]
    drawn += [rule.all(axis=0) for rule in (e >= 0, e > 0, (e > 0) | ((e == 0) & owned))]
assert drawn[2].sum() == 10 * 10 and drawn[2].max() == 1

# %%
_, axes = figures.row(3, height=2.4, width=3.1)
for panel, count, rule in zip(axes, drawn, ("$e \\geq 0$", "$e > 0$", "the fill rule"), strict=True):
    figures.samples(panel, count, [*square[:3], square[0], square[3], square[2]], rule)

# %% [markdown]
# The diagonal is drawn twice, never, and once. Every graphics processor has such a rule, and so has the package; its
# corners lie on a grid of 1/256 pixel, which keeps the edge functions whole.
#
# ## The light's view of the head
#
# Every texel keeps the nearest triangle, and the stage `distance_to_light` turns it into a distance. A coarse map
# shows what it is: a list of samples, not a surface.

# %%
_, axes = figures.row(3, height=3.0, width=3.2)
for panel, texels in zip(axes, (24, 96, 512), strict=True):
    sizes = {"shadow_map.width": texels, "shadow_map.height": texels}
    result = sss_ref.render(small_scenes.load("figure3_with", HEAD, **sizes))
    seen = result["light_triangle"]
    title = f"{texels} x {texels}: {len(np.unique(seen)) - 1} triangles"
    figures.triangles(panel, seen, title)

# %% [markdown]
# ## What a fragment asks
#
# A fragment of the camera's picture has a position in the world. The light's matrix brings it into the light's view,
# as texture coordinates of the shadow map; there it finds the distance $t$ of what the light sees in that direction
# (paper 2.1, "unprojecting"). Take one lit fragment: the ring is the same place in both pictures.

# %%
result = sss_ref.render(small_scenes.load("figure3_with", HEAD))
lit = np.argwhere(result["directly_lit"] != 0)
row, column = lit[len(lit) // 2]
texel = result["shadow_uv"][row, column] * result["light_distance"].shape[0]
_, (left, right) = figures.row(2, height=3.4, width=4.1)
figures.picture(left, result.image, "The camera's picture")
figures.mark(left, (column, row))
seen = result["light_triangle"] >= 0
figures.values(right, result["light_distance"], "The shadow map", "$t$, scene units", seen)
figures.mark(right, texel)

# %% [markdown]
# The lookup is a stage. `rerun` runs it again, as plain NumPy, on all fragments of the rendering: the same bits.
# (Give it another `light_position` or `lookup_inset`, and see what changes.)

# %%
found = rerun(shadow_map.shadow_lookup_nearest, result)
assert np.array_equal(found["stored_distance"], result["stored_distance"])
u, v = found["shadow_uv"][row, column]
t = found["stored_distance"][row, column]
print(f"the ringed fragment lies at ({u:.3f}, {v:.3f}) of the map, where t = {t:.4f}")

# %% [markdown]
# ## Lit, or behind something?
#
# The paper has two cases (3.2): if the point on the shadow map *is* the fragment, it is lit; if not, the light came
# through the body. Word for word, "is" means $D - t \leq 0$. But the map stores one distance for a whole texel, and
# the surface runs through it at a slope: half of each texel lies behind its own middle. The lit side takes itself for
# shadow.


# %%
def face(**overrides):
    scene = small_scenes.load("lesson_speckle", HEAD, **overrides)
    return sss_ref.render(scene)


def lit_share(result):
    """Of the fragments that face the light, and so reflect more than the ambient light."""
    ambient = result.scene.settings.phong.ambient * result["albedo"]
    facing = result["phong"][..., 0] > ambient[..., 0]
    return result["directly_lit"][facing].mean()


# %%
literal, slope = face(), face(**{"shadow_map.test": "slope"})
_, axes = figures.row(2, height=3.6, width=3.9)
for panel, result, name in zip(axes, (literal, slope), ("literal", "with a bias"), strict=True):
    title = f"{name}: {lit_share(result):.0%} of what faces the light"
    figures.picture(panel, result.image, title)
assert lit_share(literal) < 0.6 < lit_share(slope)

# %% [markdown]
# The titles say how much of what faces the light takes itself for lit; the rest of it should only be what lies in the
# shadow of the nose or the chin. The remedy is a **bias**: as much room as one texel's footprint explains, which is
# more where the surface is steeper,
#
# $$D - t \leq b_0 + b_1\, s \left(1 + \frac{\sqrt{1 - c^2}}{c}\right)$$
#
# with $c = |N \cdot \ell|$ and the width $s$ of a texel at that distance. Too small a $b_1$, and the speckles return;
# too large, and shadows detach from what casts them. Try both, with few texels and with many.


# %%
def speckled(bias, texels):
    size = {"shadow_map.width": int(texels), "shadow_map.height": int(texels)}
    result = face(**size, **{"shadow_map.test": "slope", "shadow_map.bias_slope": bias})
    figure, (left, right) = figures.row(2, height=3.3, width=3.7)
    figures.picture(left, result.image, f"$b_1$ = {bias:.2f}, {int(texels)} texels a side")
    figures.values(right, result["directly_lit"], "1 where it takes itself for lit", "", result["coverage"])
    return figure


figures.Sliders(speckled, bias=(0, 0.25, 4), texels=(64, 256, 1024))

# %% [markdown]
# ## Exercises
#
# ### A line
#
# `edges` holds the three edge functions at a sample, `left_or_bottom` whether each edge owns what lies on it. Say
# whether the triangle covers the sample, so that neighbours neither overlap nor leave a gap.


# %%
def answer(edges, left_or_bottom):
    return all(e >= 0 for e in edges)  # change this line


checks.verdict(checks.cover_once, answer)

# %% [markdown]
# ### A stage
#
# The simplest bias is one number for the whole map. Lit is what lies no further behind the stored surface than
# `bias_abs`.


# %%
def lit(position_world: vec3, light_position: vec3, stored_distance: float, bias_abs: float) -> shadow_map.DirectlyLit:
    distance = length(position_world - light_position)
    return shadow_map.DirectlyLit(distance - stored_distance >= bias_abs)  # change this line


checks.verdict(checks.lit_within_a_bias, lit)
together.right_and_yours(checks.lit_within_a_bias, lit, HEAD)

# %% [markdown]
# ### A shader
#
# The light's matrix has brought a fragment into clip space, where the map reaches from $-w$ to $w$ in $x$ and $y$.
# Give its texture coordinates, 0 to 1.

# %%
MAP = """
vec2 map_coordinates(vec4 clip) {
    return clip.xy * 0.5 + 0.5;  // change this line
}
"""
checks.verdict(checks.map_coordinates_in_glsl, MAP)
