"""Files of a format with something changed at random that their checks do not give away: headers, chunks, trees.

What is changed at random may be as good as before; `HARMLESS` are changes that must not matter.
"""

import ast
import io
import json
import struct
import tomllib
import zipfile
import zlib

import changed_bytes
from changed_values import TEXT_CHANGES, nested, picked, toml_text, tree_changed
from gltf_files import glb


def changed(rng, name, data):
    """The bytes of a file, `name` by its suffix, with one place changed, and what was done."""
    suffix = "." + name.rpartition(".")[2]
    change = picked(rng, (changed_bytes.CHANGES, *OF_SUFFIX.get(suffix, ()), *OF_SUFFIX.get(suffix, ())))
    if isinstance(change, tuple):
        change = picked(rng, change)
    try:
        return (change(rng, data) if data else b"\0"), change.__name__
    except Exception:
        return changed_bytes.one_byte(rng, data), "one_byte"  # an earlier change has broken the form


def text_changed(rng, data):
    """A file of text, of which a line, a number or a word is another."""
    return picked(rng, TEXT_CHANGES)(rng, data.decode("utf-8", "surrogateescape")).encode("utf-8", "surrogateescape")


def head_changed(rng, data):
    """The text before binary data."""
    head, end, body = data.partition(b"end_header\n")
    return text_changed(rng, head) + end + body


def json_changed(rng, data):
    """A place of a JSON file."""
    return json.dumps(tree_changed(rng, json.loads(data))).encode()


def toml_changed(rng, data):
    """A place of a TOML file."""
    return toml_text(tree_changed(rng, tomllib.loads(data.decode()))).encode("utf-8", "surrogatepass")


def brackets_nested(rng, data):
    """Very many brackets in a text."""
    return nested(rng, data.decode()).encode()


def glb_changed(rng, data):
    """A place of a GLB file's document, its chunks whole."""
    (length,) = struct.unpack_from("<I", data, 12)
    return glb(json_changed(rng, data[20 : 20 + length]), data[28 + length :])


def glb_binary_changed(rng, data):
    """Bytes of a GLB file's binary chunk, its document whole."""
    (length,) = struct.unpack_from("<I", data, 12)
    body = picked(rng, changed_bytes.CHANGES)(rng, data[28 + length :])
    return glb(data[20 : 20 + length], body)


def chunks(data):
    """Type and content of the chunks of a PNG file."""
    at = 8
    while at < len(data):
        (length,) = struct.unpack_from(">I", data, at)
        yield data[at + 4 : at + 8], data[at + 8 : at + 8 + length]
        at += 12 + length


def png(parts):
    """A PNG file of chunks, their checksums right."""
    checked = (
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body)) for kind, body in parts
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(checked)


def png_chunk_changed(rng, data):
    """A chunk of a PNG file is other, missing, doubled or elsewhere; the checksums are right."""
    parts = list(chunks(data))
    at, kind = rng.randrange(len(parts)), rng.randrange(6)
    if kind == 0:
        del parts[at]
    elif kind == 1:
        parts.insert(rng.randrange(len(parts)), parts[at])
    elif kind == 2:
        parts[at] = (rng.randbytes(4), parts[at][1])
    elif parts[at][1]:
        parts[at] = parts[at][0], picked(rng, changed_bytes.CHANGES)(rng, parts[at][1])
    return png(parts)


def png_rows_changed(rng, data):
    """What a PNG file has compressed is other; all around it is right."""
    parts = list(chunks(data))
    rows = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    rows = zlib.compress(picked(rng, changed_bytes.CHANGES)(rng, rows))
    return png([*(each for each in parts if each[0] not in (b"IDAT", b"IEND")), (b"IDAT", rows), (b"IEND", b"")])


def npy_changed(rng, data):
    """A place of an NPY file's header, its length right."""
    (length,) = struct.unpack_from("<H", data, 8)
    header = ast.literal_eval(data[10 : 10 + length].decode().strip())
    as_lists = json.loads(json.dumps(header))
    if rng.random() < 0.5:
        text = repr(tree_changed(rng, as_lists)).replace("[", "(").replace("]", ",)").replace("(,)", "()")
    else:
        descr = picked(
            rng, ("<f4", ">f4", "<f8", "<f2", "<c8", "|O", "|S4", "<U1", "<M8[D]", "|V4", "|u1", "<i8", [("a", "<f4")])
        )
        text = repr(header | {"descr": descr, "fortran_order": rng.random() < 0.5})
    body = text.encode("utf-8", "replace")[:60000] + b"\n"
    return data[:8] + struct.pack("<H", len(body)) + body + data[10 + length :]


def archive_instead(rng, data):
    """An NPZ file under the name of an NPY file: NumPy reads either, whatever the name."""
    return npz({"arr_0.npy": data})


def members(data):
    """Name and content of the files in an NPZ file."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def npz(files, compression=zipfile.ZIP_STORED):
    """An NPZ file of such files."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", compression) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name), content, compression)
    return made.getvalue()


def npz_array_changed(rng, data):
    """A place of an array's header or content in an NPZ file; the checksums are right."""
    files = members(data)
    name = picked(rng, sorted(files))
    change = picked(rng, (npy_changed, npy_changed, *changed_bytes.CHANGES))
    return npz(files | {name: change(rng, files[name])})


def npz_member_changed(rng, data):
    """An array of an NPZ file is missing, has another name, or is another's."""
    files = members(data)
    name, other = picked(rng, sorted(files)), picked(rng, sorted(files))
    content = files.pop(name)
    return npz(picked(rng, (files, files | {f"x{name}": content}, {**files, name: content, other: content})))


OF_SUFFIX = {
    ".toml": (text_changed, toml_changed, toml_changed, brackets_nested),
    ".obj": (text_changed, text_changed),
    ".mtl": (text_changed,),
    ".off": (text_changed, text_changed),
    ".stl": (text_changed,),
    ".ply": (text_changed, head_changed, head_changed),
    ".gltf": (text_changed, json_changed, json_changed, json_changed, brackets_nested),
    ".json": (text_changed, json_changed, json_changed, brackets_nested),
    ".glb": (glb_changed, glb_changed, glb_changed, glb_binary_changed),
    ".png": (png_chunk_changed, png_rows_changed),
    ".npy": (npy_changed, npy_changed, archive_instead),
    ".npz": (npz_array_changed, npz_array_changed, npz_member_changed),
    ".pfm": (text_changed,),
    ".ipynb": (text_changed, json_changed, json_changed, brackets_nested),
    ".frag": (text_changed,),
}
