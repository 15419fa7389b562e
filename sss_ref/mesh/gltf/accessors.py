"""The numbers of accessors: every component type, normalized, interleaved, sparse (glTF 2.0, 3.6)."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.gltf.gltf_buffers import GltfBuffers
from sss_ref.mesh.gltf.gltf_document import GltfAccessor, GltfDocument, Sparse
from sss_ref.mesh.gltf.gltf_file import GltfFile

Numbers = NDArray[np.float64]

COMPONENTS: dict[int, tuple[str, np.dtype[Any]]] = {  # component type -> its name, and its form in memory
    5120: ("byte", np.dtype("<i1")),
    5121: ("unsigned byte", np.dtype("<u1")),
    5122: ("short", np.dtype("<i2")),
    5123: ("unsigned short", np.dtype("<u2")),
    5125: ("unsigned int", np.dtype("<u4")),
    5126: ("float", np.dtype("<f4")),
}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}  # of the forms that anything here has
BUDGET = 2**24  # elements in all that may be read: vertices and corners at every place where they are drawn


@dataclass(frozen=True)
class AccessorForm:
    """What an accessor must hold to be used for something."""

    type: str
    components: tuple[str, ...]
    quantized: tuple[str, ...] = ()  # what KHR_mesh_quantization adds
    tight: bool = False  # whether elements lie one behind the other, whatever the view says


class Accessors:
    """The numbers of a file by accessor."""

    def __init__(self, file: GltfFile) -> None:
        self._document: GltfDocument = file.document
        self._buffers = GltfBuffers(file)
        top = file.document.top
        self._quantized = "KHR_mesh_quantization" in {*top.extensionsUsed, *top.extensionsRequired}
        self._left = BUDGET

    def spend(self, elements: int) -> None:
        """Count what is drawn or read once more; raises MeshError when it is too much."""
        self._left -= elements
        if self._left < 0:
            expected = f"at most {BUDGET} vertices and corners over all nodes"
            raise self._document.refused("nodes", expected, "more", "simplify the mesh")

    def has_data(self, number: int, user: str) -> bool:
        """Whether an accessor says where its numbers are; else they are 0, or an extension has them."""
        accessor = self._document.entry(GltfAccessor, number, user)
        return accessor.bufferView is not None or accessor.sparse is not None

    def integers(self, number: int, form: AccessorForm, user: str, count: int | None = None) -> NDArray[np.integer]:
        """The components (N, C) as they are stored. user: the place that refers to the accessor; count: how many."""
        return self._stored(self._accessor(number, form, user, count), form, user)

    def numbers(self, number: int, form: AccessorForm, user: str, count: int | None = None) -> Numbers:
        """The components (N, C) as float64; normalized ones c/255, c/65535, max(c/127, -1) or max(c/32767, -1)."""
        accessor = self._accessor(number, form, user, count)
        stored = self._stored(accessor, form, user)
        values = stored.astype(np.float64)
        if not accessor.normalized:
            return values
        return np.maximum(values / np.iinfo(stored.dtype).max, -1.0)

    def _accessor(self, number: int, form: AccessorForm, user: str, count: int | None) -> GltfAccessor:
        """The accessor, if it is of the right form and length."""
        accessor = self._document.entry(GltfAccessor, number, user)
        component = COMPONENTS[accessor.componentType][0] + (" normalized" if accessor.normalized else "")
        allowed = form.components + (form.quantized if self._quantized else ())
        if accessor.type != form.type or component not in allowed:
            expected = f"{form.type} of {' or '.join(allowed)}"
            remedy = "export the mesh again"
            if accessor.type == form.type and component in form.quantized:
                remedy = "name KHR_mesh_quantization in extensionsRequired, or export floats"
            raise self._document.refused(user, expected, f"{accessor.type} of {component}", remedy)
        if count is not None and accessor.count != count:
            raise self._document.refused(user, f"{count} elements, as many as the others", str(accessor.count))
        if accessor.count > BUDGET:
            raise self._document.refused(user, f"at most {BUDGET} elements", str(accessor.count), "simplify the mesh")
        return accessor

    def _stored(self, accessor: GltfAccessor, form: AccessorForm, user: str) -> NDArray[Any]:
        dtype, width = COMPONENTS[accessor.componentType][1], WIDTH[accessor.type]
        if accessor.bufferView is None:
            values: NDArray[Any] = np.zeros((accessor.count, width), dtype)
        else:
            stretch = _Stretch(accessor.bufferView, accessor.byteOffset, accessor.count, width, dtype, form.tight)
            values = self._seen(stretch, user)
        return values if accessor.sparse is None else self._replaced(values, accessor.sparse, user)

    def _replaced(self, values: NDArray[Any], sparse: Sparse, user: str) -> NDArray[Any]:
        """Values with some elements given anew, by indices that rise."""
        dtype = COMPONENTS[sparse.indices.componentType][1]
        places, news = sparse.indices, sparse.values
        indices = self._seen(_Stretch(places.bufferView, places.byteOffset, sparse.count, 1, dtype), user)
        stretch = _Stretch(news.bufferView, news.byteOffset, sparse.count, values.shape[1], values.dtype)
        where = indices[:, 0].astype(np.int64)
        if where[-1] >= len(values) or (np.diff(where) <= 0).any():
            expected = f"sparse indices that rise, below {len(values)}"
            raise self._document.refused(user, expected, "others")
        values = values.copy()
        values[where] = self._seen(stretch, user)
        return values

    def _seen(self, stretch: "_Stretch", user: str) -> NDArray[Any]:
        """The components (N, C) in a view, not copied; raises MeshError if they do not lie in it, or not aligned."""
        content, view = self._buffers.view(stretch.view, user)
        unit, place = stretch.dtype.itemsize, f"bufferViews[{stretch.view}]"
        size = unit * stretch.width
        stride = view.byteStride or size
        if stride < size or (stretch.tight and stride != size):
            expected = f"a byteStride of {'at least ' * (not stretch.tight)}{size} in {place}"
            raise self._document.refused(user, expected, str(stride))
        if stretch.offset % unit or view.byteOffset % unit or stride % unit:
            came = f"byteOffset {stretch.offset} in {place}, which starts at {view.byteOffset}, stride {stride}"
            raise self._document.refused(user, f"components that are aligned to {unit} bytes", came)
        end = stretch.offset + (stretch.count - 1) * stride + size
        if end > len(content):
            raise self._document.refused(user, f"{end} bytes in {place}", str(len(content)))
        shape, strides = (stretch.count, stretch.width), (stride, unit)
        return np.ndarray(shape, stretch.dtype, content, stretch.offset, strides)


@dataclass(frozen=True)
class _Stretch:
    """Where elements lie."""

    view: int
    offset: int  # bytes from the start of the view
    count: int
    width: int  # components of an element
    dtype: np.dtype[Any]
    tight: bool = True
