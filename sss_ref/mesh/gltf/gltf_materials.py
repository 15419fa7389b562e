"""The materials of a glTF file: a colour, and which UVs its colour texture is looked up at."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from sss_ref.mesh.gltf.gltf_document import Entry, GltfDocument, Real, Vec2, Vec4, Whole
from sss_ref.mesh.materials import Material
from sss_ref.numerics.trigonometry import fifty_digits

Numbers = NDArray[np.float64]

WHITE = [1.0, 1.0, 1.0, 1.0]  # the default of baseColorFactor, and of a primitive without material


class TextureInfo(Entry):
    """A texture as a material uses it."""

    texCoord: Whole = 0


class TextureTransform(Entry):
    """The extension KHR_texture_transform of a texture."""

    offset: Vec2 = Field([0.0, 0.0])
    rotation: Real = 0.0
    scale: Vec2 = Field([1.0, 1.0])
    texCoord: Whole | None = None


class MetallicRoughness(Entry):
    """The colour of a material."""

    baseColorFactor: Vec4 = WHITE
    baseColorTexture: TextureInfo | None = None


class SpecularGlossiness(Entry):
    """The colour of a material of the extension KHR_materials_pbrSpecularGlossiness, which comes first where given."""

    diffuseFactor: Vec4 = WHITE
    diffuseTexture: TextureInfo | None = None


class GltfMaterial(Entry):
    """What matters here of a material."""

    table = "materials"
    name: str = ""
    pbrMetallicRoughness: MetallicRoughness = MetallicRoughness()
    normalTexture: Any = None  # only notes tell of it


class Appearance:
    """The material of a primitive, and the UVs that it asks for."""

    def __init__(self, document: GltfDocument, number: int | None, user: str) -> None:
        self._document = document
        self._place: tuple[Any, ...] = ("materials", number)  # of the colour texture, once that is known
        material = GltfMaterial() if number is None else document.entry(GltfMaterial, number, user)
        color, self._texture = self._color(material)
        if min(color) < 0:
            raise document.refused(f"materials[{number}]", "a colour of numbers >= 0", str(color))
        red, green, blue, _ = color
        self.material = Material(material.name, (red, green, blue), self._texture is not None)
        self._transform = self._transform_of(self._texture)
        self.normal_texture = material.normalTexture

    def _color(self, material: GltfMaterial) -> tuple[list[float], TextureInfo | None]:
        name = "KHR_materials_pbrSpecularGlossiness"
        older = self._document.extension(SpecularGlossiness, name, material, self._place)
        if older:
            self._place += ("extensions", name, "diffuseTexture")
            return older.diffuseFactor, older.diffuseTexture
        self._place += ("pbrMetallicRoughness", "baseColorTexture")
        return material.pbrMetallicRoughness.baseColorFactor, material.pbrMetallicRoughness.baseColorTexture

    def _transform_of(self, texture: TextureInfo | None) -> TextureTransform | None:
        if texture is None:
            return None
        return self._document.extension(TextureTransform, "KHR_texture_transform", texture, self._place)

    @property
    def uv_set(self) -> int:
        """The n of the TEXCOORD_n that the colour texture is looked up at; 0 without one."""
        if self._transform and self._transform.texCoord is not None:
            return self._transform.texCoord
        return self._texture.texCoord if self._texture else 0

    def looked_up(self, uvs: Numbers) -> Numbers:
        """Where the texture is looked up: UVs (N, 2), origin top-left, scaled, rotated, moved (KHR_texture_transform).

        The rotation is counter-clockwise as one sees it, v pointing down, as the extension's text and its example
        say; the matrix in its listing turns the other way (Khronos glTF issue 1563).
        """
        if self._transform is None:
            return uvs
        mp, angle = fifty_digits(), self._transform.rotation
        c, s = float(mp.cos(angle)), float(mp.sin(angle))
        u, v = uvs.T * np.array(self._transform.scale)[:, np.newaxis]
        x, y = self._transform.offset
        return np.stack([(c * u + s * v) + x, (c * v - s * u) + y], axis=1)
