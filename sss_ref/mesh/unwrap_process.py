"""The process in which xatlas cuts a surface into charts: it can crash, or never end, and takes nothing along.

Run as `python unwrap_process.py SURFACE ATLAS`. SURFACE is an .npz file of positions and triangles; ATLAS is written,
with the fields of `unwrap.Atlas`. It is run by its path and imports nothing of the package, so it starts quickly.
"""

import sys

import numpy as np

PADDING = 8  # texels between charts on a map of about 1024: the widest dilation of the presets


def main(surface: str, atlas: str) -> None:
    """Unwrap one surface; the exit code is 1 where nothing can be laid out."""
    import xatlas

    packing = xatlas.PackOptions()
    packing.padding = PADDING
    generator = xatlas.Atlas()
    with np.load(surface) as given:
        generator.add_mesh(given["positions"], given["triangles"].astype(np.uint32))
    generator.generate(pack_options=packing)
    if not generator.chart_count:
        sys.exit("no triangle has an area")
    vertices, triangles, uvs = generator[0]
    np.savez(
        atlas,
        vertices=vertices.astype(np.int64),
        triangles=triangles.astype(np.int32),
        uvs=uvs.astype(np.float32),
        charts=np.int64(generator.chart_count),
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
