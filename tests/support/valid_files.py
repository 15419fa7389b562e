"""Valid files of every kind that is read, each in a folder with what it refers to: small ones, and those shipped."""

import json
import struct
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from gltf_files import CORNERS, FACES
from saved_scene import SCENE, TETRAHEDRON
from valid_file import Valid, made, picture
from valid_gltf import gltf, gltf_with_everything
from valid_records import valid_records

from sss_ref.bundle.writing import write_bundle
from sss_ref.scene.load import load_scene
from sss_ref.scene_file.shipped import mesh_names, mesh_path, scene_names, scene_path

HEIGHT, WIDTH = 32, 48  # of saved_scene.SCENE
SMALL_ENOUGH = 60_000  # bytes of a shipped mesh

MATERIALS = """newmtl a
Kd 0.7 0.4 0.3
Ks .5 .5 .5
Ns 32
newmtl b
Kd 0.1 0.2 0.3
map_Kd colors.png
"""
TEXT_PLY = """ply
format ascii 1.0
comment four corners
element vertex 4
property float x
property float y
property float z
property float s
property float t
element face 4
property list uchar int vertex_indices
end_header
0 0 0 0 0
1 0 0 1 0
0 1 0 0 1
0 0 1 1 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
"""
QUADS = """v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
v 0 0 1.5
vn 0 0 -1
o base
f 4//1 3//1 2//1 1//1
g sides
s 1
f -1 -5 -4
f 5 2 3
f 5 3 4
f 5 4 1
"""
OFF = """OFF
4 4 6
0.0 0.0 0
1.5 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
"""
OWN_PROFILE = """based_on = "gl"
subpixel_bits = 4
[bounds]
divide_ulp = 4.5
"""
SWEEP = """scene = "teaching"
seed = 3
keep = ["image"]
outputs = ["npz"]
[set]
camera.width = 16
camera.height = 16
[vary]
camera.azimuth = {first = 0, last = 330, count = 12}
lights.0.intensity = [0.5, 1.0]
translucency.x = {random = "uniform", low = 0.5, high = 2.0}
"""
MAPPING = """origin = "top"
device = "a renderer"
[buffers.position_world]
file = "one.pfm"
space = "world"
[buffers.normal_world]
file = "two.npy"
channels = ["R", "G", "B"]
normals = "n*.5+.5"
[buffers.depth]
file = "three.raw"
shape = [32, 48]
dtype = "float32"
depth = "window"
scale = 1.0
offset = 0.0
background = 1.0
"""


@cache
def valid_files():
    """All of them, in an order that never changes."""
    return (*_scenes(), *_meshes(), *_dumps(), *_texts(), *_results(), *_bundles(), *valid_records())


def _scenes():
    with_pictures = SCENE.replace('"tetrahedron.obj"', '"tetrahedron.obj"\ntexture = "c.png"\nnormal_map = "n.png"')
    own = {"tetrahedron.obj": TETRAHEDRON.encode()}
    yield Valid("scene", "small", {"a.toml": SCENE.encode(), **own})
    pictures = {"c.png": picture(5, 3, 3), "n.png": picture(4, 4, 3)}
    for k, mode in enumerate((3, 4, 1, 2)):
        yield Valid(
            "scene",
            f"pictures {k}",
            {"a.toml": with_pictures.encode(), **own, **pictures, "c.png": picture(5, 3, mode)},
        )
    for name in scene_names():
        yield Valid("scene", name, {"a.toml": scene_path(name).read_bytes()})


def _meshes():
    library = "mtllib a.mtl\n" + TETRAHEDRON.replace("f 1/1 2/2", "usemtl b\nf 1/1 2/2")
    yield Valid("mesh", "obj", {"a.obj": library.encode(), "a.mtl": MATERIALS.encode(), "colors.png": picture(2, 2, 3)})
    yield Valid("mesh", "quads.obj", {"a.obj": QUADS.encode()})
    yield Valid("mesh", "ply", {"a.ply": TEXT_PLY.encode()})
    yield Valid("mesh", "binary.ply", {"a.ply": binary_ply()})
    yield Valid("mesh", "off", {"a.off": OFF.encode()})
    yield Valid("mesh", "stl", {"a.stl": text_stl().encode()})
    yield Valid("mesh", "binary.stl", {"a.stl": binary_stl()})
    for name in ("a.gltf", "a.glb"):
        yield Valid("mesh", name, {name: gltf(name)})
        yield Valid("mesh", f"everything in {name}", {name: gltf_with_everything(name)})
    for path in map(mesh_path, mesh_names()):
        if path.stat().st_size <= SMALL_ENOUGH:
            yield Valid("mesh", path.name, {f"a{path.suffix}": path.read_bytes()})


