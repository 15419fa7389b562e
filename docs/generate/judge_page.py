"""The page that judges, for the site: a scene of the course, small enough to be read with the page around it."""

from sss_ref.scene.load import load_scene
from sss_ref.webgl import judge_page, reduced

SCENE, SIDE = "figure3_with", 48


def html() -> str:
    """The page."""
    return judge_page(load_scene(SCENE, **reduced(load_scene(SCENE), SIDE)))
