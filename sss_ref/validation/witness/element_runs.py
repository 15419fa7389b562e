"""Elements of textures and arrays that lie side by side: runs in a row, and blocks of rows; blocks as text."""

from collections.abc import Iterable, Iterator

Place = tuple[int, ...]  # (row, column) of a texture, (index,) of an array
Index = tuple[slice, ...]  # a block of a texture, or of an array


def runs_of(elements: Iterable[Place]) -> Iterator[tuple[Place, int]]:
    """The first element of each run and how many it has, row by row."""
    runs: list[list[Place]] = []
    for at in sorted(elements):
        if runs and (*runs[-1][-1][:-1], runs[-1][-1][-1] + 1) == at:
            runs[-1].append(at)
        else:
            runs.append([at])
    yield from ((run[0], len(run)) for run in runs)


def blocks_of(elements: Iterable[Place]) -> list[Index]:
    """The elements in as few blocks as runs of equal length above each other make."""
    heights: dict[tuple[Place, int], int] = {}  # the lowest run of each block -> how many rows it has
    for first, count in runs_of(elements):
        below = next((run for run, height in heights.items() if run == (_lower(first, height), count)), None)
        if below:
            heights[below] += 1
        else:
            heights[first, count] = 1
    return [_index(first, count, height) for (first, count), height in heights.items()]


def _lower(at: Place, rows: int) -> Place:
    return (at[0] - rows, *at[1:]) if len(at) > 1 else ()


def _index(first: Place, count: int, height: int) -> Index:
    (*row, column) = first
    return (*(slice(each, each + height) for each in row), slice(column, column + count))


def blocks_text(blocks: Iterable[Index]) -> str:
    """Blocks as a text: of each its first element and its size, "column,row*2x2", or "index*13" of an array."""
    return " ".join(_text(block) for block in blocks)


def _text(block: Index) -> str:
    axes = list(reversed(block))
    return f"{','.join(str(each.start) for each in axes)}*{'x'.join(str(each.stop - each.start) for each in axes)}"


def blocks_in(text: str) -> list[Index]:
    """The blocks in such a text. Raises ValueError for what is none."""
    return [_block(*word.partition("*")) for word in text.split()]


def _block(first: str, _: str, size: str) -> Index:
    starts, counts = ([int(number) for number in numbers] for numbers in (first.split(","), size.split("x")))
    if min(starts) < 0 or min(counts) < 1:
        raise ValueError(first)
    return tuple(slice(start, start + count) for start, count in reversed([*zip(starts, counts, strict=True)]))


def shape_of_block(block: Index) -> tuple[int, ...]:
    """How many elements a block has along each axis."""
    return tuple(each.stop - each.start for each in block)
