"""Loading a mesh: one list of triangles, whatever the file's format and however many parts it has.

Each format has a reader, which gives the parts in the file's order, moved to their places; they are joined in that
order. It numbers the triangles in every buffer.
"""

from pathlib import Path

from sss_ref.mesh.array_folder import is_array_folder, read_arrays
from sss_ref.mesh.joining import joined
from sss_ref.mesh.part import refused
from sss_ref.mesh.polygon_files import READERS, read_polygon_file
from sss_ref.mesh.triangles import Mesh
from sss_ref.mesh.untrusted import BYTE_LIMIT
from sss_ref.scene_file.shipped import MESH_SUFFIXES


def load_mesh(path: Path) -> Mesh:
    """The mesh in the OBJ, PLY, STL, OFF, glTF or GLB file at `path`, or in a folder of arrays, as a bundle has it.

    Whether its normals are the file's, `normals_source` says; `notes` say what of the file was changed or not used.
    Raises MeshError for anything that cannot be drawn.
    """
    if is_array_folder(path):
        return read_arrays(path)
    _check_file(path)
    if path.suffix.lower() in READERS:
        return joined(path, read_polygon_file(path))
    from sss_ref.mesh.gltf.gltf_reader import read_gltf  # it takes longer to load than many a mesh

    return joined(path, read_gltf(path))


def _check_file(path: Path) -> None:
    if path.suffix.lower() not in MESH_SUFFIXES:
        raise refused(path, f"one of {', '.join(MESH_SUFFIXES)}", path.suffix or "no suffix", "convert the mesh")
    try:
        if not path.is_file() and path.exists():  # reading a pipe or a device may never end
            raise refused(path, "a readable file", "a folder or a device", "check the path")
        with path.open("rb") as file:
            size = file.seek(0, 2)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise refused(path, "a readable file", reason, "check the path") from None
    if size > BYTE_LIMIT:
        raise refused(path, f"at most {BYTE_LIMIT} bytes", str(size), "simplify the mesh")
