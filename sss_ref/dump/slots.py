"""What a dump is held against: the form of each buffer, and where it is seen from and what covers it."""

from collections.abc import Mapping
from dataclasses import dataclass

from sss_ref.language.names import Name
from sss_ref.language.pipeline import Pass
from sss_ref.passes.buffers import described
from sss_ref.scene.forms import Form
from sss_ref.scene.scene import Scene
from sss_ref.view.views import View


@dataclass(frozen=True)
class Slot(Form):
    """The form of a buffer, and what only the scene knows of it.

    view: what the pass is drawn from; None for a layout of UVs. mask: the buffer that tells where the pass drew
    something, "" if there is none. largest: of triangle numbers the last one of the mesh; else None.
    """

    view: View | None = None
    mask: str = ""
    largest: int | None = None

    @property
    def is_window_depth(self) -> bool:
        """Whether it holds depths from 0 at the near plane to 1 at the far one."""
        return described(self.name).unit.startswith("window depth")


def slots_of(scene: Scene) -> Mapping[str, Slot]:
    """Buffer -> its slot, for all that the scene's method can write, registers too, in stage order."""
    slots = {}
    for each in scene.method.passes:
        view, mask = _view_of(each, scene), _mask_of(each)
        last = len(scene.mesh_of(each).triangles) - 1 if each.draw.mesh else None
        for name in each.values:
            largest = last if described(name).unit.startswith("triangle index") else None
            slots[name] = Slot(**vars(scene.forms[name]), view=view, mask=mask, largest=largest)
    return slots


def _view_of(this_pass: Pass, scene: Scene) -> View | None:
    """The camera, or the light whose number the pass has; the only one has none."""
    if this_pass.target == "shadow_map":
        return scene.lights[max(Name.of(this_pass.name).light, 1) - 1].view
    return scene.camera if this_pass.target == "camera" else None


def _mask_of(this_pass: Pass) -> str:
    """The coverage of the pass, or else its triangle numbers, which are -1 where nothing is drawn."""
    draw = this_pass.draw
    return draw.stencil or draw.coverage or draw.triangle
