#!/bin/sh
# A PNG of 16 bits a channel with colours, such as a baked normal map, by Pillow and by imageio.
#
# Expected: 16 bits, as both give them for grey, or an error; the file is as plain as PNG has them, written by libpng.
# Seen with Pillow 13.0.0 and imageio 2.38.1: the upper 8 bits of each channel, cut off and not rounded, without a
# warning. A normal map loses what it was baked in 16 bits for: 0x7FFF, a slope of 0.001 degrees, becomes 0x7F, one of a
# quarter of a degree.
# So `sss_ref/scene_file/png_codes.py` decodes such files itself.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet pillow==13.0.0 imageio==2.38.1 imagecodecs==2026.3.6 numpy==2.4.6
"$folder/venv/bin/python" -W error - "$folder" <<'PYTHON'
import sys
from pathlib import Path

import imagecodecs
import imageio
import imageio.v3
import numpy as np
import PIL
from PIL import Image

print("Pillow", PIL.__version__, "imageio", imageio.__version__)
path, seen = Path(sys.argv[1]) / "a.png", {}
for name, channels in (("grey", 1), ("grey with alpha", 2), ("RGB", 3), ("RGBA", 4)):
    codes = np.full((2, 2, channels), 0x7FFF, np.uint16)
    path.write_bytes(imagecodecs.png_encode(codes[..., 0] if channels == 1 else codes))
    assert (imagecodecs.png_decode(path.read_bytes()) == 0x7FFF).all()
    with Image.open(path) as image:
        by_pillow = np.asarray(image)
    by_imageio = imageio.v3.imread(path)
    seen[name] = [(str(found.dtype), hex(found.flat[0])) for found in (by_pillow, by_imageio)]
    print(f"{name:16} Pillow {seen[name][0]}, imageio {seen[name][1]}")
whole, cut = ("uint16", "0x7fff"), ("uint8", "0x7f")
sys.exit(0 if seen["grey"] == [whole] * 2 and seen["RGB"] == seen["RGBA"] == [cut] * 2 else 1)
PYTHON
