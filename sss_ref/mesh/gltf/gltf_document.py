"""The JSON of a glTF file: each entry is checked when it is used, and only then.

What a mesh does not need (animations, images, cameras, lights) is never looked at.
"""

from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, TypeVar

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from sss_ref.errors import MeshError
from sss_ref.errors.wording import KeyPath, shown, written
from sss_ref.mesh.part import refused

AGAIN = "export the mesh again"

EXPECTED = {  # pydantic's name of a problem -> what was expected
    "model_type": "an object",
    "dict_type": "an object",
    "list_type": "an array",
    "int_type": "a whole number",
    "float_type": "a number",
    "finite_number": "a finite number",
    "string_type": "a text",
    "bool_type": "true or false",
    "missing": "a value",
    "greater_than_equal": "at least {ge}",
    "less_than_equal": "at most {le}",
    "too_short": "at least {min_length} values",
    "too_long": "at most {max_length} values",
    "literal_error": "{expected}",
}


def _whole(value: Any) -> Any:
    """JSON has one kind of number: 3.0 is whole."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


Whole = Annotated[int, BeforeValidator(_whole), Field(ge=0)]
Real = Annotated[float, Field(allow_inf_nan=False)]
Vec2 = Annotated[list[Real], Field(min_length=2, max_length=2)]
Vec3 = Annotated[list[Real], Field(min_length=3, max_length=3)]
Vec4 = Annotated[list[Real], Field(min_length=4, max_length=4)]
Mat4 = Annotated[list[Real], Field(min_length=16, max_length=16)]
ComponentType = Annotated[Literal[5120, 5121, 5122, 5123, 5125, 5126], BeforeValidator(_whole)]


class Entry(BaseModel):
    """An object of the document, keys as the specification has them; others are passed over."""

    model_config = ConfigDict(strict=True, defer_build=True)

    table: ClassVar[str] = ""
    extensions: dict[str, Any] = {}


class GltfBuffer(Entry):
    """Bytes in the file, beside it, or in the document itself."""

    table = "buffers"
    byteLength: Annotated[Whole, Field(ge=1)]
    uri: str | None = None


class GltfView(Entry):
    """A stretch of a buffer."""

    table = "bufferViews"
    buffer: Whole
    byteLength: Annotated[Whole, Field(ge=1)]
    byteOffset: Whole = 0
    byteStride: Annotated[Whole, Field(ge=4, le=252)] | None = None


class SparsePlace(Entry):
    """Where the values of a sparse accessor are, or with a component type where their indices are."""

    bufferView: Whole
    byteOffset: Whole = 0


class SparseIndices(SparsePlace):
    """Which elements are replaced."""

    componentType: Annotated[Literal[5121, 5123, 5125], BeforeValidator(_whole)]


class Sparse(Entry):
    """The elements of an accessor that differ from its view, or from 0."""

    count: Annotated[Whole, Field(ge=1)]
    indices: SparseIndices
    values: SparsePlace


class GltfAccessor(Entry):
    """Numbers in a view."""

    table = "accessors"
    componentType: ComponentType
    count: Annotated[Whole, Field(ge=1)]
    type: Literal["SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"]
    bufferView: Whole | None = None
    byteOffset: Whole = 0
    normalized: bool = False
    sparse: Sparse | None = None


class GltfPrimitive(Entry):
    """One draw."""

    attributes: dict[str, Whole]
    indices: Whole | None = None
    material: Whole | None = None
    mode: Annotated[Literal[0, 1, 2, 3, 4, 5, 6], BeforeValidator(_whole)] = 4
    targets: list[dict[str, Whole]] = []


class GltfMesh(Entry):
    """What a node places."""

    table = "meshes"
    primitives: list[Any]
    weights: list[Real] | None = None


class GltfNode(Entry):
    """A place in the hierarchy."""

    table = "nodes"
    mesh: Whole | None = None
    skin: Whole | None = None
    children: list[Whole] = []
    matrix: Mat4 | None = None
    translation: Vec3 | None = None
    rotation: Vec4 | None = None
    scale: Vec3 | None = None
    weights: list[Real] | None = None


class GltfScene(Entry):
    """The roots that are drawn."""

    table = "scenes"
    nodes: list[Whole] = []


class GltfSkin(Entry):
    """The nodes that a mesh hangs on."""

    table = "skins"
    joints: Annotated[list[Whole], Field(min_length=1)]
    inverseBindMatrices: Whole | None = None


class GltfAsset(Entry):
    """Which glTF it is."""

    version: str
    minVersion: str | None = None


class GltfTop(Entry):
    """The document: its tables, whose entries are not looked at yet."""

    asset: GltfAsset
    scene: Whole | None = None
    extensionsUsed: list[str] = []
    extensionsRequired: list[str] = []
    accessors: list[Any] = []
    bufferViews: list[Any] = []
    buffers: list[Any] = []
    materials: list[Any] = []
    meshes: list[Any] = []
    nodes: list[Any] = []
    scenes: list[Any] = []
    skins: list[Any] = []
    textures: Any = []  # these two only for what notes say of them
    images: Any = []


E = TypeVar("E", bound=Entry)


class GltfDocument:
    """A document whose entries are asked for by table and number."""

    def __init__(self, path: Path, content: dict[str, Any]) -> None:
        self.path = path
        self.top = self.checked(GltfTop, content, ())
        self._entries: dict[tuple[str, int], Any] = {}

    def entry(self, kind: type[E], number: int, user: str) -> E:
        """An entry of its table. user: the place that refers to it, which is refused if there is no such entry."""
        table = getattr(self.top, kind.table)
        if number >= len(table):
            came = f"{number} of {len(table)} (they count from 0)"
            raise self.refused(user, f"the number of one of the {kind.table}", came)
        if (kind.table, number) not in self._entries:
            self._entries[kind.table, number] = self.checked(kind, table[number], (kind.table, number))
        return self._entries[kind.table, number]

    def extension(self, kind: type[E], name: str, owner: Entry, place: KeyPath) -> E | None:
        """The extension of that name of an entry, or None."""
        if name not in owner.extensions:
            return None
        return self.checked(kind, owner.extensions[name], (*place, "extensions", name))

    def checked(self, kind: type[E], value: Any, place: KeyPath) -> E:
        """A JSON value as an entry; raises MeshError that names the first key of another form."""
        try:
            return kind.model_validate(value)
        except ValidationError as error:
            first = error.errors()[0]
            expected = EXPECTED.get(first["type"], "another value").format(**first.get("ctx", {})).replace("'", '"')
            came = "nothing" if first["type"] == "missing" else shown(first["input"])
            where = written((*place, *first["loc"])) if place or first["loc"] else "the document"
            raise self.refused(where, expected, came) from None

    def refused(self, place: str, expected: str, came: str, remedy: str = AGAIN) -> MeshError:
        """The error about a place in the document."""
        return refused(f"{self.path}: {place}", expected, came, remedy)
