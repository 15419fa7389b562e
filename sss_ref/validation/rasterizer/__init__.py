"""The rasterizer on intervals: which triangles a right processor may show at a pixel, and what it hands on."""
