"""The modules that are generated for the passes of a preset."""

from scenes import settings_with

from sss_ref.interpret.kernel.source import fragment_source, vertex_source
from sss_ref.language.pipeline import MeshDraw
from sss_ref.scene.catalogue import method_of


def passes(preset="robust"):
    """Name -> pass of a preset's method."""
    return {one.name: one for one in method_of(settings_with({"preset": preset})).passes}


def sources(preset):
    """The modules of all passes of a preset, everything kept."""
    written, there = [], set()
    for one in passes(preset).values():
        varyings = {}
        if isinstance(one.draw, MeshDraw):
            varyings = {name: 3 * k for k, name in enumerate(one.draw.varyings)}
            written.append(vertex_source(one, varyings))
        by_stages = [name for name in one.outputs if name not in ("depth", "light_depth")]  # the rasterizer's
        written.append(fragment_source(one, there, by_stages, varyings))
        there |= set(one.outputs)
    assert len(written) > 5
    return written
