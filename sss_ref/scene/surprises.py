"""Warnings about a scene that is drawn all the same: what a user will not see, and the number to set."""

from collections.abc import Iterator

import numpy as np

from sss_ref.scene.idle_keys import idle_keys
from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene.unseen import unseen, written
from sss_ref.scene_file.method_limits import PRINTED
from sss_ref.scene_file.settings import SceneFile
from sss_ref.view.light_fit import Bounds
from sss_ref.view.matrices import length
from sss_ref.view.views import Light, View

FAR_FROM_ORIGIN = 100  # bounding-sphere radii beyond which float32 positions are coarse
COARSEST = 1e-3  # of the mesh's diameter: a coarser spacing of float32 spoils its thickness
NEAR_ENOUGH = 1000  # bounding-sphere radii: from there rays across the mesh are parallel to 0.12 degrees


def surprises(settings: SceneFile, surface: PlacedMesh, camera: View, lights: tuple[Light, ...]) -> Iterator[str]:
    """One line for each surprise, under the key of the scene file that it is about. settings: with every key filled."""
    yield from _of_unit(settings)
    yield from idle_keys(settings)
    yield from (f"mesh: {note}" for note in surface.mesh.notes)
    yield from (f"mesh: {line}" for line in _of_mesh(settings, surface))
    yield from (f"camera: {line}" for line in _of_camera(settings, surface, camera))
    for number, light in enumerate(lights):
        yield from (f"lights[{number}]: {line}" for line in _of_light(settings, surface, light, number))


def surprises_inside(surface: PlacedMesh, inner: PlacedMesh) -> Iterator[str]:
    """The same of a layer, which should be inside the mesh."""
    yield from (f"layers[0]: {note}" for note in inner.mesh.notes)
    corners = inner.points.min(axis=0), inner.points.max(axis=0)
    if not all(map(surface.bounds.holds, corners)):
        yield "layers[0]: it reaches out of the mesh, and beside that is not seen; give one that lies inside"


def _of_unit(settings: SceneFile) -> Iterator[str]:
    """Lengths in mm in a scene that does not say how long its unit is."""
    in_mm = {
        f'method = "{settings.method}"': settings.method not in PRINTED,
        'blur.unit = "mm"': settings.blur.unit == "mm",
        'translucency.form = "gaussians"': settings.translucency.form == "gaussians",
        "layers": bool(settings.layers),
    }
    asking = [key for key, asks in in_mm.items() if asks]
    if asking and "mm_per_unit" not in settings.model_fields_set:
        yield f"mm_per_unit: it is not given, so for {' and '.join(asking)} a unit is 1 mm; set mm_per_unit"


def _of_mesh(settings: SceneFile, surface: PlacedMesh) -> Iterator[str]:
    if not surface.has_area:
        count = len(surface.mesh.triangles)
        flat = 0.0 in np.ptp(surface.mesh.positions, axis=0)
        why = "give back the coordinate that is the same for all" if flat else "export the mesh again"
        yield f"none of its {count} triangles has an area, so none is drawn; {why}"
    own, bounds = Bounds.around(surface.mesh.positions.astype(np.float64)), surface.bounds
    if _is_far(own):
        step = float(np.spacing(np.float32(np.abs(own.centre).max())))
        yield (
            f"in its file it is more than {FAR_FROM_ORIGIN} radii from the origin, where float32 positions are "
            f"{step:.2g} apart and its radius is {own.radius:.3g}; mesh.translate comes too late, subtract "
            f"{written(own.centre)} from the positions in the file"
        )
    elif _is_far(bounds):
        nearer = np.array(settings.mesh.translate) - bounds.centre
        yield (
            f"it is more than {FAR_FROM_ORIGIN} radii from the origin, where float32 positions are coarse; "
            f"set mesh.translate = {written(nearer)} and move camera and lights along"
        )


def _of_camera(settings: SceneFile, surface: PlacedMesh, camera: View) -> Iterator[str]:
    found = unseen(camera, surface, "camera", settings.camera)
    if found:
        yield found
    if surface.encloses(camera.eye):
        yield "it is inside the mesh and sees its back faces"


def _of_light(settings: SceneFile, surface: PlacedMesh, light: Light, number: int) -> Iterator[str]:
    key = f"lights.{number}"
    has_no_place = light.view.lens.is_parallel
    if surface.bounds.holds(light.position) and not surface.is_watertight and not has_no_place:
        yield "it may be inside the mesh, which has holes"
    yield from _far_light(surface.bounds, light, key)
    found = unseen(light.view, surface, key, settings.lights[number])
    if found:
        yield f"of its shadow map: {found}, or leave target, {light.view.lens.key}, near and far to be fitted"


def _far_light(bounds: Bounds, light: Light, key: str) -> Iterator[str]:
    """A light from which float32 distances are too coarse to take the thickness of the mesh from."""
    away = light.position - bounds.centre
    distance, diameter = length(away), 2 * bounds.radius
    step = float(np.spacing(np.float32(distance)))
    if step <= COARSEST * diameter:
        return
    closer = NEAR_ENOUGH * bounds.radius / distance
    fainter = f" and {key}.intensity = {light.intensity * closer**2:.3g}" if light.falloff == "inverse_square" else ""
    yield (
        f"it is {distance:.3g} away, where float32 distances are {step:.2g} apart, and the mesh is {diameter:.3g} "
        f"thick; set {key}.position = {written(bounds.centre + away * closer)}{fainter}: from there its rays are as "
        "good as parallel"
    )


def _is_far(bounds: Bounds) -> bool:
    return length(bounds.centre) > FAR_FROM_ORIGIN * bounds.radius
