"""The container: JSON as glTF allows it, and GLB's chunks (glTF 2.0, 4)."""

import json
import struct

import numpy as np
import pytest
from gltf_files import CORNERS, glb, message, tetrahedron

from sss_ref.mesh import untrusted
from sss_ref.scene import load_mesh

AGAIN = "; export the mesh again"
NO_DOCUMENT = {
    b"[1]": "JSON that is no object",
    b"": "JSON that breaks off at line 1, column 1",
    b'{"a": 1,\n "b"': "JSON that breaks off at line 2, column 5",
    b"\xff": "bytes that are not UTF-8",
    b"[" * 10**5: "JSON that is nested too deep",
    b'{"a": NaN}': "JSON with the number NaN",
    b'{"a": -Infinity}': "JSON with the number -Infinity",
    b'{"a": {"b": 1, "b": 2}}': 'JSON with the key "b" twice',
    b'{"%b": 1, "%b": 2}' % (b"k" * 99, b"k" * 99): f'JSON with the key "{"k" * 59} twice',
    b'{"a": ' + b"1" * 5000 + b"}": "JSON with a number of too many digits",
}


@pytest.mark.parametrize("text, came", NO_DOCUMENT.items(), ids=range(len(NO_DOCUMENT)))
def test_what_is_no_document(tmp_path, text, came):
    (tmp_path / "a.gltf").write_bytes(text)
    assert message(tmp_path / "a.gltf") == f"expected a valid glTF document, got {came}{AGAIN}"


def test_byte_order_mark(tmp_path):
    path = tetrahedron().written(tmp_path)
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())
    assert np.array_equal(load_mesh(path).positions, CORNERS)


def test_the_content_says_which_of_the_two_it_is(tmp_path):
    for name, other in (("a.gltf", "b.glb"), ("c.glb", "d.gltf")):
        (tmp_path / other).write_bytes(tetrahedron().written(tmp_path, name).read_bytes())
        assert np.array_equal(load_mesh(tmp_path / other).positions, CORNERS)


def chunked(*chunks, version=2, size=None):
    body = b"".join(struct.pack("<I4s", len(content), kind) + content for kind, content in chunks)
    return struct.pack("<4sII", b"glTF", version, 12 + len(body) if size is None else size) + body


def parts():
    """The JSON and the bytes of the tetrahedron."""
    return json.dumps(tetrahedron().document({})).encode(), tetrahedron().binary


def test_chunks_that_are_not_known_are_passed_over(tmp_path):
    text, binary = parts()
    path = tmp_path / "a.glb"
    path.write_bytes(chunked((b"JSON", text), (b"BIN\0", binary), (b"XYZ ", b"abcd")))
    assert np.array_equal(load_mesh(path).positions, CORNERS)


def test_bytes_behind_the_end_are_noted(tmp_path):
    path = tmp_path / "a.glb"
    path.write_bytes(glb(*parts()) + b"more")
    assert load_mesh(path).notes == ("4 bytes behind the file's declared end are not used",)


def bad_containers():
    text, binary = parts()
    whole = chunked((b"JSON", text), (b"BIN\0", binary))
    yield whole[:-1], f"expected the {len(whole)} bytes it declares, got {len(whole) - 1}; copy or export it again"
    yield chunked((b"BIN\0", binary)), f"expected a GLB file that begins with JSON, got another chunk or none{AGAIN}"
    yield chunked(), f"expected a GLB file that begins with JSON, got another chunk or none{AGAIN}"
    yield b"glTF\1\0\0\0", "expected version 2 of GLB, for glTF 2.0, got version 1, of glTF 1.0; convert it to glTF 2.0"
    yield (
        chunked((b"JSON", text), version=1),
        "expected version 2 of GLB, for glTF 2.0, got version 1, of glTF 1.0; convert it to glTF 2.0",
    )
    short = chunked((b"JSON", b"{}  ")).replace(b"\4\0\0\0JSON", b"\5\0\0\0JSON")
    yield short, f"expected a chunk of 5 bytes, got 4 before the end{AGAIN}"


@pytest.mark.parametrize("content, expected", [*bad_containers()], ids=range(6))
def test_bad_container(tmp_path, content, expected):
    (tmp_path / "a.glb").write_bytes(content)
    assert message(tmp_path / "a.glb") == expected


def test_text_has_a_lower_limit(tmp_path, monkeypatch):
    path = tetrahedron().written(tmp_path)
    size = path.stat().st_size
    monkeypatch.setattr(untrusted, "TEXT_LIMIT", size - 1)
    assert message(path) == f"expected at most {size - 1} bytes of text, got {size}; convert it to a binary format"
