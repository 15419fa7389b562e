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
# # 7. Screen space against texture space
#
# > **Aims.** Measure where each method takes strangers for neighbours, and choose one. **Before.** Lessons 5 and 6.
# > **Time.** 45 minutes.
#
# Both methods take neighbours for neighbours: one on the screen, one on the map. The paper finds that "both methods
# produce results that look more life-like than plain Phong shading", and that both have an "obvious issue with
# locality" (4). This notebook puts numbers to the second, lesson 12 to the first. The same head, light, material and
# kernel; only the method changes.

# %%
import numpy as np

import sss_ref
from sss_ref.course import checks, figures, small_scenes, together
from sss_ref.language import vec3
from sss_ref.passes.composite import Image
from sss_ref.scene_file.kernels import HBH09

HEAD = "bust"
METHODS = ("screen_space", "texture_space")


# %%
def pictured(method, size=384, **overrides):
    sizes = {f"irradiance_map.{side}": 512 for side in ("width", "height")}
    sizes |= {f"shadow_map.{side}": 1024 for side in ("width", "height")}
    scene = small_scenes.load("figure5", HEAD, size, method=method, **(sizes | overrides))
    return sss_ref.render(scene)


screen, texture = (pictured(method) for method in METHODS)
drawn = screen["coverage"]

# %%
_, axes = figures.row(3, height=3.1, width=3.3)
figures.picture(axes[0], screen.image, "screen space")
figures.picture(axes[1], texture.image, "texture space")
gap = (texture.image - screen.image).mean(axis=-1)
figures.difference(axes[2], gap, "texture minus screen", "linear", drawn, 0.1)

# %% [markdown]
# They differ at the edges of shadows, and in highlights: the screen blurs the finished picture, highlights included;
# the map blurs light alone, before it is reflected.
#
# ## Who is a neighbour?
#
# For every pixel, add up the weight of the taps that miss: on the screen, those that land more than four times as far
# away on the body as their offset explains, or beside it; on the map, those that land beside the charts. The kernel
# is the same, and so is its red channel, the widest.

# %%
taps = np.array(HBH09)
offsets, red = taps[:, :2] * screen.scene.settings.blur.pixel_scale, taps[:, 2]
camera = screen.scene.camera
position = screen["position_world"].astype(float)
away = np.linalg.norm(position - camera.eye, axis=-1)
pixel = away * float(camera.pixel_size)  # its side, on a surface that faces the camera


# %%
def misses_on_screen():
    missed = np.zeros(drawn.shape)
    for (x, y), weight in zip(offsets, red, strict=True):
        by = -round(y), -round(x)
        there = np.roll(position, by, axis=(0, 1))
        far = np.linalg.norm(there - position, axis=-1) > 4 * pixel * max(np.hypot(x, y), 1)
        missed += weight * (far | (np.roll(drawn, by, axis=(0, 1)) == 0))
    return missed


# %%
def misses_on_map():
    mask, missed = texture["irradiance_mask"], np.zeros(drawn.shape)
    side = np.array(mask.shape[::-1])
    for offset, weight in zip(offsets, red, strict=True):
        column, row = np.moveaxis((texture["uv"] * side + offset).astype(int), -1, 0)
        missed += weight * (mask[row.clip(0, side[1] - 1), column.clip(0, side[0] - 1)] == 0)
    return missed


# %%
_, axes = figures.row(2, height=3.4, width=4.2)
for panel, missed, name in zip(axes, (misses_on_screen(), misses_on_map()), METHODS, strict=True):
    mean = missed[drawn != 0].mean()
    title = f"{name.replace('_', ' ')}: {mean:.1%} of all weight"
    figures.values(panel, missed, title, "weight that misses", drawn, (0, 1))

# %% [markdown]
# Screen space fails along every outline: the nose in front of the cheek, the ear in front of the neck. Which points
# these are changes with every turn of the camera. Texture space fails along the seams, and they stay where they are.
#
# ## How far is a pixel?
#
# The kernel counts in pixels, or in texels. The light in the skin counts in millimetres. How wide a pixel is on the
# body depends on the distance of the camera and on the slope of the surface; how wide a texel is, on the layout. From
# each pixel to its neighbour on the right, measure both.

# %%
step = np.linalg.norm(np.diff(position, axis=1), axis=-1)
uv_step = np.linalg.norm(np.diff(texture["uv"].astype(float), axis=1), axis=-1) * 512
inner = (drawn[:, 1:] & drawn[:, :-1]) != 0
inner &= (step < 8 * np.median(step[inner])) & (uv_step < 8 * np.median(uv_step[inner]))
widths = {"a pixel": step[inner], "a texel": step[inner] / np.maximum(uv_step[inner], 1e-9)}
figures.spreads(widths, "Width on the body", "relative to the median")
for name, width in widths.items():
    low, high = np.quantile(width, [0.05, 0.95])
    print(f"{name}: nine tenths lie between {low:.4f} and {high:.4f} units, 1 to {high / low:.2f}")

# %% [markdown]
# ## Come closer
#
# Four times as many pixels a side, as on a larger screen or seen from nearer: the kernel stays as wide in pixels, so
# on the body it shrinks to a quarter. Averaged down to the same size, the two pictures should be the same picture.


