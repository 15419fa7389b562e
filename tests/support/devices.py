"""Other rasterizers than ours, as right as ours: they put the corners elsewhere in their boxes, or draw otherwise."""

import numpy as np

from sss_ref.interpret import arrays
from sss_ref.interpret.work import Fragments
from sss_ref.raster.primitives import drawable, place
from sss_ref.raster.primitives import only as primitives_only
from sss_ref.raster.rasterize import visibility
from sss_ref.rendering.draw import Machine, Sketch, draw, varying_columns, vertices
from sss_ref.rendering.fold import shaded


class Device:
    """Draws like the oracle, but for what `changed` makes of the pieces before they are drawn."""

    def __init__(self, scene, changed, subpixel_bits=8):
        self.scene, self.changed, self.machine = scene, changed, Machine(arrays, None, subpixel_bits)

    def draw(self, one, buffers):
        if not one.draw.vertex_stages:
            return draw(self.scene, one, buffers, self.machine)
        clip_position, attributes = self.vertices(one, buffers)
        viewport = self.machine.viewport(self.scene, one)
        primitives, placed = place(clip_position, attributes, self.scene.mesh_of(one).triangles, viewport)
        primitives = self.changed(primitives, placed, viewport)
        primitives = primitives_only(primitives, drawable(primitives))
        piece, depth = visibility(primitives, viewport, None)
        varyings, _ = varying_columns(one)
        fragments = Fragments(*self.scene.size(one), primitives, piece, viewport.step, varyings)
        return Sketch(fragments, {one.draw.depth: depth})

    def vertices(self, one, buffers):
        return vertices(self.scene, one, buffers, self.machine)

    def buffers_of_all(self):
        """Every buffer of the method, as this device draws it."""
        wanted, buffers = set(self.scene.method.outputs), {}
        for one in self.scene.method.only(wanted).passes:
            sketch = self.draw(one, buffers)
            buffers |= sketch.written | shaded(self.scene, one, sketch, buffers, wanted, self.machine)
        return {name: buffers[name] for name in self.scene.method.outputs}


class ExactVertices(Device):
    """Computes where vertices go without rounding on the way, as one with longer registers may."""

    def vertices(self, one, buffers):
        clip_position, attributes = super().vertices(one, buffers)
        if "clip_from_model" not in one.draw.vertex.reads:  # a layout, which computes nothing
            return clip_position, attributes
        position = self.scene.mesh.attributes["position"].astype(np.float64)
        clip_from_model = self.scene.uniforms[one.draw.vertex.reads["clip_from_model"]].astype(np.float64)
        clip_position = np.column_stack([position, np.ones(len(position))]) @ clip_from_model.T
        return clip_position.astype(np.float32), attributes


def as_it_is(primitives, placed, viewport):
    """Our own."""
    return primitives


def window(placed, viewport):
    """Where vertices lie, in pixels from the centre of pixel (0, 0), float64 (V, 2)."""
    size = np.array([viewport.width, viewport.height]) / 2
    exact = placed.astype(np.float64)
    return exact[:, :2] / exact[:, 3:] * size + size - 0.5


def cut_off(primitives, placed, viewport):
    """Snaps by cutting off."""
    snapped = np.floor(window(placed, viewport) * viewport.step)
    return primitives._replace(snapped=snapped.astype(np.int32))


def other_first_vertex(primitives, placed, viewport):
    """Begins each triangle with its second corner, and adds up in that order."""
    return primitives._replace(corners=np.ascontiguousarray(np.roll(primitives.corners, 1, axis=1)))


def uncut(triangles):
    """Has a guard band: draws triangles that reach beyond the sides of the picture as they are."""

    def changed(primitives, placed, viewport):
        there = (primitives.inverse_w > 0) & (np.abs(placed[:, 2]) <= placed[:, 3])
        whole = there[triangles].all(axis=1)
        others = ~whole[primitives.triangle]
        corners = np.concatenate([triangles[whole], primitives.corners[others]])
        triangle = np.concatenate([np.flatnonzero(whole), primitives.triangle[others]]).astype(np.int32)
        order = np.argsort(triangle, kind="stable")
        return primitives._replace(corners=np.ascontiguousarray(corners[order]), triangle=triangle[order])

    return changed


def to_any_side(seed):
    """Snaps each vertex to one of the four places around it, the same wherever the same vertex is used."""

    def changed(primitives, placed, viewport):
        rng = np.random.default_rng(seed)
        _, same = np.unique(placed, axis=0, return_inverse=True)
        sides = rng.integers(0, 1, (same.max() + 1, 2), endpoint=True)[same.reshape(-1)]
        snapped = np.floor(window(placed, viewport) * viewport.step) + sides
        return primitives._replace(snapped=snapped.astype(np.int32))

    return changed


def only(kept):
    """Draws some of the pieces only: kept is a function of the turn of each, above 0 where counter-clockwise."""

    def changed(primitives, placed, viewport):
        a, b, c = (primitives.snapped[primitives.corners[:, k]].astype(np.int64).T for k in range(3))
        there = kept((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
        return primitives_only(primitives, there)

    return changed


def farthest(primitives, placed, viewport):
    """Tests depth the wrong way round."""
    return primitives._replace(depth=1 - primitives.depth)


def shifted(x, y):
    """Draws so many pixels away."""

    def changed(primitives, placed, viewport):
        move = (np.array([x, y]) * viewport.step).astype(np.int32)
        return primitives._replace(snapped=primitives.snapped + move)

    return changed


def upside_down(primitives, placed, viewport):
    """Begins with the top row."""
    top = np.array([0, (viewport.height - 1) * viewport.step], np.int32)
    return primitives._replace(snapped=np.ascontiguousarray(top + primitives.snapped * np.array([1, -1], np.int32)))


def without(triangle):
    """Forgets one triangle of the mesh."""

    def changed(primitives, placed, viewport):
        there = primitives.triangle != triangle
        return primitives_only(primitives, there)

    return changed
