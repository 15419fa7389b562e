"""What another implementation drew, and what its files tell of what its shaders wrote and read."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np

from sss_ref.dump.loss import EXACT, Loss, loss_of
from sss_ref.dump.read import Dump
from sss_ref.dump.srgb import decoded_around
from sss_ref.interpret.intervals.value_sets import componentwise
from sss_ref.interpret.work import buffer_value
from sss_ref.numerics.interval import Interval
from sss_ref.results.diff import bits
from sss_ref.validation.accept.known import Known, KnownBuffer, Pixels
from sss_ref.validation.accept.storage import after_storage, before_storage, moved

Buffers = Mapping[str, np.ndarray]
Stored = Mapping[str, str | Loss]  # buffer -> its storage, of those that are not in float32


@dataclass(frozen=True)
class Drawing:
    """What another implementation drew.

    buffers: name -> array as in `Result`. stored: buffer -> the storage of its file, where that is less than float32;
    of a buffer that was not dumped, that of its texture.
    rounded: buffer -> the storage of its texture, where the file has fewer bits. device: what drew it, in its words.
    """

    buffers: Buffers
    stored: Stored = field(default_factory=dict)
    rounded: Stored = field(default_factory=dict)
    device: str | None = None

    @classmethod
    def read(cls, dump: Dump) -> "Drawing":
        """Of a dump that was read from files."""
        found = dump.buffers
        rounded = {name: one.encoding.rounded_from for name, one in found.items() if one.encoding.rounded_from}
        stored = {name: one.stored for name, one in found.items()}
        return cls({name: one.data for name, one in found.items()}, stored, rounded, dump.device)

    @property
    def coarse(self) -> "Drawing":
        """The same, with no storages but those that round."""
        return replace(self, stored={name: each for name, each in self.stored.items() if loss_of(each) != EXACT})

    def before(self, name: str, held: np.ndarray) -> Interval:
        """All that may have been computed, float64, where the dump of a buffer holds this: texture and file round."""
        file = before_storage(self.stored.get(name, "float32"), held)
        texture = self.rounded.get(name, "float32")
        return Interval(before_storage(texture, file.low).low, before_storage(texture, file.high).high)

    def differs(self, name: str, exact: np.ndarray) -> np.ndarray:
        """Bool (H, W): where the dump of a buffer holds neither these values, nor what storage may make of them."""
        got = self.buffers.get(name, exact)
        found: np.ndarray = np.logical_or.reduce(np.atleast_3d(bits(exact) != bits(got)), axis=-1)
        storages = self.stored.get(name, "float32"), self.rounded.get(name, "float32")
        if loss_of(storages[0]) == loss_of(storages[1]) == EXACT or not found.any():
            return found
        computed, held = np.atleast_3d(exact)[found], np.atleast_3d(got)[found]
        with np.errstate(invalid="ignore"):
            near = np.abs(held.astype(np.float64) - computed) <= moved(*storages, computed, held)
        found[found] = ~(near & np.isfinite(held)).all(axis=1)
        return found

    def texture(self, name: str) -> str | Loss:
        """The storage of the texture that a buffer was in."""
        return self.rounded.get(name, self.stored.get(name, "float32"))

    def as_read(self, name: str, buffer: np.ndarray) -> KnownBuffer:
        """A buffer, or a uniform that is a picture, as a shader read it.

        Exactly, unless its file has fewer bits than the texture had, or the sampler decoded it.
        """
        known = replace(KnownBuffer.exactly(buffer), span=loss_of(self.texture(name)).span_of_bytes)
        if name in self.rounded:
            held = before_storage(self.stored.get(name, "float32"), buffer)
            known = replace(known, low=held.low, high=held.high)
        if self.texture(name) == "srgb8":
            known = replace(known, low=decoded_around(known.low).low, high=decoded_around(known.high).high)
        return known

    def kept(self, name: str, given: KnownBuffer) -> KnownBuffer:
        """What the texture of a buffer that was not dumped may hold of what it was given."""
        loss = loss_of(self.texture(name))
        if loss == EXACT:
            return given
        held = after_storage(loss, Interval(given.low, given.high))
        return replace(given, low=held.low, high=held.high, span=loss.span_of_bytes)

    def handed_on(self, name: str, kind: Any, at: Pixels) -> Known:
        """A dumped value as the next stage of its pass got it, before any texture or file rounded it."""
        held = buffer_value(kind, self.buffers[name], *at)
        if name in self.stored:
            return Known(held, componentwise(partial(self.before, name), held))
        return Known.exactly(held)
