"""The stages, from their own signatures: equation, source, what they read and write, as Python and as GLSL."""

import inspect
from collections.abc import Iterator
from functools import cache
from itertools import groupby
from types import ModuleType
from typing import Any, get_type_hints

import scene_reference
from house_docstrings import comments
from markup import fenced, one_line, prose, table

from sss_ref.interpret.shader import HLSL, stage_source
from sss_ref.language.pipeline import CLIP_POSITION, MESH_ATTRIBUTES, PIXEL
from sss_ref.language.stage import Function, Stage
from sss_ref.language.typing_rules import type_name
from sss_ref.methods.stages import stage_modules
from sss_ref.passes.buffers import BUFFERS, is_listed
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.kernels import TABLE1

ARRAYS = dict.fromkeys(("tap_offset", "tap_weight"), len(TABLE1))  # the uniform arrays of a shader, and their length
ORDER = (  # of the modules, along the way of the light
    *("vertex", "shadow_map", "camera", "phong", "translucency", "blur", "composite"),
    *("irradiance", "texture_image", "light_sum", "byte_targets", "printed_stages"),
)


def modules() -> dict[str, ModuleType]:
    """Name -> module, of those that define stages, in the order of the passes."""
    found = dict(sorted(stage_modules().items(), key=lambda item: place(item[0])))
    return {name: module for name, module in found.items() if stages_of(module)}


def place(name: str) -> int:
    """Where a module comes; those that the list does not name come last."""
    return ORDER.index(name) if name in ORDER else len(ORDER)


def stages_of(module: ModuleType) -> list[Stage]:
    """The stages that a module defines, in its order."""
    found = [value for value in vars(module).values() if isinstance(value, Stage)]
    return [stage for stage in found if stage.python.__module__ == module.__name__]


def functions_of(module: ModuleType) -> list[Function]:
    """The functions that its stages share."""
    found = [value for value in vars(module).values() if isinstance(value, Function)]
    return [function for function in found if function.python.__module__ == module.__name__]


def pages() -> dict[str, str]:
    """File name -> text: one page a module, and the page that lists them."""
    found = modules()
    return {"stages/index": index(found), **{f"stages/{name}": page(module) for name, module in found.items()}}


def index(found: dict[str, ModuleType]) -> str:
    """The list of all stages, and of all buffers."""
    listed = "\n".join(found)
    tables = "\n\n".join(f"## [{name}]({name}.md)\n\n{stage_table(module)}" for name, module in found.items())
    buffers = [[f"`{name}`", one_line(buffer.unit), background(buffer.background)] for name, buffer in BUFFERS.items()]
    return f"""# Stages

A stage is the unit of validation: one pure function from buffers and uniforms to buffers. Everything on these pages is
read from the functions themselves. The same source runs as array code, as compiled kernel and, translated statement by
statement, as the shader that is shown beside it.

{tables}

## Buffers

Every buffer of both methods. With several lights, what belongs to one carries its number: `phong_1`, `phong_2`.

{table(["buffer", "what it holds", "where nothing is drawn"], buffers)}

```{{toctree}}
:hidden:

{listed}
```
"""


def stage_table(module: ModuleType) -> str:
    """The stages of a module, each with its first sentence."""
    rows = [
        [f"[`{stage.name}`](#stage-{stage.name})", one_line(first_sentence(stage.python))]
        for stage in stages_of(module)
    ]
    return table(["stage", "what it computes"], rows)


def background(value: float | str) -> str:
    """What a buffer holds where nothing is drawn: a number, or the uniform that gives it."""
    return f"`{value}`" if isinstance(value, str) else f"{value:g}"


def page(module: ModuleType) -> str:
    """All stages of a module, and the functions they share."""
    name = module.__name__.rpartition(".")[2]
    parts = [f"# {name}", prose(inspect.getdoc(module)), f"Module `{module.__name__}`."]
    parts += [part for stage in stages_of(module) for part in section(stage)]
    functions = functions_of(module)
    if functions:
        parts.append("## Functions that these stages share")
        parts += [fenced("python", inspect.getsource(each.python)) for each in functions]
    return "\n\n".join(parts) + "\n"


def section(stage: Stage) -> Iterator[str]:
    """One stage."""
    yield f"(stage-{stage.name})=\n## {stage.name}"
    yield prose(inspect.getdoc(stage.python))
    yield f"Source: {prose(stage.source)}."
    reads = [[typed(name, kind), origin(name)] for name, kind in stage.parameters.items()]
    yield table(["reads", "from"], reads) if reads else "It reads nothing."
    told = comments(get_type_hints(stage.python)["return"])
    writes = [
        [typed(name, kind), one_line(told.get(name) or unit(name)), links(readers(name))]
        for name, kind in stage.outputs.items()
    ]
    yield table(["writes", "what it holds", "read by"], writes)
    yield f""":::::{{tab-set}}
::::{{tab-item}} Python
{fenced("python", inspect.getsource(stage.python))}
::::
::::{{tab-item}} GLSL
{fenced("glsl", stage_source(stage, ARRAYS))}
::::
::::{{tab-item}} HLSL
{fenced("hlsl", stage_source(stage, ARRAYS, HLSL))}
::::
:::::"""


def typed(name: str, kind: Any) -> str:
    """A name with its type."""
    return f"`{name}` {type_name(kind)}".replace("[", "\\[")


def all_stages() -> list[Stage]:
    """Every stage of the package."""
    return [stage for module in modules().values() for stage in stages_of(module)]


def origin(name: str) -> str:
    """Where a stage has an input from."""
    if name in MESH_ATTRIBUTES:
        return "the vertex"
    if name == PIXEL:
        return "the fragment's place in the target, `ivec2(column, row)`"
    writers = [stage for stage in all_stages() if name in stage.outputs]
    if writers:
        return links(writers)
    if is_listed(name):
        return "the rasterizer"
    keys = [key for key in scene_reference.dotted_keys() if key.rpartition(".")[2] == name]
    if len(keys) == 1:
        return f"the scene's {{confval}}`{keys[0]}`"
    return "a uniform" if name in uniform_names() else "what the pass binds to it"


@cache
def uniform_names() -> set[str]:
    """The uniforms of a scene with one light; how its surface is coloured says which it has besides."""
    return {*load_scene("wedge").uniforms, "albedo_map", "triangle_material", "material_color"}


def readers(name: str) -> list[Stage]:
    """The stages that read a value by this name."""
    return [stage for stage in all_stages() if name in stage.parameters]


def links(stages: list[Stage]) -> str:
    """The stages as links, each name once."""
    names = [name for name, _ in groupby(stage.name for stage in stages)]
    return ", ".join(f"[`{name}`](#stage-{name})" for name in names)


def unit(name: str) -> str:
    """What a value holds, where the stage's outputs do not say it."""
    if name == CLIP_POSITION:
        return "clip space"
    return BUFFERS[name].unit if name in BUFFERS else ""


def first_sentence(python: Any) -> str:
    """The first line of a docstring."""
    return (inspect.getdoc(python) or "").split("\n")[0]
