"""The page that judges: every stage of a scene drawn by the reader's own device, beside all that is right there."""

import json
from collections.abc import Mapping
from html import escape
from importlib.resources import files

from sss_ref.errors import SceneError
from sss_ref.errors.wording import told
from sss_ref.pictures.page_style import PAGE_STYLE
from sss_ref.scene.scene import Scene
from sss_ref.webgl.judge_content import judge_content

LEAST, MOST = 8, 128  # pixels of a side: enough to judge, and few enough for a page that is quickly read
STYLE = "judge/judge.css"
SCRIPTS = (
    "drawing.js",
    *(f"judge/{name}.js" for name in ("unpacking", "numbers", "verdicts", "pictures", "editor", "judge", "shown")),
)


def judge_page(scene: Scene) -> str:
    """A page of HTML, to be opened in a browser, that draws each stage of a scene by itself, and judges it.

    scene: with pictures of at most 128 x 128 pixels (see `reduced`).
    The page reads nothing but itself and sends nothing. Its inputs are the reference's; its reader may change the
    shader of any stage, and reads which is the first that is wrong, at which pixel, and what would have been right.
    Raises SceneError for larger pictures, and RenderError and MeshError as `sss_ref.render` does.
    """
    _check_size(scene)
    folder, content = files("sss_ref.webgl"), judge_content(scene)
    style, *scripts = ((folder / name).read_text(encoding="utf-8") for name in (STYLE, *SCRIPTS))
    template = (folder / "judge" / "judge.html").read_text(encoding="utf-8")
    return template.format(
        title=escape(f"Is it right? {scene.source}"),
        style=PAGE_STYLE + style,
        script="\n".join(scripts),
        content=json.dumps(content).replace("<", "\\u003c"),
        **{name: escape(str(value)) for name, value in content["about"].items()},
    )


def reduced(scene: Scene, side: int) -> Mapping[str, int]:
    """Overrides for `load_scene` by which the longer side of every picture of a scene has so many pixels.

    Raises SceneError for a side that no page has.
    """
    if not LEAST <= side <= MOST:
        raise SceneError(told("side", f"{LEAST} to {MOST} pixels", str(side), "take 48, which shows most mistakes"))
    found: dict[str, int] = {}
    for each in scene.method.passes:
        size = scene.size(each)
        width, height = (max(LEAST, round(length * side / max(size))) for length in size)
        found |= {f"{each.target}.width": width, f"{each.target}.height": height}
    return found


def _check_size(scene: Scene) -> None:
    for each in scene.method.passes:
        width, height = scene.size(each)
        if max(width, height) > MOST:
            came, remedy = f"{width} x {height}", "load the scene with the overrides that `reduced` gives"
            raise SceneError(told(each.target, f"at most {MOST} x {MOST} pixels", came, remedy))
