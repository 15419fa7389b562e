"""A mapping file to edit: every buffer of a scene with its file, and every key that may be given for it."""

import json
import textwrap
from collections.abc import Iterator
from typing import Any, Literal, get_args, get_origin

import numpy as np

from sss_ref.dump.mapping import BufferTable, MappingFile
from sss_ref.dump.slots import Slot, slots_of
from sss_ref.passes.buffers import described
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.key_texts import key_texts

WIDTH = 118  # characters of a line
LETTERS = "RGBA"
HEAD = """Mapping file of {source}: which file of a dump holds which buffer, and how.
Delete the tables of buffers that you have not, correct the files' names, and remove the # before a key to use it.
As it stands, each key says what counts without it, for an NPY file of float32, int32 or uint8, bottom row first.
"""
REGISTERS = "What no target holds unless told to: the registers of the shaders, and the single taps of the blur."


def key_reference() -> str:
    """Every key of a mapping file in a paragraph of its own: its name, what it says, and its values if they are few."""
    return "\n\n".join(
        f"{prefix}{key}: {key_texts(model)[key]}{_choices(field.annotation)}"
        for prefix, model in (("", MappingFile), ("buffers.NAME.", BufferTable))
        for key, field in model.model_fields.items()
    )


def mapping_template(scene: Scene) -> str:
    """The mapping file of what `render` writes of a scene; what else a key may say stands in it as a comment."""
    lines = [*_comment(HEAD.format(source=scene.source)), "", '# origin = "bottom"', '# device = "a name to tell"']
    slots = slots_of(scene)
    on_demand = {name for name in slots if name not in scene.kept("all")}
    for name, slot in slots.items():
        if name not in on_demand:
            lines += ["", *_table(slot, scene)]
    lines += ["", *_comment(REGISTERS)] if on_demand else []
    for name in (name for name in slots if name in on_demand):
        lines += [f"# [buffers.{name}]", f'# file = "{name}.npy"']
    lines += ["", *_comment("The keys:"), "#", *_comment(key_reference())]
    return "\n".join(lines) + "\n"


def _table(slot: Slot, scene: Scene) -> Iterator[str]:
    """[buffers.NAME] with its file, and the other keys as comments."""
    kind, unit = f"{slot.dtype}", described(slot.name).unit
    size = f"{slot.width} x {slot.height}"
    yield f"# {size} pixels of {slot.channels} channel{'s' if slot.channels > 1 else ''}, {kind}: {unit}"
    yield f"[buffers.{slot.name}]"
    yield f'file = "{slot.name}.npy"'
    for key, value in _optional(slot, scene).items():
        yield f"# {key} = {json.dumps(value)}"
    yield f'# file = "{slot.name}.raw"  # with the next two lines, in the place of the other file'
    yield f"# shape = {json.dumps(list(slot.shape))}"
    yield f"# dtype = {json.dumps(kind)}"


def _optional(slot: Slot, scene: Scene) -> dict[str, Any]:
    """The keys that this buffer may have, with what counts without them."""
    keys: dict[str, Any] = {"channels": LETTERS[: slot.channels], "origin": "bottom", "encoding": str(slot.dtype)}
    if slot.dtype.kind == "f":
        keys |= {"rounded_from": "float32"}
    keys |= {"scale": 1.0, "offset": 0.0}
    clear = scene.clear(slot.name)
    if slot.mask and np.ndim(clear) == 0:
        keys |= {"background": float(clear)}
    if slot.is_spatial:
        keys |= {"space": "world"}
    if slot.is_direction:
        keys |= {"normals": "xyz"}
    return keys | ({"depth": "window"} if slot.is_window_depth and slot.view else {})


def _choices(annotation: Any) -> str:
    """The values of a key that has a few, one of them in an option; else nothing."""
    for each in (annotation, *get_args(annotation)):
        if get_origin(each) is Literal:
            return f" One of {', '.join(map(json.dumps, get_args(each)))}."
    return ""


def _comment(text: str) -> list[str]:
    """A text in lines of a comment."""
    lines = [part for line in text.strip().splitlines() for part in textwrap.wrap(line, WIDTH) or [""]]
    return [f"# {line}".rstrip() for line in lines]
