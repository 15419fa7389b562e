"""What is known of a processor whose buffers are judged: its arithmetic, its sampling, its rasterizer."""

from dataclasses import dataclass, field, replace
from typing import Literal

from sss_ref.numerics.bounded import Bounded
from sss_ref.numerics.ieee import Ieee


@dataclass(frozen=True)
class Profile:
    """A kind of processor; the defaults are what Vulkan asks of every one.

    arithmetic: the bounds of its operations, or Ieee() for correctly rounded ones in the order written.
    vertex_arithmetic: the same in vertex shaders, where it differs.
    weight_bits: fractional bits with which a position between texels is kept for a bilinear sample; 0: all of float32.
    filter_bits: bits in which a filter may blend the texels of a texture of bytes; 0: all of float32, as those of any
    other texture are.
    nearest_slack: how near a texel's edge, in texels, a nearest sample may take the texel beyond it.
    subpixel_bits: fractional bits of a vertex's window position. snap: whether it moves to the nearest such position,
    or to any of those around it.
    contraction: what becomes of a value that a stage hands to the next one in the same shader. "unfused": it is
    rounded, as `precise` of GLSL and HLSL, NoContraction of SPIR-V and a target between the two have it; "fused": a sum
    may take a product before it is rounded, as with SPV_KHR_fma, or AllowContract of SPV_KHR_float_controls2; "free":
    operations may change their order too, as with AllowReassoc, in WGSL (section 15.7) and in GLSL and HLSL without
    `precise`. Inside a stage any order, fused or not, is accepted always.
    depth_format: how a depth buffer stores its values. reversed_depth: whether it holds 1 at the near plane.
    """

    arithmetic: Ieee | Bounded = field(default_factory=Bounded)
    vertex_arithmetic: Ieee | Bounded | None = None
    weight_bits: int = 8
    filter_bits: int = 8
    nearest_slack: float = 2.0**-8
    subpixel_bits: Literal[4, 8] = 8
    snap: Literal["nearest", "any"] = "nearest"
    contraction: Literal["unfused", "fused", "free"] = "unfused"
    depth_format: Literal["D16", "D24", "D32F"] = "D32F"
    reversed_depth: bool = False

    @property
    def draws_exactly(self) -> bool:
        """Whether it can show only one triangle at each pixel: all is correctly rounded, and snapped in one way."""
        return isinstance(self.arithmetic, Ieee) and self.snap == "nearest"

    @property
    def for_vertices(self) -> "Profile":
        """The same processor in its vertex shaders."""
        return replace(self, arithmetic=self.vertex_arithmetic) if self.vertex_arithmetic else self

    def filter_slack(self, span: float) -> float:
        """How far a bilinear sample of bytes may be off, whose range has this span: along x and along y a step each."""
        return 2 * span / (2.0**self.filter_bits - 1) if self.filter_bits else 0.0

    @property
    def position_slack(self) -> float:
        """How far, in texels, the position of a bilinear sample may be off."""
        return 2.0**-self.weight_bits if self.weight_bits else 0.0


GL_RELATIVE = 1e-5  # OpenGL: "accurate to about 1 part in 10^5"
MEDIUMP_RELATIVE = 2.0**-10  # OpenGL ES Shading Language: mediump float
MEDIUMP_SMALLEST, MEDIUMP_LARGEST = 2.0**-14, 2.0**14

PROFILES = {
    "ieee": Profile(Ieee(), weight_bits=0, filter_bits=0, nearest_slack=0.0),
    "vulkan": Profile(),
    "wgsl": Profile(contraction="free"),
    "gl": Profile(Bounded(relative=GL_RELATIVE)),
    "mediump": Profile(
        Bounded(relative=MEDIUMP_RELATIVE, smallest_normal=MEDIUMP_SMALLEST, largest=MEDIUMP_LARGEST),
        vertex_arithmetic=Bounded(),
    ),
}
