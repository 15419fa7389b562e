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
# # One picture, stage by stage
#
# > **Aims.** Render a scene, and know a stage, a buffer and a uniform. **Before.** Nothing. **Time.** 10 minutes.
#
# A scene names a mesh, a camera and a light; a preset fills in the rest. Rendering it gives one array for every buffer
# of every shader stage. Row 0 is the bottom row, as OpenGL reads pixels back.

# %%
import numpy as np

import sss_ref

sides = ("camera.width", "camera.height", "shadow_map.width", "shadow_map.height")
scene = sss_ref.load_scene("figure3_with", **dict.fromkeys(sides, 384))
result = sss_ref.render(scene)
{name: buffer.shape for name, buffer in result.buffers.items()}

# %% [markdown]
# The paper's central quantity is the thickness: the way of the light through the body. It is the distance between a
# point just below the fragment and the point where the light that reaches it entered; to the last bit, since the order
# of the sum is a rule.

# %%
way = result["inside_point"] - result["entry_point"]
x, y, z = np.moveaxis(way, -1, 0)
thickness = np.sqrt((x * x + y * y) + z * z)  # in float32, in this order
assert np.array_equal(thickness, result["thickness"])

# %% [markdown]
# The picture, top row first and encoded for a screen:

# %%
from PIL import Image

from sss_ref.pictures.png_file import srgb8

Image.fromarray(srgb8(result.image)[::-1])