# %%
def averaged(image, times):
    height, width = (side // times for side in image.shape[:2])
    return image.reshape(height, times, width, times, 3).mean(axis=(1, 3))


near, far = ({m: pictured(m, size) for m in METHODS} for size in (768, 192))
inside = np.repeat(near["screen_space"]["coverage"][..., None], 3, axis=2)
core = (averaged(inside, 4)[..., 0] == 1) & (far["screen_space"]["coverage"] == 1)

# %%
_, axes = figures.row(2, height=3.3, width=4.1)
for panel, method in zip(axes, METHODS, strict=True):
    change = (averaged(near[method].image, 4) - far[method].image).mean(axis=-1)
    rms = np.sqrt((change[core] ** 2).mean())
    figures.difference(panel, change, f"{method.replace('_', ' ')}: rms {rms:.4f}", "linear", core, 0.1)

# %%
maps = [results["texture_space"]["scattered_irradiance"] for results in (near, far)]
assert np.array_equal(*maps)

# %% [markdown]
# In screen space the look of the skin depends on how many pixels it has; the scale would have to follow the distance
# (exercise). In texture space the blurred map is the same, bit for bit. Move the camera and compare.


# %%
def from_afar(distance, azimuth):
    keys = {"camera.distance": distance, "camera.azimuth": azimuth}
    figure, axes = figures.row(2, height=3.5, width=3.6)
    for panel, method in zip(axes, METHODS, strict=True):
        result = pictured(method, 320, **keys, **{"blur.pixel_scale": 3.0})
        figures.picture(panel, result.image, method.replace("_", " "))
    return figure


figures.Sliders(from_afar, distance=(1.6, 3.0, 9.0), azimuth=(-180, 32, 180))

# %% [markdown]
# ## Several pictures from one draw
#
# "This method uses multiple render targets (MRTs)" (2.1): one draw of the model fills several pictures at once, for
# each pixel a value in each. It saves drawing the model again for each thing that a later pass reads. In texture
# space the shadow map has them: "it stores the fragment's UV coordinates in addition to the light distance" (2.2). Of
# each pass, how many buffers the package keeps, so that you can check them, and which of them a later pass reads:

# %%
for method, result in zip(METHODS, (screen, texture), strict=True):
    print(method.replace("_", " "))
    passes = [each for each in result.scene.method.passes if not each.on_demand]
    for number, each in enumerate(passes):
        later = {name for after in passes[number + 1 :] for name in after.reads}
        targets = [name for name in each.outputs if name in later]
        print(f"    {each.name}: {len(each.outputs)} buffers, read later: {', '.join(targets) or 'none, shown'}")
assert "light_uv" in texture.buffers and "light_uv" not in screen.buffers

# %% [markdown]
# ## What it costs
#
# The blur is the same code in both; what counts is how many pixels or texels it runs on. The map is blurred as a
# whole, seen or not, and it stays the same for every camera; the screen is blurred where the head is, in every frame.

# %%
for method, mask in zip(METHODS, ("coverage", "irradiance_mask"), strict=True):
    result = pictured(method)  # once more: the first time of all includes compiling
    on_head = np.count_nonzero(result[mask])
    print(f"{method.replace('_', ' ')}: {on_head} of {result[mask].size} are the head's")
    print("   ", ", ".join(f"{one} {1000 * t:.0f} ms" for one, t in result.timings.items()))

# %% [markdown]
# | | screen space | texture space |
# |---|---|---|
# | takes for neighbours | what is close on the screen | what is close on the map |
# | fails at | outlines, steep surfaces | seams, stretched charts |
# | the kernel's width on the body | changes with the camera | changes with the place |
# | needs | the picture alone | UVs without overlap |
# | one shadow map for each light | yes | yes |
#
# ## Exercises
#
# ### A line
#
# The light in your material goes 2 mm; so the kernel has to be scaled. How wide on the body, in scene units, is a
# blur of so many `pixels`, at a `distance` from a camera with the vertical angle `fov_y` (in degrees) and `height`
# rows?


# %%
def answer(pixels, distance, fov_y, height):
    return pixels * distance / height  # change this line


checks.verdict(checks.blur_on_the_body, answer)

# %% [markdown]
# ### A stage
#
# Texture space can keep the albedo sharp: light is blurred, and reflected afterwards. Add the light from everywhere
# (`ambient`), the blurred one (`irradiance_used`) and the mirrored one (`gloss`), and reflect them.


# %%
def reflected(irradiance_used: vec3, gloss: vec3, ambient: float, albedo: vec3) -> Image:
    return Image((ambient + irradiance_used) * albedo + gloss)  # change this line


checks.verdict(checks.albedo_after_the_blur, reflected)
together.right_and_yours(checks.albedo_after_the_blur, reflected, HEAD)

# %% [markdown]
# (The package's highlights are the albedo's colour, as metal's are; other programs leave them white.)
#
# ### A shader
#
# A remedy for screen space: a tap is a stranger if its point lies further away on the body than `allowed`. Say so.

# %%
STRANGER = """
bool stranger(vec3 here, vec3 there, float allowed) {
    return there.z - here.z > allowed;  // change this line
}
"""
checks.verdict(checks.stranger_in_glsl, STRANGER)
