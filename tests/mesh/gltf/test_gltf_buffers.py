"""Bytes of buffers: in the document, beside it, in a GLB file; never from elsewhere, never more than there are."""

import base64
import json
import os

import numpy as np
import pytest
from gltf_files import CORNERS, GltfBuilder, glb, message, refusal, tetrahedron

from sss_ref.mesh import untrusted
from sss_ref.scene import load_mesh

AGAIN = "; export the mesh again"


@pytest.fixture
def folder(tmp_path):
    """A folder with the tetrahedron's buffer in it, and a secret beside it: the same, so that reading it would work."""
    inside = tmp_path / "inside"
    inside.mkdir()
    content = tetrahedron().binary
    (inside / "own.bin").write_bytes(content)
    (tmp_path / "secret.bin").write_bytes(content)
    (inside / "link.bin").symlink_to(tmp_path / "secret.bin")
    (inside / "linked").symlink_to(tmp_path)
    return inside


def referring(folder, uri, **buffer):
    path = folder / "a.gltf"
    path.write_text(json.dumps(tetrahedron().document({"uri": uri, **buffer})))
    return path


def embedded(content):
    return "data:application/octet-stream;base64," + base64.b64encode(content).decode()


def test_references_inside_the_folder(folder):
    (folder / "b c").mkdir()
    (folder / "b c" / "d.bin").write_bytes(tetrahedron().binary)
    (folder / "same.bin").symlink_to(folder / "own.bin")
    data = embedded(tetrahedron().binary)
    for uri in ("own.bin", "./own.bin", "b c/d.bin", "b%20c/d.bin", "same.bin", data, data.replace("octet", "x")):
        assert np.array_equal(load_mesh(referring(folder, uri)).positions, CORNERS)


OUTSIDE = [
    "../secret.bin",
    "%2e%2e/secret.bin",
    "b/../../secret.bin",
    "..\\secret.bin",
    "/{}/secret.bin",
    "file:///{}/secret.bin",
    "http://localhost/secret.bin",
    "C:\\secret.bin",
    "\\\\server\\secret.bin",
    "link.bin",
    "linked/secret.bin",
]


@pytest.mark.parametrize("uri", OUTSIDE)
def test_references_outside_the_folder(folder, uri):
    uri = uri.format(str(folder.parent).lstrip("/"))
    shown = json.dumps(uri)
    shown = shown if len(shown) <= 60 else f"{shown[:57]}..."
    refused = f"expected references to files in its own folder, got {shown}; copy the file there"
    assert message(referring(folder, uri)) == refused


def test_images_are_not_opened(folder):
    """Wherever they are said to be, and whatever they are: only colours of materials are used."""
    builder = tetrahedron(images=[{"uri": "../secret.bin"}, {"bufferView": 99}, 3], textures="none")
    assert np.array_equal(builder.loaded(folder).positions, CORNERS)


def test_reference_to_nothing(folder):
    assert message(referring(folder, "none.bin")) == 'expected a file "none.bin" beside it, got none; put it there'
    os.mkfifo(folder / "pipe.bin")  # reading it would wait for ever
    assert message(referring(folder, "pipe.bin")) == 'expected a file "pipe.bin" beside it, got none; put it there'


@pytest.mark.parametrize(
    "uri", ["data:text/plain,abc", "data:;base64,@@@@", "data:;base64,AAA", "data:;base64,Ä", "data:"]
)
def test_data_that_is_not_base64(folder, uri):
    assert message(referring(folder, uri)) == f"buffers[0].uri: expected data in base64, got {uri}...{AGAIN}"


def test_of_long_data_that_is_not_base64_the_first_40_letters_are_told(folder):
    told = message(referring(folder, "data:;base64," + "@" * 60))
    assert told == f"buffers[0].uri: expected data in base64, got data:;base64,{'@' * 27}...{AGAIN}"


def test_referenced_bytes_are_limited_together(folder, monkeypatch):
    builder = tetrahedron()
    builder.tables["bufferViews"][1]["buffer"] = 1
    size = len(builder.binary)
    document = builder.document({"uri": "own.bin"})
    document["buffers"].append({"uri": "own.bin", "byteLength": size})
    (folder / "a.gltf").write_text(json.dumps(document))
    monkeypatch.setattr(untrusted, "BYTE_LIMIT", 2 * size - 1)
    assert message(folder / "a.gltf") == (
        f'expected at most {2 * size - 1} bytes in the files it refers to, got "own.bin"; simplify the mesh'
    )
    monkeypatch.setattr(untrusted, "BYTE_LIMIT", 2 * size)
    assert len(load_mesh(folder / "a.gltf").triangles) == 4


