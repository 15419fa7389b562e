"""Notes on a rendering that shows nothing: no triangle drawn, or an image that hides what was drawn."""

from collections.abc import Iterator

import numpy as np

from sss_ref.language.names import Name
from sss_ref.language.pipeline import Pass
from sss_ref.rendering.draw import Sketch
from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene.scene import Scene
from sss_ref.scene.unseen import framing, unseen

HALF_A_STEP = 1.2e-4  # linear: half of the smallest step that a picture of 8 bits, sRGB, makes; it is the one at black
SPARSE = 64  # every so many pixels a side are looked at first, for nearly every image shows itself there
GREY, BLACK = [0.5, 0.5, 0.5], [0.0, 0.0, 0.0]  # backgrounds that set off what is dark, and what is bright


def nothing_drawn(scene: Scene, this_pass: Pass, sketch: Sketch) -> Iterator[str]:
    """Whether a view of the mesh has no fragment; with the number to set, unless the scene's warnings say it."""
    if not this_pass.draw.vertex_stages or this_pass.draw.layout or sketch.fragments.where.any():
        return
    light = max(Name.of(this_pass.name).light - 1, 0)
    from_camera = this_pass.target == "camera"
    view, key = (scene.camera, "camera") if from_camera else (scene.lights[light].view, f"lights.{light}")
    table = scene.settings.camera if from_camera else scene.settings.lights[light]
    surface = PlacedMesh(scene.mesh_of(this_pass), scene.world_from_model)
    told = f"{this_pass.name}: nothing of the mesh is drawn"
    if unseen(view, surface, key, table) or not surface.has_area:
        yield told
    else:
        enough = framing(view, surface.bounds)
        yield f"{told}, no triangle is at the middle of a pixel; set {key}.{enough} or move it"


def hidden(scene: Scene, image: np.ndarray) -> Iterator[str]:
    """Whether all pixels of an image, float32 (H, W, 3), look alike, although something is drawn there."""
    if image.size == 3 or _varies(image[::SPARSE, ::SPARSE]) or _varies(image):
        return
    low, high = (f"[{', '.join(f'{value:.3g}' for value in end)}]" for end in (image.min((0, 1)), image.max((0, 1))))
    came = low if low == high else f"{low} to {high}"
    remedy = " or ".join([*_other_background(scene), *_other_light(scene, float(image.max()))])
    yield f"image: every pixel looks the same, {came}, so that nothing is seen of the mesh; set {remedy}"


def _varies(image: np.ndarray) -> bool:
    """Whether a picture shows more than one colour."""
    seen = np.clip(image.reshape(-1, 3), 0, 1)
    return bool((np.ptp(seen, axis=0) > HALF_A_STEP).any())


def _other_background(scene: Scene) -> Iterator[str]:
    """A background that sets off the mesh, where the image has one at all."""
    if not scene.settings.glows:
        settings = scene.settings
        yield f"output.background = {BLACK if max(settings.output.background) >= max(GREY) else GREY}"


def _other_light(scene: Scene, brightest: float) -> Iterator[str]:
    """The intensity of the strongest light that gives an image of this brightest value the range of a picture."""
    lights = scene.settings.lights
    number = max(range(len(lights)), key=lambda index: lights[index].intensity)
    if lights[number].intensity == 0:
        yield f"lights.{number}.intensity = 1"
    elif brightest > 0:
        yield f"lights.{number}.intensity = {lights[number].intensity / brightest:.2g}"
