#!/bin/sh
# MeshLab writes OFF files whose vertices are in an order that no description of the format has.
#
# Expected: Geomview's manual, which defines OFF, has the keyword [ST][C][N][4][n]OFF and behind a position the normal,
# the colour and the UV, in this order. One would expect a vertex with normal and colour under CNOFF, normal first.
# Seen: pymeshlab 2025.7 writes NCOFF (with UVs NCSTOFF), and behind the position the colour, then the normal. A reader
# that takes the prefixes for known and goes by the manual has (255, 0, 0) for a normal; one that is strict has no keyword.
# Of a mesh with normals alone (NOFF) the two agree.
#
# Exits 1 if that changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check pymeshlab==2025.7.post1 numpy==2.4.6
cd "$folder"
"$folder/venv/bin/python" - <<'PYTHON'
import sys
from importlib.metadata import version
from pathlib import Path

import numpy as np
import pymeshlab

points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0)], float)
mesh = pymeshlab.Mesh(
    points,
    np.array([(0, 1, 2)]),
    v_normals_matrix=np.array([(0, 0, 1)] * 3, float),
    v_color_matrix=np.array([(1, 0, 0, 1)] * 3, float),
)
meshes = pymeshlab.MeshSet()
meshes.add_mesh(mesh)
meshes.save_current_mesh("a.off", save_vertex_normal=True, save_vertex_color=True)
keyword, _, first, *_ = Path("a.off").read_text().splitlines()
numbers = [float(word) for word in first.split()]
print(f"pymeshlab {version('pymeshlab')}: {keyword}, first vertex {numbers}")
as_seen = keyword == "NCOFF" and numbers[3:7] == [255, 0, 0, 255] and numbers[7:9] == [0, 0] and numbers[9] > 0
print("as described" if as_seen else "this has changed")
sys.exit(not as_seen)
PYTHON
