"""A body inside the mesh: the passes of a mesh, with names of its own, in the light that comes through the mesh."""

from collections.abc import Iterator
from dataclasses import replace

from sss_ref.language import Stage
from sss_ref.language.names import INNER, Name
from sss_ref.language.pipeline import INNER_MESH, Draw, MeshDraw, Pass
from sss_ref.methods.per_light import of_light
from sss_ref.passes.buffers import is_listed
from sss_ref.passes.seen_through import light_inside

# The uniforms of which each body has its own.
OWN = (
    "mesh_color",
    "ambient",
    "diffuse",
    "specular",
    "shininess",
    "x",
    "y",
    "exponent",
    "d_min",
    "translucency_scale",
    "gaussian_weight",
    "gaussian_variance",
    "gaussian_count",
    "translucency_neutral",
    "wrap",
)


def inner(name: str) -> str:
    """What the inner body has under a name: its own, such as inner_lit, or the same for what both bodies share."""
    return str(Name.of(name).of_body(INNER)) if belongs_to_a_body(name) else name


def belongs_to_a_body(name: str) -> bool:
    """Whether each body has a buffer or a uniform of this name."""
    return is_listed(name) or name in OWN


def of_inner(this_pass: Pass) -> Pass:
    """A pass of the mesh as one of the inner body, in the light that comes through the mesh."""
    stages = (each for stage in this_pass.stages for each in _in_light_from_around(stage))
    name = str(Name.of(this_pass.name).of_body(INNER))
    return replace(this_pass, name=name, draw=_of_inner_mesh(this_pass.draw), stages=(*stages,))


def _of_inner_mesh(draw: Draw) -> Draw:
    """The draw of the inner mesh; what a vertex has, it has under the names that every vertex has."""
    assert isinstance(draw, MeshDraw)
    triangle, depth, coverage = (name and inner(name) for name in (draw.triangle, draw.depth, draw.coverage))
    return replace(draw, mesh=INNER_MESH, triangle=triangle, depth=depth, coverage=coverage)


def _in_light_from_around(stage: Stage) -> Iterator[Stage]:
    """A stage of the inner body; if it says how strong a light is, that goes through the mesh around first."""
    if "incident_light" not in stage.writes:
        yield stage.renamed(inner)
        return
    number = Name.of(stage.writes["incident_light"]).light
    at_the_mesh = str(Name("light_around", number))
    yield stage.bound(incident_light=at_the_mesh).renamed(inner)
    distance, triangle = (str(Name(name, number)) for name in ("light_distance", "light_triangle"))
    around = {"around_distance": distance, "around_triangle": triangle}
    yield light_inside.renamed(of_light(number)).renamed(inner).bound(**around)
