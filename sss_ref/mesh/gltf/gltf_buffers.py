"""The bytes of a glTF file's buffers and buffer views, held against their declared sizes."""

import base64
import binascii
from typing import Any

from sss_ref.mesh.gltf.gltf_document import AGAIN, GltfBuffer, GltfView
from sss_ref.mesh.gltf.gltf_file import GltfFile
from sss_ref.mesh.untrusted import OwnFolder

MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")
UNCOMPRESSED = "export it without compression"


class GltfBuffers:
    """Views by number; a buffer is read when a view of it is first used."""

    def __init__(self, file: GltfFile) -> None:
        self._document, self._binary = file.document, file.binary
        self._folder = OwnFolder(file.document.path)
        self._contents: dict[int, bytes] = {}

    def view(self, number: int, user: str) -> tuple[memoryview, GltfView]:
        """The bytes of a view, not copied, and the view."""
        view = self._document.entry(GltfView, number, user)
        place = f"bufferViews[{number}]"
        buffer = self._document.entry(GltfBuffer, view.buffer, f"{place}.buffer")
        if buffer.uri is None and not (view.buffer == 0 and self._binary is not None):
            self._refuse_compressed(place, view.extensions)
        content, end = self._content(view.buffer, buffer), view.byteOffset + view.byteLength
        if end > buffer.byteLength:
            raise self._document.refused(place, f"{end} bytes in buffers[{view.buffer}]", str(buffer.byteLength))
        return memoryview(content)[view.byteOffset : end], view

    def _refuse_compressed(self, place: str, extensions: dict[str, Any]) -> None:
        for name in MESHOPT:
            if name in extensions:
                raise self._document.refused(place, "uncompressed data", f"{name} alone", UNCOMPRESSED)

    def _content(self, number: int, buffer: GltfBuffer) -> bytes:
        if number not in self._contents:
            content = self._located(number, buffer)
            if len(content) < buffer.byteLength:
                expected, came = f"the {buffer.byteLength} bytes it declares", str(len(content))
                raise self._document.refused(f"buffers[{number}]", expected, came, "copy or export it again")
            self._contents[number] = content
        return self._contents[number]

    def _located(self, number: int, buffer: GltfBuffer) -> bytes:
        if buffer.uri is None:
            if number == 0 and self._binary is not None:
                return self._binary
            raise self._document.refused(f"buffers[{number}]", "a uri", "none", AGAIN)
        if buffer.uri.startswith("data:"):
            return self._embedded(number, buffer.uri)
        return self._folder.get(buffer.uri)

    def _embedded(self, number: int, uri: str) -> bytes:
        kind, _, text = uri.partition(",")
        try:
            if kind.endswith(";base64"):
                return base64.b64decode(text, validate=True)
        except (binascii.Error, ValueError):  # the second for what is not ASCII
            pass
        raise self._document.refused(f"buffers[{number}].uri", "data in base64", f"{uri[:40]}...", AGAIN)
