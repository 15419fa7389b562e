"""A smaller picture while something is dragged, so that pictures come fast; what it leaves out, the next one has."""

from typing import Any

from sss_ref.scene_file.settings import SceneFile

SIDES = (768, 512, 448, 384, 320, 256, 224, 192, 160, 128, 96)  # pixels: of the longer side of a draft, largest first
SLOWEST = 0.030  # seconds for a draft; with its way to the page more than 20 come in a second
ROOM_FOR_MORE = 0.8  # of that: a larger draft is tried where it will probably take no longer


class Pace:
    """How large a draft may be on this machine, now: learned from how long the last ones took."""

    def __init__(self) -> None:
        self._index = SIDES.index(256)

    @property
    def side(self) -> int:
        """The longer side of the next draft, pixels."""
        return SIDES[self._index]

    def took(self, seconds: float) -> None:
        """Learn from a draft of this size."""
        larger = SIDES[max(self._index - 1, 0)]
        if seconds > SLOWEST:
            self._index = min(self._index + 1, len(SIDES) - 1)
        elif seconds * (larger / self.side) ** 2 < ROOM_FOR_MORE * SLOWEST:
            self._index = max(self._index - 1, 0)


def draft_settings(settings: SceneFile, side: int) -> SceneFile:
    """Settings for a picture whose longer side is at most `side` pixels, its maps as much smaller; or the same ones.

    What counts in pixels or texels shrinks with them, so that the picture looks as the large one does.
    """
    camera, shadow_map, layout, blur = settings.camera, settings.shadow_map, settings.irradiance_map, settings.blur
    share = side / max(camera.width, camera.height)
    if share >= 1:
        return settings
    texels = min(1.0, side / max(shadow_map.width, shadow_map.height))
    charts = min(1.0, side / max(layout.width, layout.height))
    blurred = share if settings.method == "screen_space" else charts
    in_texels = {key: getattr(shadow_map, key) * texels for key in ("kernel_scale", "lookup_depth")}
    return settings.model_copy(
        update={
            "camera": camera.model_copy(update=_sizes(camera, share)),
            "shadow_map": shadow_map.model_copy(update={**_sizes(shadow_map, texels), **in_texels}),
            "irradiance_map": layout.model_copy(update=_sizes(layout, charts)),
            "blur": blur.model_copy(update={"pixel_scale": blur.pixel_scale * blurred}),
        }
    )


def _sizes(table: Any, share: float) -> dict[str, int]:
    return {side: max(1, round(getattr(table, side) * share)) for side in ("width", "height")}