def _dumps():
    rng = np.random.default_rng(7)
    points, numbers = rng.random((HEIGHT, WIDTH, 3), np.float32), rng.integers(-1, 4, (HEIGHT, WIDTH), np.int32)
    yield Valid(
        "dump",
        "npy",
        {"position_world.npy": made(np.save, "a.npy", points), "triangle.npy": made(np.save, "a.npy", numbers)},
    )
    yield Valid("dump", "pfm", {"position_world.pfm": b"PF\n48 32\n-1.0\n" + points.tobytes()})
    for compression in ("NO", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44"):
        yield Valid("dump", f"exr {compression}", {"position_world.exr": exr(points, compression)})
    for dxgi, code, texels in (
        (2, "float32", 4),
        (10, "float16", 4),
        (28, "uint8", 4),
        (41, "float32", 1),
        (43, "int32", 1),
    ):
        name = {41: "depth", 43: "triangle"}.get(dxgi, "normal_world")
        values = (rng.random((HEIGHT, WIDTH, texels)) * 3).astype(code)
        yield Valid("dump", f"dds {dxgi}", {f"{name}.dds": dds(dxgi, values.tobytes())})
    for mode in (1, 3, 4):
        name = "coverage" if mode == 1 else "albedo"
        yield Valid("dump", f"png {mode}", {f"{name}.png": picture(WIDTH, HEIGHT, mode)})
    for compression in (None, "lzw", "deflate", "packbits"):
        yield Valid("dump", f"tiff {compression}", {"position_world.tif": tiff(points, compression)})


def _texts():
    raw = {"three.raw": np.ones((HEIGHT, WIDTH), np.float32).tobytes()}
    rng = np.random.default_rng(8)
    points = rng.random((HEIGHT, WIDTH, 3), np.float32)
    others = {"one.pfm": b"PF\n48 32\n-1.0\n" + points.tobytes(), "two.npy": made(np.save, "a.npy", points), **raw}
    yield Valid("mapping", "mapping", {"a.toml": MAPPING.encode(), **others})
    yield Valid("profile", "own", {"a.toml": OWN_PROFILE.encode()})
    yield Valid("profile", "names", {"a.toml": b'based_on = "mediump"\n'})
    yield Valid("sweep", "sweep", {"a.toml": SWEEP.encode()})
    yield Valid(
        "sweep",
        "olat",
        {"a.toml": b'scene = "teaching"\n[olat]\ncount = 8\ndirections = "random"\n[set]\ncamera.width = 8\n'},
    )


def _results():
    """What `save` keeps, without the buffers' hashes: a manifest is held against the scene before they are."""
    record = {
        "format": "sss_ref result", "format_version": 1, "package_version": "0", "rules_version": 2,
        "scene": {"source": "small.toml", "mesh_file": "tetrahedron.obj", "settings": {}},
        "inputs": {"positions": "0" * 64}, "buffers": [], "row_order": {"npy": "bottom row first"},
        "interpreter": "kernel", "threads": 2, "milliseconds": {"camera": 1.5}, "environment": {"python": "3"},
    }  # fmt: skip
    yield Valid("manifest", "manifest", {"manifest.json": json.dumps(record).encode()})


def _bundles():
    """A scene for other renderers, whose mesh is a folder of arrays."""
    with TemporaryDirectory() as name:
        (Path(name) / "tetrahedron.obj").write_text(TETRAHEDRON)
        (Path(name) / "a.toml").write_text(SCENE)
        bundle = write_bundle(load_scene(Path(name) / "a.toml"), Path(name) / "bundle")
        files = {
            path.relative_to(bundle).as_posix(): path.read_bytes()
            for path in sorted(bundle.rglob("*"))
            if path.is_file()
        }
    yield Valid("bundle", "bundle", files)


def exr(points, compression):
    """An EXR file of three channels."""
    import OpenEXR

    header = {"compression": getattr(OpenEXR, f"{compression}_COMPRESSION"), "type": OpenEXR.scanlineimage}
    return made(lambda path, data: OpenEXR.File(header, {"RGB": data}).write(str(path)), "a.exr", points)


def tiff(points, compression):
    """A TIFF file of three channels."""
    import tifffile

    return made(
        lambda path, data: tifffile.imwrite(path, data, compression=compression, photometric="rgb"), "a.tif", points
    )


def dds(dxgi, texels):
    """A DDS file with the header that names a DXGI format."""
    words = [0x20534444, 124, 0x1007, HEIGHT, WIDTH, 0, 0, 1, *[0] * 11, 32, 4, 0x30315844, *[0] * 5, 0x1000, *[0] * 4]
    return struct.pack("<32I", *words) + struct.pack("<5I", dxgi, 3, 0, 1, 0) + texels


def binary_ply():
    """Triangles and a quad, little-endian, with normals."""
    head = "ply\nformat binary_little_endian 1.0\nelement vertex 5\n" + "".join(
        f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz")
    )
    head += "element face 3\nproperty list uchar uint vertex_indices\nend_header\n"
    corners = np.zeros((5, 6), np.float32)
    corners[:, :3] = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)]
    corners[:, 5] = 1
    faces = struct.pack("<B4I", 4, 0, 1, 2, 3) + struct.pack("<B3I", 3, 0, 1, 4) + struct.pack("<B3I", 3, 2, 3, 4)
    return head.encode() + corners.tobytes() + faces


def text_stl():
    """The tetrahedron as STL in text."""
    facets = []
    for face in FACES.reshape(-1, 3):
        corners = "".join(f"vertex {' '.join(map(str, corner))}\n" for corner in CORNERS[face].tolist())
        facets.append(f"facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
    return f"solid a\n{''.join(facets)}endsolid a\n"


def binary_stl():
    """The tetrahedron as binary STL."""
    facets = (struct.pack("<3f", 0, 0, 0) + CORNERS[face].tobytes() + bytes(2) for face in FACES.reshape(-1, 3))
    return bytes(80) + struct.pack("<I", 4) + b"".join(facets)
