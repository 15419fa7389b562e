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
# # 3. Phong, and the camera's pass
#
# > **Aims.** Take Phong shading apart, explain one pixel line by line, and read a whole stage in GLSL. **Before.**
# > Lesson 2. **Time.** 45 minutes.
#
# "In a second render call, the model is rendered regularly, the way it would be without any SSS" (paper 2.1).
# Regularly means Phong shading (paper 3.2): three terms added up, at every fragment of the camera's picture. It is
# what subsurface scattering will be compared with.

# %%
import numpy as np

import sss_ref
from sss_ref.course import checks, figures, small_scenes, together
from sss_ref.course.rerun import rerun
from sss_ref.language import dot, normalize, reflect, vec3
from sss_ref.passes import phong

HEAD = "bust"

# %% [markdown]
# ## What the camera knows of a surface
#
# The camera's pass begins with a point of the mesh for every pixel: where it is, which way it faces, and where it
# lies in the texture. The rasterizer blends all three between the corners of the triangle.

# %%
result = sss_ref.render(small_scenes.load("figure3_without", HEAD))
drawn = result["coverage"]
_, axes = figures.row(3, height=2.9, width=3.2)
figures.triangles(axes[0], result["triangle"], "triangle")
figures.directions(axes[1], result["normal_world"], "normal_world as (N + 1)/2", drawn)
figures.texture_coordinates(axes[2], result["uv"], "uv as red and green", drawn)

# %% [markdown]
# A blend of unit vectors is shorter than a unit vector: it cuts the corner. So the normal is made unit again at the
# fragment, never before. Halfway between two normals that are 90 degrees apart, 29 % of the length is missing, and as
# much light would be.

# %%
t = np.linspace(0, 1, 101, dtype=np.float32)
blend = vec3(1 - t, t, np.zeros_like(t))
unit = normalize(blend)
lengths = {"blended": np.hypot(blend.x, blend.y), "made unit": np.hypot(unit.x, unit.y)}
assert abs(1 - lengths["blended"].min() - 0.29) < 0.01
labels = "Two normals 90 degrees apart", "place between the corners", "length of the normal"
axes = figures.curves(labels, t, lengths)

# %% [markdown]
# ## Three terms
#
# With the unit directions $\ell$ to the light, $v$ to the eye, and $r$, the light's mirror image:
#
# $$c = \left(k_a + k_d \max(N \cdot \ell, 0) + k_s \max(v \cdot r, 0)^{n}\right) \cdot \text{albedo}$$
#
# *Ambient* light comes from everywhere, *diffuse* light leaves the surface in all directions alike, and *specular*
# light is the mirror image of the lamp, blurred. `rerun` takes the stage apart: each time only one term is
# left.

# %%
names = ("ambient", "diffuse", "specular")
terms = {name: getattr(result.scene.settings.phong, name) for name in names}
off, pictures = dict.fromkeys(names, 0.0), {}
for name, weight in terms.items():
    pictures[name] = rerun(phong.phong_shading, result, **(off | {name: weight}))["phong"]

# %%
_, axes = figures.row(4, height=2.5, width=2.4)
for panel, (name, image) in zip(axes, pictures.items(), strict=False):
    figures.picture(panel, image, f"{name}, $k$ = {terms[name]:g}")
figures.picture(axes[3], sum(pictures.values()), "all three")
assert np.allclose(sum(pictures.values()), result["phong"], atol=1e-6)

# %% [markdown]
# ## The highlight
#
# $n$ is the shininess. The highlight's shape over the angle between eye and mirror image is $\cos^n$: a polished
# sphere has a large $n$, chalk a small one. Skin lies between.

# %%
angle = np.radians(np.linspace(-90, 90, 361)).astype(np.float32)
up = vec3(*np.float32([0, 0, 1]))
eye = vec3(np.sin(angle), np.zeros_like(angle), np.cos(angle))
lobes = {f"n = {n}": phong.highlight(up, up, eye, np.float32(n)) for n in (2, 8, 32, 128)}
labels = "The highlight", "angle between eye and mirror image, degrees", "specular term"
axes = figures.curves(labels, np.degrees(angle), lobes)

# %% [markdown]
# ## Move the light, change the surface
#
# The highlight shrinks as $n$ grows and wanders with the light. Where the shadow map says that no light arrives
# (notebook 2), the picture has the ambient term alone: hence the hard edges beside the nose and under the chin.


