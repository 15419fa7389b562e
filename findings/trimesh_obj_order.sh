#!/bin/sh
# The order in which trimesh numbers the triangles of an OBJ file.
#
# Expected: the file's order, both triangles of a quad one after the other, since whoever compares triangle numbers
# with a renderer, or resolves equal depths, depends on it; `maintain_order=True` promises "the strongest attempt".
# Seen with trimesh 5.2.0, on two quads and on three materials: the first halves of all quads, then all second halves;
# materials from the last to the first. `maintain_order` and `process=False` change neither.
# So OBJ files are read by `sss_ref/mesh/obj.py`.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet trimesh==5.2.0 numpy==2.4.6
"$folder/venv/bin/python" - <<'PYTHON'
import io
import sys

import trimesh

POINTS = "".join(f"v {x} {y} 0\n" for x in range(6) for y in (0, 1))
QUADS = POINTS + "f 1 3 4 2\nf 5 7 8 6\n"
MATERIALS = POINTS + "usemtl a\nf 1 3 2\nusemtl b\nf 5 7 6\nusemtl c\nf 9 11 10\n"


def places(text):
    """The least x of each triangle, in the order trimesh gives."""
    options = {"file_type": "obj", "process": False, "maintain_order": True}
    parts = trimesh.load_scene(io.BytesIO(text.encode()), **options).dump()
    return [int(corners[:, 0].min()) for part in parts for corners in part.triangles]


print("trimesh", trimesh.__version__)
found = places(QUADS), places(MATERIALS)
print("quads at x = 0, 2:       triangles at", found[0])
print("materials at x = 0, 2, 4: triangles at", found[1])
sys.exit(0 if found == ([0, 2, 0, 2], [4, 2, 0]) else 1)
PYTHON
