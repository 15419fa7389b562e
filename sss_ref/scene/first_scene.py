"""A first scene file for a mesh: commented, and framed so that its picture is good at once."""

import json
import os
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.errors.text_file import write_text
from sss_ref.errors.whole_file import put_new
from sss_ref.errors.wording import told
from sss_ref.mesh.likely_size import LONGEST_MM, LikelySize, three_digits
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.mesh.triangles import Mesh
from sss_ref.numerics.trigonometry import tangent
from sss_ref.scene_file.presets import ROBUST
from sss_ref.scene_file.shipped import given_mesh
from sss_ref.view.light_fit import Bounds
from sss_ref.view.matrices import look_at, outward, transformed
from sss_ref.view.views import UP

AZIMUTH, ELEVATION, FOV_Y = 25.0, 5.0, 30.0  # degrees: a portrait, from the front
KEY, BACK = -20.0, 200.0  # degrees: the lights' azimuths, from the front
HEAD, ASIDE = 0.25, 0.2  # of the height, from above; of the depth, away from the middle
AROUND = 1.12  # room around the mesh, as a factor on half of its height or width in the picture
SIZE = 2.0  # units: the longest side of the bust, on which preset robust was chosen
SMALLEST, LARGEST = 1e-12, 1e12  # units: the longest side of a mesh that a first scene is written for
SCALE, EXPONENT = (ROBUST["translucency"][key] for key in ("scale", "exponent"))  # of T, and of the thickness in it

TEXT = """\
# A first scene for {name}. Every key may be changed; what is left out comes from the preset.
preset = "robust"

# How far light spreads depends on the size, which a mesh file does not say. Here the longest side, {longest:.4g} units,
# is taken for {longest_mm:g} mm, as of a head. Is the unit a metre, set 1000; a centimetre, 10; a millimetre, 1.
mm_per_unit = {mm_per_unit}
# material = "skin"                     # or wax, jade ...: in the place of color, specular and [translucency] below

[mesh]
path = {path}
color = [0.82, 0.52, 0.41]              # linear RGB{color}
# rotate_degrees = [-90.0, 0.0, 0.0]    # if it lies on its back: up is +Z in its file, +Y here

[camera]
type = "orbit"                          # about target, here the middle of the mesh
target = [{target}]
azimuth = {azimuth:<30}# degrees; 0 looks from +Z, 90 from +X
elevation = {elevation}
distance = {distance}
fov_y = {fov_y}
near = {near}
far = {far}

[[lights]]                              # the key light, which shows the form
azimuth = {key}
elevation = 35.0
distance = {distance}
color = [1.0, 0.96, 0.92]
intensity = 0.85

[[lights]]                              # the back light, which shines through what is thin
azimuth = {back}
elevation = 20.0
distance = {distance}
color = [1.0, 0.45, 0.28]
intensity = 0.7

[phong]
ambient = 0.04
specular = 0.3

# T = 2^0.5 / d^{exponent} for the way d through the body, in units: so both numbers go with the longest side.
[translucency]
combine = "transmit_wrapped"            # light from behind goes round: no dark line where light and shade meet
exponent = {exponent}                         # the paper's is 0.6; this one lets the far side fall off into the dark
d_min = {d_min}                           # what is thinner lets no more through: 1.5 % of that side
scale = {scale}                           # how much comes through

[output]
background = [0.012, 0.016, 0.022]
exposure = 0.0                          # stops: 1 is twice as bright, -1 half
"""


def write_first_scene(mesh: str, target: Path, replace: bool) -> None:
    """Write a first scene for a mesh file, or a shipped mesh of this name, to the file `target`.

    Raises MeshError for a mesh that cannot be drawn, and SceneError for a file that cannot be written or is there
    already, unless `replace` says that it may go.
    """
    if target.suffix != ".toml":
        raise SceneError(told(str(target), "a file name that ends in .toml", target.suffix or "none", "add it"))
    if target.exists() and not replace:
        raise _already_there(target)
    loaded = load_mesh(given_mesh(mesh))
    text = first_scene(loaded, _path_from(target.parent, mesh))
    try:
        write_text(target, text, SceneError, Path.replace if replace else put_new)
    except FileExistsError:
        raise _already_there(target) from None


def first_scene(mesh: Mesh, path: str) -> str:
    """The text of a scene file that shows `mesh`, which it finds at `path`.

    Raises SceneError for a mesh so small or large that float32 has no room for the squares of its lengths.
    """
    size, bounds = _drawable(mesh), Bounds.around(mesh.positions.astype(np.float64))
    front = front_of(mesh)
    distance = _distance(mesh.positions - bounds.centre, front + AZIMUTH)
    return TEXT.format(
        name=_quoted(mesh.name),
        path=_quoted(path),
        color="" if mesh.uvs is None else "; or texture = a picture that lies over its UVs",
        longest=size.longest,
        longest_mm=LONGEST_MM,
        mm_per_unit=size.mm_per_unit,
        d_min=size.d_min,
        exponent=EXPONENT,
        scale=three_digits(SCALE * (size.longest / SIZE) ** EXPONENT),
        target=", ".join(str(float(f"{x:.6g}")) for x in bounds.centre.tolist()),
        azimuth=front + AZIMUTH,
        key=front + KEY,
        back=(front + BACK) % 360,
        elevation=ELEVATION,
        fov_y=FOV_Y,
        distance=three_digits(distance),
        near=three_digits((distance - bounds.radius) / 2),
        far=three_digits(2 * (distance + bounds.radius)),
    )


def _drawable(mesh: Mesh) -> LikelySize:
    size = LikelySize.of(mesh)
    if not SMALLEST <= size.longest <= LARGEST:
        expected = f"a mesh whose longest side is {SMALLEST:g} to {LARGEST:g} units"
        raise SceneError(told(mesh.name, expected, f"{size.longest:.3g}", "export it in another unit"))
    return size


def front_of(mesh: Mesh) -> float:
    """The azimuth from which a mesh shows its face, degrees: 0, from +Z as glTF 2.0 has it, or 180.

    It is 180 where the upper quarter of the mesh, which is its head, lies towards -Z by more than a fifth of its depth.
    """
    positions = mesh.positions.astype(np.float64)
    low, high = positions.min(axis=0), positions.max(axis=0)
    head = positions[positions[:, 1] >= high[1] - HEAD * (high[1] - low[1]), 2]
    before = (head.min() + head.max()) / 2 - (low[2] + high[2]) / 2
    return 180.0 if before < -ASIDE * (high[2] - low[2]) else 0.0


def _distance(points: NDArray[np.float64], azimuth: float) -> float:
    """How far a camera is from the origin, in this direction, that just holds points (N, 3) and AROUND them."""
    view_from_world = look_at(outward(azimuth, ELEVATION), np.zeros(3), np.array(UP))  # from a distance of 1
    x, y, z = transformed(view_from_world, points).T
    beside = np.maximum(np.abs(x), np.abs(y))
    return float((1 + z + AROUND * beside / tangent(FOV_Y / 2)).max())


def _path_from(folder: Path, mesh: str) -> str:
    """The mesh as a scene file in `folder` names it: relative to it, with /, or as a shipped mesh."""
    if not os.path.exists(mesh):
        return mesh
    whole = Path(mesh).parent.resolve() / Path(mesh).name
    try:
        return Path(os.path.relpath(whole, folder.resolve())).as_posix()
    except ValueError:  # another drive
        return whole.as_posix()


def _quoted(text: str) -> str:
    """A text as TOML writes it."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _already_there(target: Path) -> SceneError:
    return SceneError(told(str(target), "a new file", "one that is there", "choose another with -o, or give --force"))
