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
# A scene names a mesh, a camera and a light; a preset fills in the rest. Rendering it gives one array for every buffer
# of every shader stage. Row 0 is the bottom row, as OpenGL reads pixels back.

# %%
import numpy as np

import sss_ref

small = {f"{table}.{side}": 192 for table in ("camera", "shadow_map") for side in ("width", "height")}
scene = sss_ref.load_scene("figure3_with", **small)
result = sss_ref.render(scene)
{name: buffer.shape for name, buffer in result.buffers.items()}

# %% [markdown]
# The paper's central quantity is the thickness: the way of the light through the body. It is the distance between a
# fragment and the point where the light that reaches it entered.

# %%
way = result["position_world"] - result["entry_point"]
thickness = np.sqrt((way[..., 0] * way[..., 0] + way[..., 1] * way[..., 1]) + way[..., 2] * way[..., 2])
assert np.array_equal(thickness, result["thickness"])

# %% [markdown]
# The picture, top row first and encoded for a screen:

# %%
from PIL import Image

from sss_ref.io.png import srgb8

Image.fromarray(srgb8(result.image)[::-1])
