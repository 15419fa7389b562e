"""passes.json: for each pass its size and draw, what its shaders read and where it is bound, and its targets."""

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

from sss_ref.bundle.languages import PortedLanguage
from sss_ref.interpret.shader import ARRAY_WIDTH, Dialect, array_lengths, draws, fragment_parts, vertex_parts
from sss_ref.interpret.shader.constants import places
from sss_ref.interpret.shader.dialect import Parts
from sss_ref.language.layout import CHANNELS
from sss_ref.language.pipeline import Pass
from sss_ref.passes.buffers import described
from sss_ref.rules import RULES_VERSION
from sss_ref.scene.scene import Scene

FORMAT = "sss_ref bundle 1"


def pass_list(scene: Scene, language: PortedLanguage) -> dict[str, Any]:
    """What passes.json says of a scene, in a shading language."""
    passes: list[dict[str, Any]] = []
    there: set[str] = set()
    for each in scene.method.passes:
        passes.append(_pass(scene, each, there, language))
        there |= set(each.outputs)
    return {
        "format": FORMAT,
        "rules_version": RULES_VERSION,
        "method": scene.method.name,
        "dialect": language.name,
        "array_width": ARRAY_WIDTH,
        "passes": passes,
    }


def plain(value: Any) -> Any:
    """Numbers and lists of them; a float has the fewest digits that give back its float32."""
    if np.ndim(value):
        return [plain(each) for each in value]
    return int(value) if isinstance(value, int | np.integer) else float(str(np.float32(value)))


def _pass(scene: Scene, this_pass: Pass, there: Collection[str], language: PortedLanguage) -> dict[str, Any]:
    (width, height), dialect = scene.size(this_pass), language.dialect
    lengths = array_lengths(scene.uniforms, dialect)
    vertex = vertex_parts(this_pass, lengths, dialect)
    return {
        "name": this_pass.name,
        "only_on_demand": this_pass.on_demand,
        "width": width,
        "height": height,
        "draw": _draw(scene, this_pass, dialect),
        "reads": sorted(this_pass.needs & set(there)),
        **this_pass.repetition,
        "vertex_shader": f"shaders/{this_pass.name}.vert",
        "attributes": [*vertex.attributes],
        **_bound(vertex, 0, lengths, dialect),
        "draws": [
            {
                "fragment_shader": f"shaders/{name}.frag",
                **_bound(fragment_parts(this_pass, there, outputs, lengths, dialect), 1, lengths, dialect),
                "targets": [_target(scene, buffer, this_pass.outputs[buffer], language) for buffer in outputs],
            }
            for name, outputs in draws(this_pass, this_pass.outputs, dialect).items()
        ],
    }


def _bound(parts: Parts, stage: int, lengths: Mapping[str, int], dialect: Dialect) -> dict[str, Any]:
    """What a shader reads and where, in a language that binds by number; of others nothing, they go by names."""
    if dialect.groups is None:
        return {}
    constants = places(parts.uniforms, lengths)
    offsets = {dialect.name(name): offset for name, offset in constants.offsets.items()}
    textures = {dialect.name(name): number for name, number in dialect.bound(parts.textures).items()}
    where = {"binding": 0, "bytes": constants.size, "offsets": offsets} if offsets else None
    return {"resources": {"group": dialect.groups[stage], "constants": where, "textures": textures}}


def _draw(scene: Scene, this_pass: Pass, dialect: Dialect) -> dict[str, Any]:
    """What is drawn, and with which tests."""
    if not this_pass.draw.vertex_stages:
        return {"kind": "rectangle", "discards_where_0": this_pass.draw.stencil}
    later_wins = this_pass.draw.layout and scene.settings.irradiance_map.overlap == "last"
    return {
        "kind": "mesh",
        "mesh": this_pass.draw.mesh,
        "indexed": dialect.indexed,
        "depth_test": "less or equal" if later_wins else "less",
        "cull": "none",
    }


def _target(scene: Scene, name: str, kind: Any, language: PortedLanguage) -> dict[str, Any]:
    """A buffer that a shader writes: its texture's format, what it is cleared to, and what it holds."""
    return {
        "buffer": name,
        "format": language.formats[kind],
        "filter": "nearest",
        "clear": plain(np.broadcast_to(scene.clear(name), CHANNELS[kind])),
        "unit": described(name).unit,
    }
