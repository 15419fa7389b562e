"""A scene together with the passes it will draw: what every renderer of this package asks."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.language import Stage
from sss_ref.language.names import INNER, Name
from sss_ref.language.pipeline import INNER_MESH, MESH, Method, Pass
from sss_ref.mesh.triangles import Mesh, array_hash
from sss_ref.methods.parallel_views import with_parallel_rays
from sss_ref.passes.buffers import described
from sss_ref.scene.albedo import albedo_warnings
from sss_ref.scene.catalogue import method_of
from sss_ref.scene.forms import Form, forms_of, size_of
from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene.spreading import curvatures_of
from sss_ref.scene.stages_replaced import with_stages
from sss_ref.scene.surprises import surprises, surprises_inside
from sss_ref.scene.uniforms import of_inner_body, stretch, uniforms_of
from sss_ref.scene.until import buffers_kept, buffers_until
from sss_ref.scene_file.settings import SceneFile
from sss_ref.view.matrices import Matrix, transformed
from sss_ref.view.views import Light, View


@dataclass(frozen=True, eq=False)
class Scene:
    """A scene ready to be rendered. It never changes; what is derived from it is worked out once."""

    settings: SceneFile  # every key filled, the fitted ones too
    source: str  # the scene file's path or the shipped scene's name; "scene" for a dictionary
    mesh: Mesh
    world_from_model: Matrix  # (4, 4)
    camera: View
    lights: tuple[Light, ...]
    albedo: Mapping[str, NDArray[Any]]  # the uniforms of the surface's colour, see albedo_of
    maps: Mapping[str, NDArray[np.float32]] = field(default_factory=dict)  # pictures of its detail, see maps_of
    inner_mesh: Mesh | None = None  # the layer inside the mesh, at the same place
    own_stages: Mapping[str, Stage] = field(default_factory=dict)  # name of a stage -> the user's in its place
    own_uniforms: Mapping[str, Any] = field(default_factory=dict)  # what those read: name -> float32

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """What is drawn all the same, but may surprise."""
        surface = PlacedMesh(self.mesh, self.world_from_model)
        inside = [PlacedMesh(self.inner_mesh, self.world_from_model)] if self.inner_mesh else []
        return (
            *albedo_warnings(self.settings.mesh, self.mesh),
            *surprises(self.settings, surface, self.camera, self.lights),
            *(line for layer in inside for line in surprises_inside(surface, layer)),
        )

    @cached_property
    def method(self) -> Method:
        """The passes that the scene asks for, with the user's stages in their places (see `sss_ref.with_stage`)."""
        return with_parallel_rays(with_stages(method_of(self.settings), self.own_stages), self.settings)

    @cached_property
    def uniforms(self) -> Mapping[str, Any]:
        """Every uniform of every stage by name, float32 or int: scalars, or arrays (N,), (N, N), (N, C), (H, W, C)."""
        own = uniforms_of(self.settings, self.world_from_model, self.camera, self.lights, self.method.constants)
        points = transformed(self.world_from_model, self.mesh.positions)
        in_mm = stretch(self.settings, points, self.mesh)
        bent = curvatures_of(self.settings, self.world_from_model, self.mesh)
        return {**own, **in_mm, **bent, **self.albedo, **self.maps, **self._of_inner_body(), **self.own_uniforms}

    def _of_inner_body(self) -> dict[str, Any]:
        """The uniforms that the body inside the mesh has for itself; none for a scene without."""
        own = self.settings.inner
        if not own:
            return {}
        found = uniforms_of(own, self.world_from_model, self.camera, self.lights, {})
        return of_inner_body({**found, "mesh_color": np.array(own.mesh.color, np.float32)})

    def mesh_of(self, this_pass: Pass) -> Mesh:
        """The mesh that a pass draws."""
        return self.meshes[this_pass.draw.mesh]

    @property
    def meshes(self) -> Mapping[str, Mesh]:
        """The meshes that passes draw, by the names that they have there."""
        return {MESH: self.mesh} | ({INNER_MESH: self.inner_mesh} if self.inner_mesh else {})

    @cached_property
    def forms(self) -> Mapping[str, Form]:
        """Buffer -> its form, for all that the method can write, registers too, in stage order."""
        return forms_of(self.method, self.settings)

    def size(self, this_pass: Pass) -> tuple[int, int]:
        """Width and height of what a pass draws into."""
        return size_of(this_pass.target, self.settings)

    def clear(self, buffer: str) -> Any:
        """What a buffer holds where nothing is drawn: a number, or one for each channel."""
        given = described(buffer).background
        if not isinstance(given, str):
            return given
        of_its_light = str(Name.of(given).of_light(Name.of(buffer).light))
        return self.uniforms.get(of_its_light, self.uniforms.get(given))

    def kept(self, keep: str | Iterable[str]) -> set[str]:
        """The buffers that some names stand for; see `buffers_kept`. Raises SceneError for an unknown one."""
        return buffers_kept(self.method, keep)

    def until(self, end: str) -> list[str]:
        """The buffers up to a pass, a stage or a buffer; see `buffers_until`. Raises SceneError for any other name."""
        return buffers_until(self.method, end)

    def input_hashes(self, hashes_of: Callable[[Mesh], dict[str, str]] = Mesh.hashes) -> dict[str, str]:
        """Name of everything that was read from a mesh or texture file -> its `array_hash` after decoding (rule A5).

        hashes_of: what gives those of a mesh, for many scenes one that remembers what it has given.
        """
        colors = {name: self.albedo[name] for name in ("albedo_map", "material_color") if name in self.albedo}
        inner = hashes_of(self.inner_mesh) if self.inner_mesh else {}
        return (
            hashes_of(self.mesh)
            | {name: array_hash(name, array) for name, array in {**colors, **self.maps}.items()}
            | {str(Name(name, body=INNER)): found for name, found in inner.items()}
        )
