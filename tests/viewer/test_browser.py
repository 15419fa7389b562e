"""The page in a real Chromium: dragged, flown, typed into, given files; its server stopped and started."""

import numpy as np
import pytest
from scenes import sphere, written
from viewing import ViewerPage, ViewerProcess, chromium, needs_page, viewing

from sss_ref.pictures.png_file import image_encoding_of
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

pytestmark = needs_page

SIDE = 96
ARGUMENTS = ("default", "--port", "0", "--size", f"{SIDE}x{SIDE}")
MAPS = {f"{table}.{side}": 96 for table in ("shadow_map", "irradiance_map") for side in ("width", "height")}
SMALL = (*ARGUMENTS, *(part for key, value in MAPS.items() for part in ("--set", f"{key}={value}")))
SCENE = load_scene("default", **MAPS, **{"camera.width": SIDE, "camera.height": SIDE})


@pytest.fixture(scope="module")
def address():
    with viewing(*SMALL) as viewer:
        yield viewer.address


@pytest.fixture(scope="module")
def browser():
    with chromium() as found:
        yield found


@pytest.fixture
def page(browser, address):
    found = ViewerPage(browser, address)
    yield found
    assert found.errors == []
    found.page.close()


def hash_of(scene, buffer="image"):
    return f"{buffer} {render(scene, keep=[buffer]).hashes[buffer]}"


def test_the_canvas_holds_the_pixels_of_render_and_the_page_its_hash(page):
    result = render(SCENE)
    assert page.hash == f"image {result.hashes['image']}"
    shown = np.array(page.canvas(), np.uint8).reshape(SIDE, SIDE, 4)
    np.testing.assert_array_equal(shown[..., :3], image_encoding_of(SCENE.settings)(result.image)[::-1])


def test_dragging_turns_the_camera_and_the_saved_scene_is_what_is_seen(page, tmp_path):
    before = page.hash
    mouse = page.page.mouse
    mouse.move(400, 400)
    mouse.down()
    mouse.move(500, 380, steps=8)
    mouse.up()
    page.another_hash(before)
    seen = page.settled()
    saved = load_scene(page.scene(tmp_path / "scene.toml"))
    assert saved.settings.camera.azimuth < SCENE.settings.camera.azimuth
    assert saved.settings.camera.elevation < SCENE.settings.camera.elevation
    assert hash_of(saved) == seen


def test_the_right_button_slides_and_the_wheel_comes_closer(page, tmp_path):
    before, mouse = page.hash, page.page.mouse
    mouse.move(400, 400)
    mouse.down(button="right")
    mouse.move(430, 400, steps=4)
    mouse.up(button="right")
    after = page.another_hash(before)
    mouse.wheel(0, -200)
    page.another_hash(after)
    page.settled()
    camera = load_scene(page.scene(tmp_path / "scene.toml")).settings.camera
    assert camera.distance < SCENE.settings.camera.distance
    assert camera.target != SCENE.settings.camera.target and camera.azimuth == SCENE.settings.camera.azimuth


def test_keys_fly(page, tmp_path):
    before = page.hash
    page.page.click("#fly")
    page.until(lambda: page.page.get_attribute("#fly", "aria-pressed") == "true")
    page.page.keyboard.down("w")
    page.another_hash(before)
    page.page.wait_for_timeout(300)
    page.page.keyboard.up("w")
    seen = page.settled()
    saved = load_scene(page.scene(tmp_path / "scene.toml"))
    assert saved.settings.camera.type == "free"
    closer = np.linalg.norm(saved.camera.eye) < 0.98 * np.linalg.norm(SCENE.camera.eye)
    assert closer and hash_of(saved) == seen


def test_a_light_is_dragged_in_the_picture(page, tmp_path):
    before = page.hash
    box = page.page.locator(".handle").first.bounding_box()
    mouse = page.page.mouse
    mouse.move(box["x"] + 11, box["y"] + 11)
    mouse.down()
    mouse.move(box["x"] + 151, box["y"] + 41, steps=8)
    mouse.up()
    page.another_hash(before)
    seen = page.settled()
    saved = load_scene(page.scene(tmp_path / "scene.toml"))
    assert saved.lights[0].position[0] > SCENE.lights[0].position[0] + 0.3
    assert (saved.lights[1].position == SCENE.lights[1].position).all()
    assert hash_of(saved) == seen


def test_a_slider_changes_its_key(page):
    before = page.hash
    slider = page.page.locator('[data-key="lights.0.intensity"] input[type=range]')
    slider.focus()
    for _ in range(5):
        page.page.keyboard.press("ArrowRight")
    page.another_hash(before)
    seen = page.settled()
    value = float(page.value("lights.0.intensity"))
    assert value > 0.68
    settings = {**MAPS, "camera.width": SIDE, "camera.height": SIDE, "lights.0.intensity": value}
    assert hash_of(load_scene("default", **settings)) == seen


