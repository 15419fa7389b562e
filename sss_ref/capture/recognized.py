"""A folder of pictures recognised: what is placed, in doubt, or asked for; as a mapping file and as a dump."""

import json
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sss_ref.capture.candidate import FITS
from sss_ref.capture.placing import Arrangement, Placement, Question, place
from sss_ref.capture.renderdoc_file import captured
from sss_ref.capture.surfaces import surfaces_of
from sss_ref.dump.read import Dump, dump_of
from sss_ref.dump.sources import Source, Sources
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import write_text
from sss_ref.errors.whole_file import put_new
from sss_ref.errors.wording import told
from sss_ref.rendering.result import Result

HEAD = "# Which file holds which buffer of {scene}, told by what is in the files. Correct it where it is wrong.\n"
MAPPING = "mapping.toml"
NOT_KNOWN = "no buffer of the scene is like it"


@dataclass(frozen=True)
class Recognized:
    """The pictures of a folder, each as a buffer if it could be told. notes: on files that are no pictures."""

    folder: Path
    oracle: Result
    placed: Arrangement
    notes: tuple[str, ...] = ()

    def lines(self) -> Iterator[str]:
        """What was placed where, and how sure that is."""
        for name, each in self.placed.placements.items():
            sure = f"{each.candidate.score:.0%} alike"
            yield f"{name}: {each.surface}, {', '.join((*_ways(each), sure))}"

    def doubts(self) -> Iterator[str]:
        """What to look at: places by structure alone, rows and channels that run otherwise, and what is not placed."""
        for name, each in self.placed.placements.items():
            yield from (f"{name}: {doubt}" for doubt in self._doubts(each))
        yield from (self.asked(question) for question in self.placed.questions)
        twins = {each.surface.content: each.surface for each in self.placed.placements.values()}
        for surface in self.placed.unknown:
            same = twins.get(surface.content)
            yield f"{surface}: left out, {f'it holds the same as {same}' if same else NOT_KNOWN}"
        yield from self.notes

    def _doubts(self, each: Placement) -> Iterator[str]:
        usual = self.placed.usual_origin
        if each.candidate.close < FITS:
            yield f"{each.surface} is like it in structure, but not in its numbers"
        if each.candidate.origin != usual and not each.surface.is_even:
            yield f"the rows of {each.surface} begin at the {each.candidate.origin}, those of most files at the {usual}"
        if not each.candidate.is_in_order:
            yield f"the channels of {each.surface} are in the order {', '.join(each.channel_names)}"

    def asked(self, question: Question) -> str:
        """A question as a line."""
        files, names = (" and ".join(map(str, each)) for each in (question.surfaces, question.names))
        if len(question.surfaces) > 1:
            came, remedy = f"{files}, which fit it alike", "remove all but one, or say in a mapping file which it is"
            return told(str(self.folder), f"one file for {names}", came, remedy)
        remedy = "say in a mapping file which it is"
        return told(files, "a file that fits one buffer", f"one that fits {names} alike", remedy)

    def dump(self) -> Dump:
        """The buffers that are placed, read as a mapping file would have them. Raises DumpError where none is."""
        found = tuple(
            Source(name, each.surface.path, each.table, each.candidate.origin)
            for name, each in self.placed.placements.items()
        )
        if not found:
            expected = f"pictures like the buffers of {self.oracle.scene.source}"
            remedy = "check scene, preset and size, or write a mapping file"
            raise DumpError(told(str(self.folder), expected, "none", remedy))
        return dump_of(Sources(found), self.oracle.scene)

    def mapping(self, beside: Path) -> str:
        """The text of a mapping file in a folder, with what is asked for as comments."""
        lines = [HEAD.format(scene=self.oracle.scene.source)]
        start = os.path.relpath(self.folder, beside)
        for name, each in self.placed.placements.items():
            keys = each.table.model_dump(exclude_defaults=True) | {
                "file": (Path(start) / each.surface.path.name).as_posix()
            }
            lines += [f"[buffers.{name}]", *(f"{key} = {json.dumps(value)}" for key, value in keys.items()), ""]
        lines += [f"# {self.asked(question)}" for question in self.placed.questions]
        return "\n".join(lines).rstrip() + "\n"

    def write(self, folder: Path) -> Path:
        """Write the mapping file into a folder; its path. Raises DumpError where there is one, or nothing to say."""
        self.dump()
        path = folder / MAPPING
        try:
            return write_text(path, self.mapping(folder), DumpError, put_new)
        except FileExistsError:
            raise DumpError(told(str(path), "a new file", "one that is there", "remove or rename it")) from None


def recognized(source: Path, oracle: Result, folder: Path | None = None) -> Recognized:
    """The pictures of a folder or a capture, placed among the buffers of a rendering that has them all.

    folder: where those of a capture are written, which must be there. Raises DumpError.
    """
    surfaces, notes = captured(source, folder) if folder else surfaces_of(source)
    return Recognized(folder or source, oracle, place(surfaces, oracle), tuple(notes))


def _ways(each: Placement) -> list[str]:
    """How it is stored, where that is not the usual way."""
    keys: dict[str, Any] = dict(each.candidate.keys)
    rows = f"rows from the {each.candidate.origin}"
    return [rows, *(f"{key} {value}" for key, value in keys.items())]
