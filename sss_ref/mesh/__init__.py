"""Triangles from mesh files, with their normals, UVs, materials, and facts about them."""
