"""A dump as a whole: every buffer read, brought into our form, and held against the scene."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from pathlib import Path

import numpy as np

from sss_ref.dump.convert import Converted, converted
from sss_ref.dump.encoding import Encoding
from sss_ref.dump.files import parts_of
from sss_ref.dump.formats.raw import RawLayout
from sss_ref.dump.loss import Loss
from sss_ref.dump.mapping import Origin
from sss_ref.dump.nothing_drawn import cleared
from sss_ref.dump.slots import Slot, slots_of
from sss_ref.dump.sources import Source, Sources, known_only, sources_of
from sss_ref.dump.texels import StoredTexels
from sss_ref.errors import DumpError
from sss_ref.errors.wording import nearest, told
from sss_ref.results.diff import bits
from sss_ref.scene.scene import Scene

Parts = Callable[[Path, RawLayout | None], tuple[StoredTexels, ...]]


@dataclass(frozen=True, eq=False)
class DumpedBuffer:
    """One buffer of a dump in the form that a rendering of the scene has.

    data: float32, int32 or uint8 (H, W) or (H, W, C), row 0 at the bottom, world space. encoding: how it was stored.
    notes: what was done to it, and what is odd about it.
    """

    name: str
    data: np.ndarray
    encoding: Encoding
    path: Path
    notes: tuple[str, ...] = ()

    @property
    def stored(self) -> str | Loss:
        """What the file keeps of a value, as `validate` takes it."""
        return self.encoding.loss or self.encoding.storage

    @property
    def storage(self) -> str:
        """What the texture's texels were: "float32", "unorm8" ... (see `Encoding`)."""
        return self.encoding.storage

    @cached_property
    def is_blank(self) -> bool:
        """Whether every pixel has the same bits."""
        return bool((bits(self.data) == bits(self.data)[0, 0]).all())

    @cached_property
    def not_finite(self) -> int:
        """How many values are NaN or infinite."""
        return int(np.count_nonzero(~np.isfinite(self.data)))


@dataclass(frozen=True)
class Dump:
    """The buffers that were found, in stage order, the files that were passed over, and what drew them, if known."""

    buffers: Mapping[str, DumpedBuffer]
    notes: tuple[str, ...] = ()
    device: str | None = None


def read_dump(path: Path, scene: Scene, origin: Origin | None = None) -> Dump:
    """The buffers of a dump, brought into the form that a rendering of the scene has.

    path: a mapping file, or a folder with a file named after each buffer. scene: what was drawn.
    origin: "top" or "bottom", the row that files begin with of which the mapping does not say it; None: bottom for NPY,
    top for pictures.

    NaN and infinity are kept and counted: they are the shader's, and no fault of the file. Raises one DumpError with a
    line for every buffer that cannot be used: unknown to the scene's method, unreadable, of another size, or of values
    that its type cannot hold.
    """
    slots = slots_of(scene)
    sources = known_only(sources_of(path, origin), slots)
    if not sources.found:
        raise DumpError(told(str(path), f"a file for a buffer ({', '.join(slots)})", "none", "name the files so"))
    return dump_of(sources, scene)


def dump_of(sources: Sources, scene: Scene) -> Dump:
    """The buffers that these sources hold, as `read_dump` gives them; raises DumpError as that does."""
    slots = slots_of(scene)
    parts = lru_cache(maxsize=1)(parts_of)  # several buffers may lie in one file
    found, problems = {}, []
    for source in sorted(sources.found, key=lambda source: str(source.path)):
        try:
            found[source.name] = _converted(source, slots, parts, scene)
        except DumpError as error:
            problems.append(str(error))
    if problems:
        raise DumpError("\n".join(problems))
    paths = {source.name: source.path for source in sources.found}
    buffers = {}
    for name, (data, notes) in cleared({name: found[name] for name in slots if name in found}, slots, scene).items():
        buffer = DumpedBuffer(name, data, found[name].encoding, paths[name], (*found[name].notes, *notes))
        buffers[name] = replace(buffer, notes=(*buffer.notes, *_oddities(buffer)))
    return Dump(buffers, sources.notes, sources.device)


def _converted(source: Source, slots: Mapping[str, Slot], parts: Parts, scene: Scene) -> Converted:
    if source.name not in slots:
        where = f"{source.mapping}: buffers.{source.name}"
        raise DumpError(told(where, "a buffer of this scene", "this one", nearest(source.name, slots)))
    layout = RawLayout(source.table.shape, source.table.dtype) if source.table.shape and source.table.dtype else None
    return converted(source, slots[source.name], parts(source.path, layout), scene.camera)


def _oddities(buffer: DumpedBuffer) -> list[str]:
    found = []
    if buffer.is_blank:
        found.append("blank: every pixel is the same")
    if buffer.not_finite:
        found.append(f"{buffer.not_finite} of {buffer.data.size} values are NaN or infinite")
    return found
