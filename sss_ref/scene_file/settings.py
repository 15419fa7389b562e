"""The scene file: one model per table, every parameter explained here and nowhere else.

World space is right-handed with +Y up. Lengths are scene units, angles degrees, colours linear. A field without a
default is filled by the preset, or else the file must give it. All models are strict, closed and frozen.
"""

import os
from typing import Annotated, Literal, TypeVar

import numpy as np
from pydantic import AfterValidator, Discriminator, Field, Tag, ValidationInfo, field_validator

from sss_ref.errors.wording import gibibytes, unmet, unmet_at
from sss_ref.numerics.elementary import exp2_array
from sss_ref.scene_file.color_texture import texture_size
from sss_ref.scene_file.diffusion import Diffusion
from sss_ref.scene_file.method_limits import LIMITS, ON_SURFACE
from sss_ref.scene_file.profiles import MaterialName
from sss_ref.scene_file.quantities import (
    MEMORY_LIMIT,
    TEXEL_BYTES,
    Color,
    Count,
    Inset,
    NonNegative,
    Positive,
    Scale,
    Size,
    Stops,
    Strength,
    Table,
    Texels,
    Vector,
    counting,
)
from sss_ref.scene_file.scattering import Blur, TranslucencySettings
from sss_ref.scene_file.shipped import find_mesh, mesh_names
from sss_ref.scene_file.viewpoints import Camera, LightSettings

T = TypeVar("T")
MOST_LIGHTS = 64
LAYERS = counting(0, 1, "at most one layer", "remove the others")
LIGHTS = counting(1, MOST_LIGHTS, f"1 to {MOST_LIGHTS} lights", "add or remove [[lights]]")
MeshColor = Annotated[
    Annotated[Literal["material"], Tag("name")] | Annotated[Color, Tag("rgb")],
    Discriminator(lambda value: "name" if isinstance(value, str) else "rgb"),
]


def _existing_mesh(path: str, info: ValidationInfo) -> str:
    if info.context and find_mesh(path, info.context["folder"]) is None:
        raise unmet("a mesh file or a shipped mesh's name", f"check the path (shipped: {', '.join(mesh_names())})")
    return path


MeshPath = Annotated[str, AfterValidator(_existing_mesh)]


class MeshSettings(Table):
    """[mesh]: the surface, and how it is placed: scaled, rotated about X, then Y, then Z, and translated."""

    path: MeshPath
    """A mesh file, relative to the scene file, or the name of a shipped mesh."""
    scale: Scale = (1.0, 1.0, 1.0)
    """Factor on each axis; a single number for all three. Negative factors mirror."""
    rotate_degrees: Vector = (0.0, 0.0, 0.0)
    """Angles about the fixed axes X, Y, Z, counter-clockwise seen from the axis' tip."""
    translate: Vector = (0.0, 0.0, 0.0)
    """World position of the mesh's origin."""
    color: MeshColor = (0.7, 0.4, 0.4)
    """Albedo, linear RGB; "material": of each triangle the colour of its material in the mesh file."""
    texture: str | None = None
    """Albedo from a PNG or JPEG file, sRGB, relative to the scene file. It replaces color and repeats beyond 0..1."""
    normal_map: str | None = None
    """Finer normals from a PNG or JPEG file, linear, in tangent space, relative to the scene file; beyond 0..1 it
    repeats."""
    normal_map_green: Literal["up", "down"] = "up"
    """Where the map's green points: up along v, as OpenGL and glTF have it, or down, as Direct3D has it."""
    normal_strength: Strength = 1.0
    """Factor on how far the map bends the normal."""
    specular_map: str | None = None
    """Factor on the highlight from a grey PNG or JPEG file, linear, relative to the scene file; beyond 0..1 it
    repeats."""
    unwrap: bool = False
    """Compute UVs where the mesh has none; needs the extra `unwrap`."""

    @property
    def albedo(self) -> Literal["texture", "material", "constant"]:
        """Where the albedo comes from."""
        if self.texture is not None:
            return "texture"
        return "material" if self.color == "material" else "constant"

    @property
    def pictures(self) -> dict[str, str]:
        """Key -> file of every picture that lies over the surface."""
        named = {"texture": self.texture, "normal_map": self.normal_map, "specular_map": self.specular_map}
        return {key: path for key, path in named.items() if path is not None}

    @field_validator("texture", "normal_map", "specular_map")
    @classmethod
    def _picture_exists(cls, picture: str | None, info: ValidationInfo) -> str | None:
        if picture is not None and info.context and not os.path.isfile(info.context["folder"] / picture):
            raise unmet("a PNG or JPEG file", "check the path, which starts at the scene file")
        return picture


