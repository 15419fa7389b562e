#!/bin/sh
# OpenEXR's Python module writes other pixels of a channel that is a view with strides.
#
# Expected: a NumPy array is written as it reads, or refused; the module takes an interleaved picture as "RGB", so one
# channel of such a picture, picture[..., 1], seems as good as any.
# Seen with OpenEXR 3.5.3: it takes the address of the first value and reads on as if the array were contiguous. Of an
# interleaved picture each channel becomes the first third of all three, mixed; a crop becomes the rows of the whole
# picture, torn; a transposed array is written untransposed. Neither the constructor nor write() says so, and the
# object's own channels show the right pixels. Known to its authors (OpenEXR 1929), in no page of its documentation.
# Exits 0 while it is so, 1 when it changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check OpenEXR==3.5.3 numpy==2.2.6
cd "$folder"
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import numpy as np
import OpenEXR

print("OpenEXR", OpenEXR.__version__)
picture = np.random.default_rng(1).random((64, 64, 3), np.float32)
grey = np.ascontiguousarray(picture[..., 0])
views = {"one channel": picture[..., 1], "a crop": grey[:32, :32], "transposed": grey.T}
as_seen = True
for name, view in views.items():
    for kind, plane in {"as it is": view, "copied": np.ascontiguousarray(view)}.items():
        header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
        file = OpenEXR.File(header, {"Y": plane})
        file.write("view.exr")
        held = np.array_equal(file.channels()["Y"].pixels, view)
        read = OpenEXR.File("view.exr").channels()["Y"].pixels
        wrong = float((read != view).mean())
        print(f"{name}, {kind}: the object holds the right pixels: {held}; of those in the file {wrong:.0%} are wrong")
        as_seen &= held and (wrong > 0.5) == (kind == "as it is")
sys.exit(0 if as_seen else 1)
PYTHON
