"""The mapping file's keys, from the models that check it."""

from typing import get_type_hints

from keys import entry

from sss_ref.dump.mapping import BufferTable, MappingFile

HEAD = """# Mapping file reference

A mapping file is TOML. It says of a GPU's dump which file holds which buffer, where the files' names do not, and how
the numbers were stored, where the files do not know it. How to use it: [validate](../how_to/validate.md).

```toml
origin = "top"

[buffers.normal_world]
file = "gbuffer.exr"
channels = ["normal.x", "normal.y", "normal.z"]
space = "view"
```
"""


def page() -> str:
    """The page: the one key of the whole file, then those of a buffer."""
    parts = [HEAD]
    for name, model in (("", MappingFile), ("buffers.NAME", BufferTable)):
        hints = get_type_hints(model, include_extras=True)
        parts += [entry(name, model, key, hints[key], []) for key in model.model_fields if key != "buffers"]
    return "\n\n".join(parts) + "\n"