class ShadowMap(Table):
    """[shadow_map]: what the light sees, and how a fragment asks whether the light reaches it (paper 2.1)."""

    width: Size = 2048
    """Texels in a row."""
    height: Size = 2048
    """Rows."""
    filter: Literal["nearest", "bilinear"] = "nearest"
    """How light_distance is sampled."""
    lookup_inset: Inset = 1.0
    """Factor on the normalised device coordinates before the lookup."""
    test: Literal["slope", "literal", "kernel", "exact"] = "slope"
    """Bias of the shadow test: grows with the surface's slope, or bias_abs alone (paper 3.2); kernel: as slope, and
    for every tap of the blur's kernel around, which makes edges soft (paper 2.1); exact: thickness 0."""
    kernel_scale: Texels = 6.0
    """Texels that an offset of 1 of the blur's kernel is on the surface, with test "kernel"."""
    bias_abs: NonNegative = 0.0
    """Constant part of the bias, scene units."""
    bias_slope: NonNegative = 1.5
    """Factor on the depth that one texel spans."""
    lookup_depth: Texels = 6.0
    """Widths of a texel by which a point lies below the surface for its thickness, with combine "transmit_wrapped"."""
    encoding: Literal["float32", "unorm8"] = "float32"
    """What a texel can hold: any number, or 256 steps from 0 to 1; unorm8 is also that of irradiance, lit and image."""
    lookup_stage: Literal["fragment", "vertex"] = "fragment"
    """Where the entry point is computed; from vertices it is interpolated."""


class PhongSettings(Table):
    """[phong]: the surface's reflection model (paper 3.2)."""

    ambient: NonNegative = 0.1
    """Light from everywhere; no unit."""
    diffuse: NonNegative = 1.0
    """Weight of max(N.L, 0)."""
    specular: NonNegative = 0.5
    """Weight of the highlight."""
    shininess: Positive = 32.0
    """Exponent of the highlight."""


class LayerSettings(Table):
    """[[layers]]: a body inside the mesh, seen through it and placed as it is, as dentine is under enamel (paper 1.2).

    In screen space; at most one.
    """

    path: MeshPath
    """A mesh file, relative to the scene file, or the name of a shipped mesh."""
    material: MaterialName | None = None
    """What it is made of: fills in colour, highlight and translucency as the scene's material does."""
    color: Color = (0.7, 0.4, 0.4)
    """Albedo, linear RGB."""
    extinction_per_mm: Color
    """How fast light fades between the two surfaces, red, green and blue: exp(-this) of it is left after 1 mm."""
    phong: PhongSettings
    """A table of its own, [layers.phong]; what it leaves out is as in [phong]."""
    translucency: TranslucencySettings
    """A table of its own, [layers.translucency]; what it leaves out is as in [translucency]."""


class IrradianceMap(Table):
    """[irradiance_map]: the light that arrives at the surface, laid out by UV (paper 2.2)."""

    width: Size = 1024
    """Texels in a row."""
    height: Size = 1024
    """Rows."""
    mode: Literal["paper", "lambert", "distance"]
    """paper: D * max(N.L, 0); lambert: max(N.L, 0) where the light reaches; distance: D."""
    image: Literal["sqrt", "product", "sqrt_add"]
    """How the image is made of irradiance and reflected light: their geometric mean, their product, or their geometric
    mean with T added."""
    overlap: Literal["first", "last", "error"] = "first"
    """Which of two triangles owns a texel that both cover."""
    dilate: Count
    """Texels by which the charts are widened before the blur."""


