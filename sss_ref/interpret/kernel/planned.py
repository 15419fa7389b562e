"""A pass as a program: what its draw gives, its stages in order, and what of it is kept."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, get_args, get_origin

import numpy as np

from sss_ref.interpret.kernel import fragment_rows
from sss_ref.interpret.kernel.fragment_rows import PACK, PUTS, TAKES, put_words, take_words
from sss_ref.interpret.kernel.lower import scalar_kind, suffixes
from sss_ref.interpret.kernel.modules import address_of, code_of
from sss_ref.interpret.kernel.program import COLUMN, EMPTY, INDEX, ROW, Program
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language.layout import CHANNELS, FLOAT32, dtype_of
from sss_ref.language.pipeline import PIXEL, Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import Array, Texture


class StagePlan:
    """A program of stages.

    read: name -> what stages read that is a uniform, a texture or an array, as in `Work`. fragments: name -> array with
    a value for each fragment, (N,) or (N, C), N in order of the index. values: name -> its rows, of what is there.
    """

    def __init__(self, read: Mapping[str, Any], fragments: Mapping[str, np.ndarray], last: Mapping[str, int]) -> None:
        self.program = Program()
        self.read, self.fragments, self.last = read, fragments, last
        self.values: dict[str, list[int]] = {PIXEL: [COLUMN, ROW]}

    def stage(self, stage: Stage) -> None:
        """Run a stage: its outputs are there afterwards."""
        values = {own: kind for own, kind in stage.parameters.items() if get_origin(kind) not in (Texture, Array)}
        rows = {own: self.rows_of(stage.reads[own], kind) for own, kind in values.items()}
        uniform = [own for own in values if rows[own] is None]
        code = code_of(stage, frozenset(uniform))
        outputs = self.program.rows(code.outputs)
        others = self.program.rows(code.others)
        own_rows = [row for own in values for row in rows[own] or ()] + outputs + others
        uniforms = [self.uniform(stage.reads[own], values[own]) for own in uniform]
        tables = [
            number
            for own, kind in stage.parameters.items()
            if own not in values
            for number in self.memory(stage.reads[own], kind)
        ]
        for address, call in code.calls:
            if call.elementary:
                self.program.add(address, [own_rows[row] for row in call.rows], single=call.single)
            else:
                self.program.add(address, own_rows, uniforms, tables)
        self.program.give_back(others)
        self.name(stage, outputs)

    def name(self, stage: Stage, rows: list[int]) -> None:
        """Give the outputs of a stage their names."""
        for own, kind in stage.outputs.items():
            count = len(suffixes(kind))
            self.values[stage.writes[own]], rows = rows[:count], rows[count:]

    def rows_of(self, name: str, kind: Any) -> list[int] | None:
        """The rows of a value; None of a uniform."""
        if name not in self.values:
            if name not in self.fragments:
                return None
            self.values[name] = self.program.rows(CHANNELS[kind])
            self.move(TAKES.get(kind, take_words), self.fragments[name], kind, self.values[name])
        return self.values[name]

    def move(self, function: Any, array: np.ndarray, kind: Any, rows: Sequence[int]) -> None:
        """Move values between rows and a buffer."""
        tables = [self.program.address(contiguous(array, kind)), len(rows), 0, len(rows)]
        self.program.add(address_of(function), [INDEX, *rows], tables=tables)

    def put(self, name: str, array: np.ndarray, kind: Any) -> None:
        """Write the rows of a value into a buffer."""
        self.move(PUTS.get(kind, put_words), array, kind, self.values[name])

    def uniform(self, name: str, kind: Any) -> np.ndarray:
        """A uniform as float32 (N,), whole numbers by their bits."""
        dtype = FLOAT32 if scalar_kind(kind) is float else np.dtype(np.int32)
        return np.ravel(np.asarray(self.read[name], dtype)).view(FLOAT32)

    def memory(self, name: str, kind: Any) -> list[int]:
        """Address and size of a texture, or the address of an array."""
        array = contiguous(self.read[name], get_args(kind)[0])
        size = [array.shape[1], array.shape[0]] if get_origin(kind) is Texture else []
        return [self.program.address(array), *size]

    def forget(self, names: Iterable[str]) -> None:
        """Give back the rows of values; whoever reads one of them later gets what `fragments` has of it."""
        for name in names:
            self.program.give_back(self.values.pop(name))

    def read_no_more(self, after: int) -> list[str]:
        """What is read for the last time by the stage with this number, or before."""
        return [name for name in self.values if self.last.get(name, -1) <= after and name != PIXEL]


def contiguous(array: Any, kind: Any) -> np.ndarray:
    """An array of values of a type as it lies in memory, row after row."""
    return np.ascontiguousarray(array, dtype_of(kind))


def last_uses(stages: Sequence[Stage]) -> dict[str, int]:
    """Name -> the number of the last stage that reads it."""
    return {name: number for number, stage in enumerate(stages) for name in stage.reads.values()}


def planned(work: Work) -> Program:
    """The program of a pass on a strip of its fragments."""
    this_pass = work.this_pass
    fragments = {**work.buffers, **work.handed_on}
    plan = StagePlan({**work.uniforms, **work.buffers}, fragments, last_uses(this_pass.stages))
    if this_pass.draw.vertex_stages:
        draw_values(plan, this_pass, work.fragments, work.outputs)
    keep(plan, work, this_pass.draw.outputs)
    for number, stage in enumerate(this_pass.stages):
        plan.stage(stage)
        keep(plan, work, stage.writes.values())
        plan.forget([name for name in stage.writes.values() if name in work.handed_on])
        plan.forget(plan.read_no_more(number))
    return plan.program


def keep(plan: StagePlan, work: Work, names: Any) -> None:
    """Write those of some values into buffers that are wanted."""
    for name in names:
        if name in work.outputs:
            plan.put(name, work.outputs[name], work.this_pass.values[name])


def draw_values(plan: StagePlan, this_pass: Pass, fragments: Fragments, outputs: Mapping[str, Any]) -> None:
    """What a draw of the mesh gives each fragment: the varyings that are read, its triangle, its coverage."""
    program, draw = plan.program, this_pass.draw
    primitives, piece = fragments.of_mesh
    pieces = program.address(contiguous(piece, int))
    if fragments.varyings:
        corners = program.rows(7)
        arrays = [(primitives.corners, int), (primitives.snapped, int), (primitives.inverse_w, float)]
        tables = [pieces, *(program.address(contiguous(*each)) for each in arrays), fragments.step]
        program.add(address_of(fragment_rows.weights), [INDEX, COLUMN, ROW, *corners], tables=tables)
        values = interpolated(program, corners, contiguous(primitives.attributes, float))
        for name, first in fragments.varyings.items():
            plan.values[name] = values[first : first + CHANNELS[draw.varyings[name]]]
        program.give_back(corners)
    if draw.triangle in plan.last or draw.triangle in outputs:
        rows = plan.values[draw.triangle] = program.rows(1)
        triangles = program.address(contiguous(primitives.triangle, int))
        program.add(address_of(fragment_rows.triangle), [INDEX, *rows], tables=[pieces, triangles])
    if draw.coverage in plan.last or draw.coverage in outputs:
        rows = plan.values[draw.coverage] = program.rows(1)
        program.add(address_of(fragment_rows.same), rows, [np.ones(1, np.int32).view(FLOAT32)])


def interpolated(program: Program, corners: list[int], attributes: np.ndarray) -> list[int]:
    """The rows of all attributes, float32 (V, A), interpolated: whole packs of them first; corners: as in `weights`."""
    columns = attributes.shape[1]
    rows, block, packed = program.rows(columns), program.block(PACK), columns // PACK * PACK
    for first in range(0, packed, PACK):
        tables = [program.address(attributes), columns, first, PACK]
        pack = rows[first : first + PACK]
        program.add(address_of(fragment_rows.varying_pack), [*corners, *pack, block[0]], tables=tables)
    if packed < columns:
        tables = [program.address(attributes), columns, packed, columns - packed]
        program.add(address_of(fragment_rows.varying), [*corners, *rows[packed:]], tables=tables)
    program.give_back(block)
    return rows


def cleared(work: Work) -> Program:
    """The program that writes the backgrounds into the outputs that have one."""
    program = Program()
    for name, background in work.backgrounds.items():
        kind, buffer = work.this_pass.values[name], work.outputs[name]
        values = np.asarray(background, np.int32 if kind is bool else dtype_of(kind)).view(FLOAT32)
        channels = CHANNELS[kind]
        function = fragment_rows.clear_bytes if kind is bool else fragment_rows.clear_words
        tables = [program.address(buffer), channels, 0, channels]
        program.add(address_of(function), [EMPTY], [values], tables)
    return program
