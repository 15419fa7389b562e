"""PORTING.md: what somebody must know who draws a bundle with a renderer of their own."""

import textwrap

from sss_ref.bundle.languages import PortedLanguage
from sss_ref.scene.scene import Scene

TEXT = """# Porting this scene

Method `{method}`, preset `{preset}`, mesh `{mesh}`; every number is in the files, nothing is left to guess.

| file | what it holds |
|---|---|
| `mesh/*.npy` | what the vertex shaders read: `position`, `normal`, `uv`, any `tangent` float32; `triangles` int32 |
| `mesh.glb` | the same mesh to look at; its v is measured from the top and rounded, so compare with the arrays |
| `inner_mesh*` | the same of the mesh inside the mesh, for a scene with a layer; `draw.mesh` of a pass says which |
| `uniforms.json` | every uniform by the name in the shaders; matrices are row by row and act on column vectors |
| `textures/*.npy` | pictures (H, W, 3) and arrays too long for a uniform, row 0 at the bottom |
| `passes.json` | the passes in order: size, draw, what they read, targets with format and clear value |
| `shaders/` | {version}: PASS.vert, and a .frag for every draw of at most {most} targets |
| `scene.json` | the scene with every key filled; with it this folder is a scene to `sss-ref`, wherever it lies |
| `mapping.toml` | a mapping file to copy into a dump and edit, with every buffer and every key |

## Passes
{passes}

## Conventions
{notes}
- Texel (i, j) has its centre at ((i + 0.5)/W, (j + 0.5)/H). Textures with the names of buffers are the targets of
  earlier passes. {truth} holds 0 or 1.
- An array too long for a uniform is a texture W = {array_width} texels wide, element k at (k % W, k / W).
- A pass with `rounds` n runs n times; before each but the first, what `feedback` names takes the place of what it read.
- `rectangle` with `discards_where_0`: the fragment shader discards where that buffer is 0 (a stencil does as well).

## Is it right?
Write every target as an .npy, .exr or .dds file named after its buffer into one folder, `dump` beside this one, and ask
here

    sss-ref validate . ../dump

or anywhere with the paths of both folders. It names the first stage that is wrong. This folder holds the scene with all
that was set when it was written, so nothing has to be set again. Keep targets in float32 while you look for an error:
what a narrower format loses is told apart only if the mapping file says so.
"""


def guide(scene: Scene, language: PortedLanguage) -> str:
    """The text for one scene in a shading language."""
    from sss_ref.interpret.shader import ARRAY_WIDTH

    listed = []
    for number, each in enumerate((each for each in scene.method.passes if not each.on_demand), start=1):
        width, height = scene.size(each)
        stages = ", ".join(f"`{stage.name}`" for stage in each.stages)
        listed.append(f"{number}. `{each.name}`, {width} x {height}: {stages}. Writes {', '.join(each.outputs)}.")
    return TEXT.format(
        method=scene.method.name,
        preset=scene.settings.preset,
        mesh=scene.mesh.name,
        passes="\n".join(listed),
        array_width=ARRAY_WIDTH,
        version=language.version,
        most=language.dialect.most_outputs,
        notes="\n".join(map(_item, language.notes)),
        truth=language.formats[bool],
    )


def _item(note: str) -> str:
    """A note as an item of a list, in lines of its own."""
    plain = " ".join(note.split())
    return textwrap.fill(plain, 118, initial_indent="- ", subsequent_indent="  ", break_on_hyphens=False)
