#!/bin/sh
# OpenEXR's DWAA and DWAB change one component of a position and leave the others alone.
#
# Expected: a lossy compression treats the three channels of a layer alike; of a layer Position.X, Position.Y, Position.Z
# either all lose bits or none does.
# Seen with OpenEXR 3.5.3: channels are sorted by what follows the last dot. Y is taken for luminance and goes through a
# cosine transform in half floats; X and Z come back in every bit. A position or normal written so has one wrong
# component, which looks like a fault of the shader. The header's compression is the only sign of it.
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
generator = np.random.default_rng(1)
written = {f"Position.{axis}": generator.random((64, 64), np.float32) for axis in "XYZ"}
as_seen = True
for name in ("ZIP", "DWAA", "DWAB"):
    header = {"compression": getattr(OpenEXR, f"{name}_COMPRESSION"), "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {channel: plane.copy() for channel, plane in written.items()}).write("position.exr")
    read = OpenEXR.File("position.exr", separate_channels=True).channels()
    apart = {channel: float(np.abs(read[channel].pixels - plane).max()) for channel, plane in written.items()}
    print(name, apart)
    changed = [channel for channel in apart if apart[channel] > 0]
    as_seen &= changed == ([] if name == "ZIP" else ["Position.Y"])
sys.exit(0 if as_seen else 1)
PYTHON