def test_buffer_that_is_shorter_than_declared(folder):
    size = len(tetrahedron().binary)
    expected = f"buffers[0]: expected the {size + 1} bytes it declares, got {size}; copy or export it again"
    assert message(referring(folder, "own.bin", byteLength=size + 1)) == expected
    assert message(referring(folder, embedded(tetrahedron().binary), byteLength=size + 1)) == expected


def test_buffer_may_be_longer_than_declared(folder):
    (folder / "own.bin").write_bytes(tetrahedron().binary + b"more")
    assert len(load_mesh(referring(folder, "own.bin")).triangles) == 4


def test_view_beyond_its_buffer(tmp_path):
    builder = tetrahedron()
    builder.tables["bufferViews"][1]["byteOffset"] = 52
    assert refusal(builder, tmp_path) == f"bufferViews[1]: expected 76 bytes in buffers[0], got 72{AGAIN}"


def test_no_such_buffer(tmp_path):
    builder = tetrahedron()
    builder.tables["bufferViews"][0]["buffer"] = 1
    assert refusal(builder, tmp_path) == (
        f"bufferViews[0].buffer: expected the number of one of the buffers, got 1 of 1 (they count from 0){AGAIN}"
    )


def test_buffer_without_uri(tmp_path):
    path = tmp_path / "a.gltf"
    path.write_text(json.dumps(tetrahedron().document({})))
    assert message(path) == f"buffers[0]: expected a uri, got none{AGAIN}"


def test_glb_chunk_is_the_first_buffer_alone(tmp_path):
    assert np.array_equal(tetrahedron().loaded(tmp_path, "a.glb").positions, CORNERS)
    builder = tetrahedron()
    builder.tables["bufferViews"][0]["buffer"] = 1
    document = builder.document({})
    document["buffers"] *= 2
    path = tmp_path / "b.glb"
    path.write_bytes(glb(json.dumps(document).encode(), builder.binary))
    assert message(path) == f"buffers[1]: expected a uri, got none{AGAIN}"


@pytest.mark.parametrize("name", ["EXT_meshopt_compression", "KHR_meshopt_compression"])
def test_meshopt(tmp_path, name):
    """A fallback buffer with data is used; one without is refused by the extension's name."""
    builder = tetrahedron(extensionsUsed=[name], extensionsRequired=[name])
    compressed = {"buffer": 0, "byteLength": 4, "byteStride": 12, "count": 4, "mode": "ATTRIBUTES"}
    builder.tables["bufferViews"][0] |= {"buffer": 1, "extensions": {name: compressed}}
    document = builder.document({"uri": embedded(builder.binary)})
    fallback = {"byteLength": len(builder.binary), "extensions": {name: {"fallback": True}}}
    path = tmp_path / "a.gltf"
    path.write_text(json.dumps(document | {"buffers": [*document["buffers"], fallback]}))
    refused = f"bufferViews[0]: expected uncompressed data, got {name} alone; export it without compression"
    assert message(path) == refused
    binary = tmp_path / "a.glb"
    binary.write_bytes(glb(json.dumps(document | {"buffers": [{"byteLength": 72}, fallback]}).encode(), builder.binary))
    assert message(binary) == refused
    path.write_text(
        json.dumps(document | {"buffers": [document["buffers"][0], fallback | {"uri": embedded(builder.binary)}]})
    )
    assert np.array_equal(load_mesh(path).positions, CORNERS)


def test_unused_views_are_not_looked_at(tmp_path):
    """Those of an animation, say."""
    builder = GltfBuilder(bufferViews=["broken"], accessors=[{"sparse": 3}], animations=[{"samplers": [{"input": 0}]}])
    builder.add("meshes", {"primitives": [builder.primitive()]})
    assert np.array_equal(builder.loaded(tmp_path).positions, CORNERS)


def test_a_view_that_is_compressed_as_well_is_read_where_its_bytes_are_there(tmp_path):
    """They are those of the GLB's chunk; without a chunk there is nothing but what is compressed."""
    builder = tetrahedron()
    for view in builder.tables["bufferViews"]:
        view["extensions"] = {"EXT_meshopt_compression": {}}
    assert np.array_equal(builder.loaded(tmp_path, "a.glb").positions, CORNERS)
    (tmp_path / "a.gltf").write_text(json.dumps(builder.document({})))
    expected = "expected uncompressed data, got EXT_meshopt_compression alone; export it without compression"
    assert message(tmp_path / "a.gltf").partition(": ")[2] == expected


def test_an_empty_chunk_is_one(tmp_path):
    """It holds no bytes, and is where a buffer without a uri has to be."""
    text = json.dumps(tetrahedron().document({})).encode()
    (tmp_path / "a.glb").write_bytes(glb(text, b""))
    size = len(tetrahedron().binary)
    expected = f"buffers[0]: expected the {size} bytes it declares, got 0; copy or export it again"
    assert message(tmp_path / "a.glb") == expected