def test_choices_and_presets(page):
    before = page.hash
    page.page.select_option('[data-key="preset"] select', "paper")
    paper = page.another_hash(before)
    page.page.select_option('[data-key="method"] select', "texture_space")
    page.another_hash(paper)
    size = {"camera.width": SIDE, "camera.height": SIDE}
    scene = load_scene("default", preset="paper", method="texture_space", **MAPS, **size)
    assert page.settled() == hash_of(scene)


def test_a_wrong_value_is_told_and_taken_back(page):
    before = page.hash
    page.open_section("Camera")
    field = page.page.locator('[data-key="camera.fov_y"] input[type=text]')
    field.fill("400")
    field.press("Enter")
    page.until(lambda: "camera.fov_y: expected an angle" in page.page.inner_text("#problems"))
    assert "wrong" in page.page.get_attribute('[data-key="camera.fov_y"]', "class")
    page.page.click("#problems button")
    page.until(lambda: page.page.is_hidden("#problems") and page.hash == before)


def test_a_buffer_is_seen_with_its_bar(page):
    before = page.hash
    page.page.select_option("#buffer", "thickness_1")
    page.another_hash(before)
    assert page.settled() == hash_of(SCENE, "thickness_1")
    assert page.page.is_visible("#ramp") and float(page.page.inner_text("#high")) > 0
    assert "scene units" in page.page.inner_text("#unit")
    page.page.select_option("#buffer", "image")
    page.until(lambda: page.hash == before)
    assert page.page.is_hidden("#scale")


def test_a_click_explains_the_pixel(page):
    page.page.mouse.click(470, 430)
    page.until(lambda: page.page.inner_text("#explained").startswith("Pixel "))
    column, row = map(int, page.page.inner_text("#explained").removeprefix("Pixel ").split(","))
    assert abs(column - SIDE / 2) < 4 and 0 <= row < SIDE
    assert "phong_shading" in page.page.inner_text("#told")
    page.page.keyboard.press("Escape")
    assert page.page.is_hidden("#explanation")


def test_a_good_file_is_shown_and_a_broken_one_told(page, tmp_path):
    before = page.hash
    written(tmp_path / "ball.obj", *sphere(8))
    (tmp_path / "broken.obj").write_text("v 0 0 0\nf 1 2 3\n")
    page.page.set_input_files("#file", tmp_path / "broken.obj")
    page.until(lambda: page.page.inner_text("#problems").startswith("broken.obj: "))
    assert page.page.inner_text("#problems").count("\n") == 0
    page.page.set_input_files("#file", tmp_path / "ball.obj")
    page.another_hash(before)
    seen = page.settled()
    assert page.value("mesh.path") == "ball.obj" and page.page.is_hidden("#problems")
    assert hash_of(load_scene(page.scene(tmp_path / "scene.toml"))) == seen


@pytest.mark.parametrize("width", [1300, 390])
def test_nothing_is_cut(browser, address, width):
    page = ViewerPage(browser, address, width)
    for part in ("#bar > :not(#hint)", "#panel > footer > *", "#size", "#hash", "#picture"):
        for found in page.page.locator(part).all():
            box = found.bounding_box()
            assert box["x"] >= 0 and box["x"] + box["width"] <= width, part
    assert page.page.evaluate("document.documentElement.scrollWidth") == width
    fits = "(each) => [...document.querySelectorAll(each)].every((found) => found.scrollWidth <= found.clientWidth)"
    assert page.page.evaluate(fits, "#panel, .row")
    page.page.click("#fold")
    assert page.page.is_hidden("#panel")
    page.page.close()


def test_a_server_that_is_started_again_gets_the_scenes_back(browser):
    viewer = ViewerProcess(*SMALL)
    one, other = ViewerPage(browser, viewer.address), ViewerPage(browser, viewer.address)
    before = one.hash
    one.page.select_option('[data-key="preset"] select', "paper")
    changed = one.another_hash(before)
    code, said = viewer.interrupt()
    assert code == 0 and "Traceback" not in said
    one.until(lambda: "not reached" in one.page.inner_text("#link"))
    arguments = [*SMALL]
    arguments[arguments.index("--port") + 1] = str(viewer.port)
    with viewing(*arguments):
        one.until(lambda: one.page.inner_text("#link") == "")
        other.until(lambda: other.page.inner_text("#link") == "")
        assert one.settled() == changed and other.settled() == before
        one.page.select_option('[data-key="preset"] select', "robust")
        one.until(lambda: one.hash == before)
        one.page.close()
        other.page.close()
