#!/bin/sh
# What one would expect: trimesh, the reader of meshes most used in Python, divides glTF's normalized integers (core
# glTF 2.0: an unsigned short c means c/65535), gives a primitive of mode 6 as triangles, and numbers triangles in the
# file's order.
# What was seen (trimesh 5.2.0): the UV 65535 stays 65535 (flipped to 1 - 65535), the fan is left out without a word,
# and of three nodes the last comes first. A reader that believes it takes another mesh than the renderer.
# Exits 1 if that changes.
set -e
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install -q trimesh==5.2.0 numpy==2.4.6
"$folder/venv/bin/python" - <<'PROGRAM'
import base64, io, json, struct, sys
import trimesh

print("trimesh", trimesh.__version__)
points = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0)
uvs = struct.pack("<8H", 0, 0, 65535, 0, 65535, 65535, 0, 65535)
indices = struct.pack("<4H", 0, 1, 2, 3)
binary = points + uvs + indices
uri = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()


def loaded(primitives, nodes):
    views = [(0, 48), (48, 16), (64, 8)]
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
        "meshes": [{"primitives": primitives}], "materials": [{}],
        "buffers": [{"byteLength": 72, "uri": uri}],
        "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": size} for start, size in views],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5123, "normalized": True, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"},
            {"bufferView": 2, "componentType": 5123, "count": 4, "type": "SCALAR"},
        ],
    }
    return trimesh.load_scene(io.BytesIO(json.dumps(document).encode()), file_type="gltf", process=False)


one = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}
uv = next(iter(loaded([one], [{"mesh": 0}]).geometry.values())).visual.uv
both = loaded([one, {"attributes": {"POSITION": 0}, "indices": 3, "mode": 6}], [{"mesh": 0}])
triangles = sum(len(mesh.faces) for mesh in both.geometry.values() if hasattr(mesh, "faces"))
three = loaded([one], [{"mesh": 0, "name": n, "translation": [x, 0, 0]} for n, x in (("c", 0), ("a", 10), ("b", 20))])
order = [float(three.graph.get(name)[0][0, 3]) for name in three.graph.nodes_geometry]
print("greatest UV:", float(abs(uv).max()), "(1 by the specification)")
print("triangles of a triangle and a fan of two:", triangles, "(3 by the specification)")
print("nodes at 0, 10, 20 come as:", order)
sys.exit(0 if abs(uv).max() > 60000 and triangles == 1 and order != [0, 10, 20] else 1)
PROGRAM
