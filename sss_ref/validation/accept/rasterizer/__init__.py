"""What a correct rasterizer may show at each pixel."""
