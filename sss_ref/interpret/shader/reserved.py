"""The words that shading languages keep for themselves, so that a stage's own names stay clear of them.

GLSL 4.60 section 3.6, GLSL ES 3.00 section 3.7, the appendices "Keywords" and "Reserved Words" of HLSL, and of WGSL
"Keyword Summary", "Reserved Words" and "Predeclared" types. Both GLSLs also keep names that begin with gl_ or have two
underscores in a row.
"""

from itertools import product

SIZES = "234"
SHAPES = [f"{rows}x{columns}" for rows, columns in product(SIZES, SIZES)]


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


def _families(prefixes: str, ends: list[str]) -> frozenset[str]:
    """Each prefix with each end: vec2, vec3 ..."""
    return frozenset(prefix + end for prefix in prefixes.split() for end in ends)


SAMPLED = [
    *("1D", "2D", "3D", "Cube", "Buffer", "2DRect", "1DArray", "2DArray", "CubeArray", "2DMS", "2DMSArray"),
    *("1DShadow", "2DShadow", "CubeShadow", "2DRectShadow", "1DArrayShadow", "2DArrayShadow", "CubeArrayShadow"),
    *("3DRect", "ExternalOES"),
]
GLSL_WORDS = (
    _words("""
    active asm atomic_uint attribute bool break buffer case cast centroid class coherent common const continue default
    discard do double else enum extern external false filter fixed flat float for goto half highp if in inline inout
    input int interface invariant layout long lowp mediump namespace noinline noperspective out output packed partition
    patch precise precision public readonly resource restrict return row_major sample sampler samplerShadow shared short
    sizeof smooth static struct subpassInput subpassInputMS isubpassInput isubpassInputMS usubpassInput usubpassInputMS
    subroutine superp switch template this true typedef uint uniform union unsigned using varying void volatile while
    writeonly
    """)
    | _families("vec ivec bvec uvec dvec hvec fvec", list(SIZES))
    | _families("mat dmat", [*SIZES, *SHAPES])
    | _families("sampler isampler usampler image iimage uimage texture itexture utexture", SAMPLED)
)
GLSL_BUILT_INS = _words("""
abs acos acosh all any asin asinh atan atanh barrier bitCount bitfieldExtract bitfieldInsert bitfieldReverse ceil clamp
cos cosh cross dFdx dFdxCoarse dFdxFine dFdy dFdyCoarse dFdyFine degrees determinant distance dot equal exp exp2
faceforward findLSB findMSB floatBitsToInt floatBitsToUint floor fma fract frexp fwidth fwidthCoarse fwidthFine
greaterThan greaterThanEqual intBitsToFloat interpolateAtCentroid interpolateAtOffset interpolateAtSample inverse
inversesqrt isinf isnan ldexp length lessThan lessThanEqual log log2 matrixCompMult max min mix mod modf normalize not
notEqual outerProduct pow radians reflect refract round roundEven sign sin sinh smoothstep sqrt step tan tanh
texelFetch texture textureGather textureGrad textureLod textureProj textureSize transpose trunc uintBitsToFloat
""")