class Output(Table):
    """[output]: the picture."""

    background: Color = (0.0, 0.0, 0.0)
    """Linear RGB where no surface is."""
    exposure: Stops = 0.0
    """Stops by which the picture of 8 bits is brighter than the buffer image: its colours times 2^exposure. No buffer
    depends on it."""

    @property
    def gain(self) -> np.float32:
        """Factor on linear colours where they become 8 bits: 2^exposure, correctly rounded."""
        return np.float32(exp2_array(np.float32(self.exposure)))


class SceneFile(Table):
    """A whole scene file with every key filled."""

    method: Literal["screen_space", "texture_space", "separable", "burley", "preintegrated", "gaussian_texture"] = (
        "screen_space"
    )
    """Where the light is diffused: in the image (paper 2.1) or on the surface (paper 2.2); separable: in the image,
    first along x, then along y (Jimenez et al. 2015); burley: in the image, by normalized diffusion (Christensen and
    Burley 2015); preintegrated: by a table over the angle of the light and curvature (Penner and Borshukov 2011);
    gaussian_texture: on the surface, by six Gaussians (d'Eon and Luebke 2007)."""
    preset: Literal["paper", "robust", "published"] = "paper"
    """What fills the keys that are not given; published also has passes of its own."""
    material: MaterialName | None = None
    """What the body is made of: fills in colour, highlight, translucency and blur, by its measure in mm where these
    keys are not given. Needs mm_per_unit; not with preset published."""
    mm_per_unit: Positive = 1.0
    """Millimetres per scene unit: for lengths in mm. T of x, y and d_min depends on the unit and is never converted."""
    mesh: MeshSettings
    layers: Annotated[tuple[LayerSettings, ...], Field(strict=False), LAYERS] = ()
    camera: Camera
    lights: Annotated[tuple[LightSettings, ...], Field(strict=False), LIGHTS]
    # Defaults that nobody checks yet, or what checks them would be built although it is not used: SceneFile does.
    shadow_map: ShadowMap = ShadowMap.model_construct()
    phong: PhongSettings = PhongSettings.model_construct()
    translucency: TranslucencySettings
    blur: Blur
    diffusion: Diffusion = Diffusion.model_construct()
    irradiance_map: IrradianceMap
    output: Output = Output.model_construct()

    @property
    def inner(self) -> "SceneFile | None":
        """The scene as if the layer were its mesh; None for a scene without."""
        if not self.layers:
            return None
        (layer,) = self.layers
        plain = {"texture": None, "normal_map": None, "specular_map": None, "unwrap": False}
        mesh = self.mesh.model_copy(update={"path": layer.path, "color": layer.color, **plain})
        return self.model_copy(
            update={"mesh": mesh, "phong": layer.phong, "translucency": layer.translucency, "layers": ()}
        )

    @property
    def in_texture_space(self) -> bool:
        """Whether light is diffused on a map of the surface."""
        return self.method in ON_SURFACE

    @property
    def glows(self) -> bool:
        """Whether the picture reaches beyond the model, over the background."""
        return self.method == "screen_space" and self.blur.mask == "none"

    @field_validator(*LIMITS)
    @classmethod
    def _goes_with_the_method(cls, value: T, info: ValidationInfo) -> T:
        if info.field_name and "method" in info.data:
            LIMITS[info.field_name](info.data["method"], value)
        return value

    @field_validator("mesh")
    @classmethod
    def _pictures_fit(cls, mesh: MeshSettings, info: ValidationInfo) -> MeshSettings:
        """Refuse pictures that take more than MEMORY_LIMIT when they are decoded."""
        sizes = {
            key: texture_size(info.context["folder"] / path) for key, path in mesh.pictures.items() if info.context
        }
        needed = {key: TEXEL_BYTES * width * height for key, (width, height) in sizes.items()}
        total = sum(needed.values())
        if total > MEMORY_LIMIT:
            largest = max(needed, key=lambda key: needed[key])
            came = f"{gibibytes(total)}, {gibibytes(needed[largest])} of them here"
            expected = f"at most {gibibytes(MEMORY_LIMIT)} of pictures"
            raise unmet_at(("mesh", largest), expected, came, "scale the picture down")
        return mesh
