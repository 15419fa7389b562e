"""Which part of a file is a buffer's, and which of its channels: as the mapping says, or as the names do."""

from collections.abc import Iterable

from sss_ref.dump.sources import Source
from sss_ref.dump.texels import StoredTexels
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

USUAL_NAMES = {1: ("R", "Y", "Z"), 2: ("RG", "UV", "XY"), 3: ("RGB", "XYZ")}  # by count
PLACES = ("RGBA", "XYZW", "STPQ", "UV")  # letters that stand for the first channel, the second ...

Chosen = tuple[StoredTexels, tuple[str, ...]]


def chosen(source: Source, parts: tuple[StoredTexels, ...], count: int) -> Chosen:
    """The part that is the buffer's, and the names of its channels, `count` of them. Raises DumpError."""
    candidates = _parts_named(source, parts)
    for texels in candidates:
        names = _channels(source, texels, count)
        if names:
            if len(names) != count:
                remedy = "name as many as the buffer has"
                raise DumpError(told(source.at("channels"), f"{count} channels", ", ".join(names), remedy))
            _check_whole(source, texels, names)
            return texels, names
    raise DumpError(_not_found(source, candidates, count))


def _check_whole(source: Source, texels: StoredTexels, names: tuple[str, ...]) -> None:
    """Raise DumpError for channels that their file's compression has changed, nobody knows how far."""
    changed = [name for name in names if name in texels.spoiled]
    if changed:
        kind = texels.spoiled[changed[0]]
        came = f"{', '.join(changed)} changed by the compression {kind}"
        remedy = "no bound is known for it; save with ZIP, PIZ or no compression"
        raise DumpError(told(str(source.path), "channels as they were drawn", came, remedy))


def _not_found(source: Source, candidates: list[StoredTexels], count: int) -> str:
    """Why no part has the channels: they are of several types, or not there."""
    there = {name: texels.storage for texels in candidates for name in texels.channels}
    wanted = _usual(tuple(there), count) if source.table.channels is None else source.table.channels
    if wanted and set(wanted) <= there.keys():
        came = ", ".join(f"{name} {there[name]}" for name in wanted)
        remedy = "write them in one type"
        return told(source.at("channels"), f"one type for {', '.join(wanted)} in {source.path.name}", came, remedy)
    expected = ", ".join(source.table.channels) if source.table.channels else f"{count} channels with usual names"
    remedy = "name those of the buffer"
    return told(source.at("channels"), f"{expected} in {source.path.name}", ", ".join(there), remedy)


def _parts_named(source: Source, parts: tuple[StoredTexels, ...]) -> list[StoredTexels]:
    """The part or layer that was asked for, or the only one, or the one with the buffer's name (one piece per type)."""
    names = list(dict.fromkeys(texels.part for texels in parts))
    wanted = source.table.part
    if wanted is None:
        layers = _layers_named(source.name, parts)
        if layers:
            return layers
        wanted = names[0] if len(names) == 1 else source.name
    elif isinstance(wanted, int) and str(wanted) not in names and 0 <= wanted < len(names):
        wanted = names[wanted]
    found = [texels for texels in parts if texels.part == str(wanted)] or _layers_named(str(wanted), parts)
    if not found:
        expected = f"the part {wanted} in {source.path.name}"
        more = [] if len(names) > 1 else _layer_names(parts)
        there = ", ".join(dict.fromkeys([*names, *more])) or "none"
        raise DumpError(told(source.at("part"), expected, there, "name one of these"))
    return found


def _layers_named(name: str, parts: Iterable[StoredTexels]) -> list[StoredTexels]:
    return [layer for texels in parts if texels.are_named and (layer := texels.layer(name))]


def _layer_names(parts: Iterable[StoredTexels]) -> list[str]:
    """What stands before the last dot of the channels' names."""
    named = (name.rpartition(".")[0] for texels in parts if texels.are_named for name in texels.channels)
    return [name for name in named if name]


def _channels(source: Source, texels: StoredTexels, count: int) -> tuple[str, ...] | None:
    """The channels that are the buffer's; None where the part has them not."""
    wanted = source.table.channels
    if wanted is None:
        return _usual(texels.channels, count)
    named = _by_ending(wanted, texels.channels) if texels.are_named else _by_place(wanted)
    return named if set(named) <= set(texels.channels) else None


def _by_ending(wanted: tuple[str, ...], there: tuple[str, ...]) -> tuple[str, ...]:
    """The channels by their names, or by what follows the last dot if one alone has it."""
    endings = [name.rpartition(".")[2] for name in there]
    return tuple(
        there[endings.index(name)] if name not in there and endings.count(name) == 1 else name for name in wanted
    )


def _by_place(wanted: tuple[str, ...]) -> tuple[str, ...]:
    """The channels by the letters of one family, as R, G, B, A."""
    for letters in PLACES:
        if {name.upper() for name in wanted} <= set(letters):
            return tuple(PLACES[0][letters.index(name.upper())] for name in wanted)
    return wanted


def _usual(there: tuple[str, ...], count: int) -> tuple[str, ...] | None:
    """The channels that a buffer of so many is commonly written to; None where the names say nothing.

    If none has such a name as a whole, what follows the last dot counts, as long as only one layer has them.
    """
    layers: dict[str, dict[str, str]] = {}
    for name in there:
        layer, _, letter = name.rpartition(".")
        layers.setdefault(layer, {})[letter.upper()] = name
    found = {layer: _of_letters(by_letter, count) for layer, by_letter in layers.items()}
    fitting = [names for names in found.values() if names]
    if found.get("") or len(fitting) == 1:
        return found.get("") or fitting[0]
    return there if len(there) == count == 1 else None


def _of_letters(by_letter: dict[str, str], count: int) -> tuple[str, ...] | None:
    for letters in USUAL_NAMES[count]:
        if set(letters) <= by_letter.keys():
            return tuple(by_letter[letter] for letter in letters)
    return None