HLSL_TYPES = "bool int uint dword half float double min16float min10float min16int min12int min16uint"
HLSL_WORDS = _words("""
AppendStructuredBuffer BlendState Buffer ByteAddressBuffer CompileShader ComputeShader ConsumeStructuredBuffer
DepthStencilState DepthStencilView DomainShader GeometryShader HullShader InputPatch LineStream NULL OutputPatch
PixelShader PointStream RWBuffer RWByteAddressBuffer RWStructuredBuffer RWTexture1D RWTexture1DArray RWTexture2D
RWTexture2DArray RWTexture3D RasterizerState RenderTargetView SamplerComparisonState SamplerState StructuredBuffer
Texture1D Texture1DArray Texture2D Texture2DArray Texture2DMS Texture2DMSArray Texture3D TextureCube TextureCubeArray
TriangleStream VertexShader asm asm_fragment auto break case catch cbuffer centroid char class column_major compile
compile_fragment const const_cast continue decl default delete discard do dynamic_cast else enum explicit export extern
false for friend fxgroup globallycoherent goto groupshared if in inline inout interface line lineadj linear long matrix
mutable namespace new nointerpolation noperspective operator out packoffset pass pixelfragment point precise private
protected public register reinterpret_cast return row_major sample sampler sampler1D sampler2D sampler3D samplerCUBE
sampler_state shared short signed sizeof snorm stateblock stateblock_state static static_cast string struct switch
tbuffer
technique technique10 technique11 template texture texture1D texture2D texture3D textureCUBE this throw triangle
triangleadj true try typedef typename uniform union unorm unsigned using vector vertexfragment virtual void volatile
while
""") | _families(HLSL_TYPES, ["", *"1234", *(f"{rows}x{columns}" for rows, columns in product("1234", "1234"))])
HLSL_BUILT_INS = _words("""
abort abs acos all any asdouble asfloat asin asint asuint atan atan2 ceil clamp clip cos cosh countbits cross ddx ddy
degrees determinant distance dot dst errorf exp exp2 f16tof32 f32tof16 faceforward firstbithigh firstbitlow floor fma
fmod frac frexp fwidth isfinite isinf isnan ldexp length lerp lit log log10 log2 mad max min modf msad4 mul noise
normalize pow printf radians rcp reflect refract reversebits round rsqrt saturate sign sin sincos sinh smoothstep sqrt
step tan tanh tex1D tex2D tex3D texCUBE transpose trunc
""")

WGSL_WORDS = (
    _words("""
    NULL Self abstract active alias alignas alignof array as asm asm_fragment async atomic attribute auto await become
    bool break case cast catch class co_await co_return co_yield coherent column_major common compile compile_fragment
    concept const const_assert const_cast consteval constexpr constinit continue continuing crate debugger decltype
    default delete demote demote_to_helper diagnostic discard do dynamic_cast else enable enum explicit export extends
    extern external f16 f32 fallthrough false filter final finally fn for friend from fxgroup get goto groupshared highp
    i32 if impl implements import inline instanceof interface layout let loop lowp macro macro_rules match mediump meta
    mod module move mut mutable namespace new nil noexcept noinline nointerpolation non_coherent noncoherent
    noperspective null nullptr of operator override package packoffset partition pass patch pixelfragment precise
    precision premerge priv protected ptr pub public readonly ref regardless register reinterpret_cast require requires
    resource restrict return sampler sampler_comparison self set shared sizeof smooth snorm static static_assert
    static_cast std struct subroutine super switch target template this thread_local throw trait true try type typedef
    typeid typename typeof u32 union unless unorm unsafe unsized use using var varying virtual volatile wgsl where while
    with writeonly yield
    """)
    | _families("vec", [*SIZES, *(size + kind for size in SIZES for kind in "fhiu")])
    | _families("mat", [*SHAPES, *(shape + kind for shape in SHAPES for kind in "fh")])
)
WGSL_BUILT_INS = _words("""
abs acos acosh all any arrayLength asin asinh atan atan2 atanh bitcast ceil clamp cos cosh countLeadingZeros
countOneBits countTrailingZeros cross degrees determinant distance dot dpdx dpdxCoarse dpdxFine dpdy dpdyCoarse
dpdyFine exp exp2 extractBits faceForward firstLeadingBit firstTrailingBit floor fma fract frexp fwidth fwidthCoarse
fwidthFine insertBits inverseSqrt ldexp length log log2 max min mix modf normalize outerProduct pow quantizeToF16
radians reflect refract reverseBits round saturate select sign sin sinh smoothstep sqrt step tan tanh textureDimensions
textureGather textureLoad textureSample textureSampleLevel transpose trunc
""")
