"""What `sss-ref info` tells of a mesh, as data and as rows of text."""

from collections.abc import Iterator
from dataclasses import dataclass

from sss_ref.mesh.likely_size import LONGEST_MM, LikelySize
from sss_ref.mesh.topology import is_watertight
from sss_ref.mesh.triangles import Mesh
from sss_ref.mesh.uv_facts import UvFacts, uv_facts

Point = tuple[float, float, float]
Row = tuple[str, str]

NO_UVS = "none; for the texture-space method set mesh.unwrap = true"


@dataclass(frozen=True)
class MeshFacts:
    """A mesh as it is loaded: triangulated, its parts joined, before the scene's scale. Lengths in the file's unit."""

    name: str
    triangles: int
    vertices: int  # a point counts once for each normal or UV that it has
    low: Point  # least coordinates
    high: Point  # greatest coordinates
    size: Point  # high - low
    mm_per_unit: float  # for the scene file: a guess, see mesh.likely_size
    d_min: float  # for the scene file's [translucency], that follows from the size
    normals: str  # "file" or "computed"
    watertight: bool
    uv: UvFacts | None  # None: the mesh has no UVs
    notes: tuple[str, ...]  # what of the file was changed or not used, and why

    def rows(self) -> Iterator[Row]:
        """Label and text of every fact."""
        yield "mesh", self.name
        yield "triangles", str(self.triangles)
        yield "vertices", str(self.vertices)
        yield "bounds", f"{_written(self.low)} to {_written(self.high)}"
        yield "size", _written(self.size)
        yield "mm_per_unit", f"{self.mm_per_unit:g} if the longest side is {LONGEST_MM:g} mm; the scene has to say it"
        yield "d_min", f"{self.d_min:g}, 1.5 % of the longest side; see sss-ref init"
        yield "normals", "from the file" if self.normals == "file" else "computed, weighted by area"
        yield "watertight", "yes" if self.watertight else "no: inside and outside are not known"
        yield from _uv_rows(self.uv, self.triangles) if self.uv else [("UVs", NO_UVS)]
        yield from (("note", note) for note in self.notes)


def mesh_facts(mesh: Mesh) -> MeshFacts:
    """The facts of a loaded mesh."""
    low, high, likely = mesh.positions.min(axis=0), mesh.positions.max(axis=0), LikelySize.of(mesh)
    return MeshFacts(
        name=mesh.name,
        triangles=len(mesh.triangles),
        vertices=len(mesh.positions),
        low=tuple(low.tolist()),
        high=tuple(high.tolist()),
        size=tuple((high - low).tolist()),
        mm_per_unit=likely.mm_per_unit,
        d_min=likely.d_min,
        normals=mesh.normals_source,
        watertight=is_watertight(mesh.positions, mesh.triangles),
        uv=None if mesh.uvs is None else uv_facts(mesh),
        notes=mesh.notes,
    )


def _uv_rows(uv: UvFacts, triangles: int) -> Iterator[Row]:
    yield "UV bounds", f"{_written(uv.bounds[:2])} to {_written(uv.bounds[2:])}"
    yield "UV outside 0..1", f"{uv.out_of_range} vertices, {uv.shifted} triangles moved from other tiles"
    yield "UV mirrored", f"{uv.mirrored} of {triangles} triangles"
    yield "UV without area", f"{uv.zero_area} of {triangles} triangles"
    yield "UV seams", f"{uv.seams} edges"


def _written(point: tuple[float, ...]) -> str:
    return f"({', '.join(f'{coordinate:.6g}' for coordinate in point)})"
