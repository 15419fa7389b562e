#!/bin/sh
# numpy.fromstring of a text with nothing but blanks.
#
# Expected: no numbers, as for the empty text; a reader of mesh files that takes all numbers of a kind at once has such
# texts wherever a file has none of that kind.
# Seen with NumPy 2.4.6: one number that is nowhere in the text, -1 as float64 and 0 as int64, and no warning.
# So `sss_ref/mesh/words.py` counts the words first and asks for no numbers where there are none.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet numpy==2.4.6
"$folder/venv/bin/python" -W error - <<'PYTHON'
import sys

import numpy as np

print("numpy", np.__version__)
found = {(text, kind): np.fromstring(text, kind, sep=" ").tolist() for text in ("", "  ", "\n") for kind in (float, int)}
for (text, kind), numbers in found.items():
    print(f"{text!r:6} as {kind.__name__:5} -> {numbers}")
seen = {("", float): [], ("", int): [], ("  ", float): [-1.0], ("  ", int): [0], ("\n", float): [-1.0], ("\n", int): [0]}
sys.exit(0 if found == seen else 1)
PYTHON
