"""The materials of a mesh file, as far as a colour goes."""

from dataclasses import dataclass

Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class Material:
    """What a file says about the colour of some of its triangles."""

    name: str = ""
    color: Rgb | None = None  # linear RGB: Kd as it stands, or baseColorFactor; None where the file gives none
    textured: bool = False  # whether the file has a colour texture for it, which is not read
