"""Changes of files that must not matter: white space, comments, the order of keys, what a format says to pass over."""

import json
import struct
import tomllib
import zipfile
import zlib

from changed_files import chunks, glb, members, npz, png
from changed_values import NUMBER, picked, toml_text

REMARK = b"# 1 2 3 [a] v f {\n"


def harmless(rng, name, data):
    """The bytes of a file, `name` by its suffix, that mean the same, and what was done; None where nothing is known."""
    changes = OF_SUFFIX.get("." + name.rpartition(".")[2])
    if not changes:
        return None
    change = picked(rng, changes)
    return change(rng, data), change.__name__


def remarks_added(rng, data):
    """Comments and blank lines between lines."""
    lines = data.splitlines(keepends=True)
    for _ in range(rng.randint(1, 5)):
        lines.insert(rng.randint(1, len(lines)), picked(rng, (REMARK, b"\n", b" \t\n")))
    return b"".join(lines)


def other_line_ends(rng, data):
    """A carriage return before each end of a line."""
    return data.replace(b"\n", b"\r\n")


def blanks_at_the_ends(rng, data):
    """Blanks and tabs before the ends of lines."""
    return b"".join(line.rstrip(b"\n") + picked(rng, (b"", b" ", b"\t ")) + b"\n" for line in data.split(b"\n")[:-1])


def wider_blanks(rng, data):
    """Tabs or several blanks between words."""
    return data.replace(b" ", picked(rng, (b"\t", b"  ", b" \t ")))


def numbers_respelt(rng, data):
    """Decimal numbers with a plus, zeros behind, or an exponent."""

    def respelt(match):
        same = (match[0] + "0", f"{match[0]}e0", match[0] + "e+00", match[0] if match[0][0] in "+-" else f"+{match[0]}")
        return picked(rng, same) if "." in match[0] and "e" not in match[0].lower() else match[0]

    return NUMBER.sub(respelt, data.decode()).encode()


def lines_continued(rng, data):
    """Statements of OBJ on two lines."""
    return b"".join(
        line.replace(b" ", b" \\\n", 1) if rng.random() < 0.2 and not line.startswith(b"#") else line
        for line in data.splitlines(keepends=True)
    )


def toml_reordered(rng, data):
    """The tables of a TOML file the other way round, each in a line."""
    return toml_text(_reversed(tomllib.loads(data.decode()))).encode()


def json_respelt(rng, data):
    """A JSON file's keys the other way round, and other white space."""
    tables = json.loads(data)
    tables = _reversed(tables) if rng.random() < 0.5 else tables
    return json.dumps(tables, indent=picked(rng, (None, 1, "\t")), ensure_ascii=rng.random() < 0.5).encode()


def extras_added(rng, data):
    """What an application keeps in a glTF file for itself."""
    tables = json.loads(data)
    for place in (tables, *tables.get("meshes", ()), *tables.get("nodes", ()), *tables.get("accessors", ())):
        if rng.random() < 0.5:
            place["extras"] = {"a": [1, None, {"b": "c"}]}
    return json.dumps({**tables, "extensionsUsed": [*tables.get("extensionsUsed", []), "OWN_of_nobody"]}).encode()


def glb_respelt(rng, data):
    """A GLB file's document respelt."""
    (length,) = struct.unpack_from("<I", data, 12)
    return glb(picked(rng, (json_respelt, extras_added))(rng, data[20 : 20 + length]), data[28 + length :])


def ply_remark(rng, data):
    """A comment in the header."""
    lines = data.split(b"\n")
    last = lines.index(b"end_header")
    return b"\n".join(
        [*lines[:2], picked(rng, (b"comment element face 9", b"obj_info a 1 2")), *lines[2:last], *lines[last:]]
    )


def png_remark(rng, data):
    """A chunk that readers pass over."""
    first, *rest = chunks(data)
    return png([first, picked(rng, ((b"tEXt", b"Comment\0a"), (b"zzZz", b"\0\1"))), *rest])


def png_packed_otherwise(rng, data):
    """The rows of a PNG file compressed less, and in two chunks."""
    parts = list(chunks(data))
    rows = zlib.compress(zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT")), rng.randrange(10))
    at = rng.randrange(len(rows))
    others = [each for each in parts if each[0] not in (b"IDAT", b"IEND")]
    return png([*others, (b"IDAT", rows[:at]), (b"IDAT", rows[at:]), (b"IEND", b"")])


def npy_header_padded(rng, data):
    """An NPY file's header with more blanks."""
    (length,) = struct.unpack_from("<H", data, 8)
    header = data[10 : 10 + length - 1] + b" " * 64 * rng.randint(1, 9) + b"\n"
    return data[:8] + struct.pack("<H", len(header)) + header + data[10 + length :]


def dds_reserved(rng, data):
    """The words of a DDS file's header that are nobody's."""
    return data[:32] + rng.randbytes(44) + data[76:]


def npz_packed_otherwise(rng, data):
    """The arrays of an NPZ file compressed, or in another order."""
    return npz(_reversed(members(data)), picked(rng, (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)))


def _reversed(tree):
    """The same tables, the keys of each the other way round."""
    if isinstance(tree, dict):
        return {key: _reversed(value) for key, value in reversed(tree.items())}
    return [_reversed(each) for each in tree] if isinstance(tree, list) else tree


LINES = (remarks_added, other_line_ends, blanks_at_the_ends)
OF_SUFFIX = {
    ".toml": (*LINES, toml_reordered, toml_reordered),
    ".obj": (*LINES, wider_blanks, numbers_respelt, lines_continued),
    ".mtl": (*LINES, numbers_respelt),
    ".off": (*LINES, wider_blanks, numbers_respelt),
    ".ply": (ply_remark,),
    ".gltf": (json_respelt, extras_added),
    ".json": (json_respelt,),
    ".glb": (glb_respelt,),
    ".png": (png_remark, png_packed_otherwise),
    ".npy": (npy_header_padded,),
    ".npz": (npz_packed_otherwise,),
    ".ipynb": (json_respelt,),
    ".dds": (dds_reserved,),
}
