"""The formats that hold polygons and nothing else, each read by its own reader."""

from pathlib import Path

from sss_ref.mesh.obj import read_obj
from sss_ref.mesh.off import read_off
from sss_ref.mesh.part import FileContent
from sss_ref.mesh.ply import read_ply
from sss_ref.mesh.polygons import in_triangles
from sss_ref.mesh.stl import read_stl
from sss_ref.mesh.untrusted import check_packed

READERS = {".obj": read_obj, ".ply": read_ply, ".stl": read_stl, ".off": read_off}


def read_polygon_file(path: Path) -> FileContent:
    """The content of an OBJ, PLY, STL or OFF file; raises MeshError for one that cannot be read."""
    data = path.read_bytes()
    check_packed(path, data)
    return in_triangles(path, READERS[path.suffix.lower()](path, data))
