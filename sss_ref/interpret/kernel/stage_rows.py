"""A stage in lines, and the rows, uniforms and tables in which its values lie."""

from collections.abc import Collection
from dataclasses import dataclass
from functools import cached_property
from typing import Any, get_origin

from sss_ref.interpret.kernel.lines import Item, Line, Memory, RowCall, RowLoop, Scalar, Shared, StageLines, Value
from sss_ref.interpret.kernel.lower import Lowering, scalar_kind, suffixes
from sss_ref.language.stage import Stage
from sss_ref.language.types import Array, Texture

READ = {float: "read_float({0}, {1})", int: "read_int({0}, {1})", bool: "(read_int({0}, {1}) != 0)"}
OF_ARGUMENTS = ("scratch", "count", "rows", "uniforms", "tables")
OF_LOOPS = ("k", "middle", "apart", "last_apart", "next_apart", "low", "high", "side", "begin", "end")
OF_KERNELS = ("np", "chosen", *OF_ARGUMENTS, *OF_LOOPS)  # names that a module has itself


@dataclass(frozen=True)
class StageCall:
    """A call that a stage consists of, of a function of its module or of an elementary function of rows.

    rows: the numbers of the rows it gets, among those of the stage. single: whether it computes one element only.
    """

    function: str
    rows: tuple[int, ...] = ()
    elementary: bool = False
    single: bool = False


class StageRows:
    """The lines of a stage and what each of its names stands for.

    uniform: which parameters are uniforms; of the others all but textures and arrays have a row for each component.
    rows: name -> number of its row: those of the inputs, of the outputs, and of what is handed from part to part.
    """

    def __init__(self, stage: Stage, uniform: Collection[str]) -> None:
        self.lines = StageLines(Shared(set(OF_KERNELS)))
        self.rows: dict[str, int] = {}
        self.kinds: dict[str, type] = {}
        self.floats = self.tables = 0
        names = {own: self.parameter(own, kind, own in uniform) for own, kind in stage.parameters.items()}
        self.inputs = len(self.rows)
        results = Lowering(self.lines, names).run(stage.body)
        for own, scalars in results.items():
            for end, scalar in zip(suffixes(stage.outputs[own]), scalars, strict=True):
                self.output(own + end, scalar)
        self.outputs = len(self.rows) - self.inputs
        self.items: list[Item] = self.lines.items
        for item in self.items:
            self.kinds |= item.kinds

    def parameter(self, name: str, kind: Any, uniform: bool) -> Value:
        """What a parameter stands for."""
        if get_origin(kind) in (Texture, Array):
            return self.memory(name, kind)
        component = self.uniform if uniform else self.input
        return [component(name + end, scalar_kind(kind)) for end in suffixes(kind)]

    def input(self, name: str, kind: type) -> Scalar:
        """A component that has a row."""
        variable = self.lines.shared.fresh(name)
        self.rows[variable], self.kinds[variable] = len(self.rows), kind
        return Scalar(variable, kind, False, True, 0, frozenset({variable}))

    def uniform(self, name: str, kind: type) -> Scalar:
        """A component that is the same for all fragments: the next of the stage's uniforms."""
        self.floats += 1
        return self.lines.bind(name, Scalar(READ[kind].format("uniforms", self.floats - 1), kind, True, False))

    def memory(self, name: str, kind: Any) -> Memory:
        """A texture or array: the next of the stage's tables, a texture with its size behind it."""
        address = self.lines.bind(f"{name}_at", self.table("tables[{0}]"))
        sizes = ("width", "height") if get_origin(kind) is Texture else ()
        extent = [self.lines.bind(f"{name}_{size}", self.table("np.int32(tables[{0}])")) for size in sizes]
        return Memory(kind, address, tuple(extent))

    def table(self, template: str) -> Scalar:
        """The next number among the tables."""
        self.tables += 1
        return Scalar(template.format(self.tables - 1), int, True, False)

    def output(self, name: str, value: Scalar) -> None:
        """Give a component that the stage writes a row of its own."""
        if not value.atomic or value.uniform or value.text in self.rows:
            value = self.lines.bind(name, Scalar(value.text, value.kind, False, False, value.part, value.uses))
        self.rows[value.text] = len(self.rows)

    def row(self, name: str) -> int:
        """The number of the row of a value."""
        return self.rows.setdefault(name, len(self.rows))

    @cached_property
    def uniform_items(self) -> dict[str, Line | RowCall]:
        """Name -> what computes it, of all that is the same for all fragments."""
        return {
            name: item for item in self.items if not isinstance(item, RowLoop) and item.uniform for name in item.kinds
        }

    @property
    def parts(self) -> range:
        """The numbers of the parts."""
        return range(max((item.part for item in self.items), default=0) + 1)

    def lines_of(self, part: int) -> list[Line]:
        """What is computed for every fragment in a part."""
        return [item for item in self.items if isinstance(item, Line) and not item.uniform and item.part == part]

    def calls_after(self, part: int) -> list[RowCall | RowLoop]:
        """The functions of rows that come after a part."""
        return [item for item in self.items if not isinstance(item, Line) and item.part == part]

    def handed_on(self, part: int) -> list[str]:
        """The names of a part, each with a row, that are outputs or used after it."""
        names = [name for line in self.lines_of(part) for name in line.kinds]
        later = [item for item in self.items if item.part > part or (item.part == part and not isinstance(item, Line))]
        wanted = {name for item in later for name in item.uses} | set(self.rows)
        return [name for name in names if name in wanted]