# %%
def shaded(azimuth, shininess, specular):
    turn = np.radians(azimuth)
    light = [float(3.2 * np.sin(turn)), 1.5, float(3.2 * np.cos(turn))]
    keys = {"phong.shininess": shininess, "phong.specular": specular, "lights.0.position": light}
    scene = small_scenes.load("figure3_without", HEAD, **keys)
    image = sss_ref.render(scene, keep="final").image
    figure, (panel,) = figures.row(1, height=3.8)
    figures.picture(panel, image, f"n = {shininess:.0f}, $k_s$ = {specular:.2f}")
    return figure


ranges = {"azimuth": (-180, 40, 180), "shininess": (1, 32, 128), "specular": (0, 0.5, 1)}
figures.Sliders(shaded, **ranges)

# %% [markdown]
# ## One pixel, line by line
#
# `explain` shows what every stage did for one pixel: every line of its source, with the value and the bits. Here is
# the brightest highlight of the picture. The lines under `phong_shading` are the formula above.

# %%
shine = pictures["specular"].sum(axis=-1)
row, column = np.unravel_index(shine.argmax(), shine.shape)
_, (panel,) = figures.row(1, height=3.2)
figures.picture(panel, result.image, f"Pixel ({column}, {row})")
figures.mark(panel, (column, row))

# %%
explanation = sss_ref.explain(result, (int(column), int(row)))
figures.explained(explanation, "phong_shading")

# %% [markdown]
# ## Without and with: Figure 3
#
# Phong shading with its shadows is the left half of the paper's Figure 3. The right half is what the next notebooks
# build.

# %%
scenes = [small_scenes.load(name, HEAD, size=1024) for name in ("figure3_without", "figure3_with")]
without, scattered = (sss_ref.render(scene, keep=["image", "coverage"]) for scene in scenes)
_, axes = figures.row(2, height=4.1)
figures.picture(axes[0], without.image, "without (Figure 3, left)")
figures.picture(axes[1], scattered.image, "with subsurface scattering (right)")

# %% [markdown]
# Look closely at where most has changed. The shadow's edge turns soft and red, and there is light where Phong has none:
# it came through the body. The third picture is what was added, in all three colours together.

# %%
added = (scattered.image - without.image).mean(axis=-1)
row, column = np.unravel_index(added[96:-96, 96:-96].argmax(), (832, 832))
near = slice(row, row + 192), slice(column, column + 192)
_, axes = figures.row(3, height=3.1, width=3.3)
figures.picture(axes[0], without.image[near], "without")
figures.picture(axes[1], scattered.image[near], "with")
figures.difference(axes[2], added[near], "with minus without", "linear", scattered["coverage"][near], 0.15)

# %% [markdown]
# ## Exercises
#
# ### A line
#
# The mirror image of the light. The language has `reflect(i, n)`, which returns where a ray goes on that runs along
# `i` and hits a mirror with the normal `n`. Both arguments here are unit; `to_light` points *to* the light.


# %%
def answer(normal, to_light):
    return reflect(to_light, normal)  # change this line


checks.verdict(checks.mirrored, answer)

# %% [markdown]
# ### A stage
#
# Chalk has no highlight. Write its shading: the ambient term, shared by `light_count` lights, and the diffuse one.


# %%
def matt(
    position_world: vec3,
    normal_world: vec3,
    albedo: vec3,
    light_position: vec3,
    incident_light: vec3,
    ambient: float,
    diffuse: float,
    light_count: float,
) -> phong.Phong:
    to_light = normalize(light_position - position_world)
    lambert = diffuse * dot(normal_world, to_light)  # change this line
    return phong.Phong((ambient / light_count + incident_light * lambert) * albedo)


checks.verdict(checks.matt_surface, matt)
together.right_and_yours(checks.matt_surface, matt, HEAD)

# %% [markdown]
# ### A shader
#
# Every stage is also a shader: the package translates it, statement by statement. Read the one that lights this
# notebook's head, and find the formula in it.

# %%
from sss_ref.interpret.shader import stage_source

print(stage_source(phong.phong_shading, {}))

# %% [markdown]
# Now write its `highlight` yourself. The directions are unit; there is none where the light or its mirror image is
# behind.

# %%
HIGHLIGHT = """
float highlight(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    vec3 mirrored = reflect(-to_light, normal);
    return pow(abs(dot(to_eye, mirrored)), shininess);  // change this line, or write more
}
"""
checks.verdict(checks.highlight_in_glsl, HIGHLIGHT)
