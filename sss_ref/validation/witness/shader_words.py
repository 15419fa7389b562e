"""What a stage reads as words in a shader: one array of bits, and functions that read values and texels out of it."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.interpret.shader import Dialect
from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.language.types import Texture
from sss_ref.validation.witness.bits_text import SIDES, WHOLE, bits_of, element_of, is_many
from sss_ref.validation.witness.element_runs import Place, runs_of
from sss_ref.validation.witness.situation import Situation

FLOATS, INTS, BOOLS = "WitnessFloats", "WitnessInts", "WitnessBools"  # structs that tell which texture is meant
ABSENT = -8  # the word of a texel that the witness has not: NaN, and so are those after it
WORD = """
uint witness_word(int k)
{
    return k < 0 ? 0x7fc00000u : WITNESS_WORDS[k] ^ witness_nothing;
}

float witness_float(int k)
{
    return uintBitsToFloat(witness_word(k));
}
"""
TEXELS = f"""
int witness_place(int map, ivec2 at)
{{
    for (int k = 0; k < WITNESS_RUN_COUNT; k++)
    {{
        ivec4 run = WITNESS_RUNS[k];
        int further = at.x - run.y;
        if (run.x == map && run.z == at.y && further >= 0 && further < run.w)
            return WITNESS_FIRST[k] + further * WITNESS_CHANNELS[map];
    }}
    return {ABSENT};
}}

struct {FLOATS} {{ int number; }};
struct {INTS} {{ int number; }};
struct {BOOLS} {{ int number; }};

vec4 witness_texel({FLOATS} map, ivec2 at)
{{
    int k = witness_place(map.number, at);
    int count = WITNESS_CHANNELS[map.number];
    float y = count > 1 ? witness_float(k + 1) : 0.0;
    float z = count > 2 ? witness_float(k + 2) : 0.0;
    float w = count > 3 ? witness_float(k + 3) : 0.0;
    return vec4(witness_float(k), y, z, w);
}}

ivec4 witness_texel({INTS} map, ivec2 at)
{{
    return ivec4(int(witness_word(witness_place(map.number, at))));
}}

uvec4 witness_texel({BOOLS} map, ivec2 at)
{{
    return uvec4(witness_word(witness_place(map.number, at)));
}}

ivec2 witness_size({FLOATS} map) {{ return WITNESS_SIZES[map.number]; }}
ivec2 witness_size({INTS} map) {{ return WITNESS_SIZES[map.number]; }}
ivec2 witness_size({BOOLS} map) {{ return WITNESS_SIZES[map.number]; }}
"""


@dataclass(frozen=True)
class TexelTable:
    """A texture, or an array as a row of texels. runs: column and row of the first, how many, and its first word."""

    number: int
    size: tuple[int, int]
    channels: int
    runs: tuple[tuple[int, int, int, int], ...]


@dataclass(frozen=True)
class ShaderWords:
    """words: the bits. first: parameter -> its first word. tables: parameter -> its table, of textures and arrays."""

    words: tuple[str, ...]
    first: Mapping[str, int]
    tables: Mapping[str, TexelTable]

    @classmethod
    def of(cls, situation: Situation, read: Mapping[str, Iterable[Place]]) -> "ShaderWords":
        """What a stage reads; read: as `Situation.reads` has it."""
        words: list[str] = []
        first: dict[str, int] = {}
        tables: dict[str, TexelTable] = {}
        for own, kind in situation.stage.parameters.items():
            if is_many(kind):
                tables[own] = _table(len(tables), kind, situation.exact[own], read[own], words)
            else:
                first[own] = len(words)
                words += bits_of(kind, situation.exact[own]).split()
        return cls(tuple(words), first, tables)

    @property
    def lines(self) -> list[str]:
        """The uniform that is 0, the tables, and the functions that read them."""
        text = "\n".join([_array("uint", "WORDS", [f"0x{word}u" for word in self.words or ["0"]]), WORD])
        uniform = "uniform uint witness_nothing;"
        return [uniform, *text.splitlines(), *(self._table_lines if self.tables else [])]

    @property
    def _table_lines(self) -> list[str]:
        tables = list(self.tables.values())
        runs = self.runs
        return [
            _array("ivec2", "SIZES", [f"ivec2({width}, {height})" for width, height in (each.size for each in tables)]),
            _array("int", "CHANNELS", [str(each.channels) for each in tables]),
            _array("ivec4", "RUNS", [f"ivec4({', '.join(map(str, run[:4]))})" for run in runs]),
            _array("int", "FIRST", [str(run[4]) for run in runs]),
            f"const int WITNESS_RUN_COUNT = {len(runs)};",
            *TEXELS.splitlines(),
        ]

    @property
    def runs(self) -> list[tuple[int, int, int, int, int]]:
        """Each run of a table: its number, column and row of the first, how many, and its first word; never none."""
        return [(each.number, *run) for each in self.tables.values() for run in each.runs] or [(ABSENT, 0, 0, 0, 0)]

    def argument(self, own: str, kind: Any, dialect: Dialect) -> str:
        """What the stage is handed for a parameter."""
        if own in self.tables:
            return f"{dialect.textures[element_of(kind)]}({self.tables[own].number})"
        first = self.first[own]
        if kind in SIDES:
            side = SIDES[kind]
            order = [first + row * side + column for column in range(side) for row in range(side)]
        else:
            order = [first + k for k in range(CHANNELS[kind])]
        values = ", ".join(_read(kind, k, dialect) for k in order)
        return values if len(order) == 1 else f"{dialect.types[kind]}({values})"


def _read(kind: Any, k: int, dialect: Dialect) -> str:
    if kind is bool:
        return f"witness_word({k}) != 0u"
    return f"{dialect.types[int]}(witness_word({k}))" if kind in WHOLE else f"witness_float({k})"


def _table(number: int, kind: Any, held: Any, read: Iterable[Place], words: list[str]) -> TexelTable:
    """The table of a texture or array; its words are added to the others."""
    element, runs = element_of(kind), []
    for first, count in runs_of(read):
        (*row, column) = first
        runs.append((column, row[0] if row else 0, count, len(words)))
        words += _bits(element, held.data[(*row, slice(column, column + count))])
    height, width = held.data.shape[:2] if isinstance(held, Texture) else (1, len(held.data))
    return TexelTable(number, (width, height), CHANNELS[element], tuple(runs))


def _bits(element: Any, values: np.ndarray) -> list[str]:
    """The words of some elements, in order."""
    plain = np.ravel(values).astype(np.float32 if dtype_of(element).kind == "f" else np.int32)
    return [f"{word:08x}" for word in plain.view(np.uint32).tolist()]


def _array(kind: str, name: str, values: list[str]) -> str:
    return f"const {kind} WITNESS_{name}[{len(values)}] = {kind}[{len(values)}]({', '.join(values)});"
