"""The server, spoken to as a page does."""

import asyncio
import http.client
import io
import json
import threading
import zipfile

import numpy as np
import pytest
from scenes import sphere, written
from tabs import PATIENCE, SMALL, opened_page, served, unpacked
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus

from sss_ref.pictures.png_file import image_encoding_of
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

WIDE = {"camera.width": 512, "camera.height": 256}
LARGE = {"camera.width": 2048, "camera.height": 2048}
WRONG = ["", "[]", "{", '{"kind": "jump"}', '{"kind": "turn", "right": 1e9, "up": 0}', '{"kind": "set"}', "1" * 999]


def has(**wanted):
    """Whether a picture is a whole one with a buffer, a size or a value of phong.ambient."""

    def holds(facts):
        found = {"ambient": facts["values"]["phong"]["ambient"], **facts}
        return facts["hash"] and all(found[key] == value for key, value in wanted.items())

    return holds


def run(test):
    return asyncio.run(asyncio.wait_for(test, 3 * PATIENCE))


def test_what_is_shown_is_what_render_gives(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            hello, _ = await page.next("hello")
            assert hello["source"] == "default"
            return await page.still()

    facts, content = run(talk())
    scene = load_scene("default", **SMALL)
    result = render(scene)
    assert facts["hash"] == result.hashes["image"]
    shown = np.frombuffer(content, np.uint8).reshape(64, 64, 4)
    np.testing.assert_array_equal(shown[..., :3], image_encoding_of(scene.settings)(result.image)[::-1])
    assert (shown[..., 3] == 255).all()


def test_the_first_picture_is_a_small_one_and_a_change_is_drawn(tmp_path):
    async def talk():
        async with (
            served(tmp_path, **WIDE) as viewer,
            opened_page(viewer) as page,
        ):
            first, _ = await page.next("picture")
            assert first["draft"] and (first["width"], first["height"]) == (256, 128) and first["hash"] is None
            await page.say("set", key="phong.ambient", value=0.3)
            return await page.still()

    facts, _ = run(talk())
    scene = load_scene("default", **SMALL | WIDE, **{"phong.ambient": 0.3})
    assert facts["hash"] == render(scene).hashes["image"]


def test_of_many_changes_the_newest_is_drawn_and_none_queues_up(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            await page.still()
            count = 0
            for step in range(200):
                await page.say("set", key="lights.0.intensity", value=step / 200)
            while True:
                facts, _ = await page.next("picture")
                count += 1
                if not facts["draft"] and facts["values"]["lights"][0]["intensity"] == 199 / 200:
                    return count

    assert run(talk()) < 100


def test_a_whole_picture_that_a_change_makes_old_is_given_up(tmp_path):
    """The first whole picture is held up until the server knows of a change; then it must be stale."""
    held, known, stale = threading.Event(), threading.Event(), []

    async def talk():
        async with served(tmp_path) as viewer:
            real = viewer.studio.picture

            def picture(order, is_stale):
                if held.is_set() or order.is_draft:
                    return real(order, is_stale)
                stale.append(is_stale())
                held.set()
                assert known.wait(PATIENCE)
                stale.append(is_stale())
                return real(order, is_stale)

            viewer.studio.picture = picture
            async with opened_page(viewer) as page:
                await page.next("picture")
                assert await asyncio.to_thread(held.wait, PATIENCE)
                await page.say("set", key="phong.ambient", value=0.2)
                await page.say("upload", name="a.obj", size=2**40, adopt=True)
                await page.next("refused")  # what was said before it has been taken
                known.set()
                facts, _ = await page.next("picture")  # the very next: the old one never comes
                return facts["values"]["phong"]["ambient"]

    assert run(talk()) == 0.2
    assert stale == [False, True]


def test_the_next_picture_waits_until_the_last_has_arrived(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            await page.still()
            await page.say("set", key="lights.0.intensity", value=0)
            async with asyncio.timeout(PATIENCE):
                while unpacked(await page.socket.recv())[0]["kind"] != "picture":
                    pass
            more = 0  # since the one that the page has not said it drew
            for step in range(1, 20):
                await page.say("set", key="lights.0.intensity", value=step / 20)
                try:
                    async with asyncio.timeout(0.3):
                        while True:
                            facts, _ = unpacked(await page.socket.recv())
                            more += facts["kind"] == "picture"
                except TimeoutError:
                    pass
            return more

    assert run(talk()) == 0


@pytest.mark.parametrize("text", WRONG)
def test_a_wrong_message_is_told_in_one_line(tmp_path, text):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            await page.socket.send(text)
            facts, _ = await page.next("refused")
            return facts["lines"]

    (line,) = run(talk())
    assert line.startswith("message: ") and line.endswith(
        ": expected what this page sends, got something else; load the page again"
    )


def test_mistakes_are_told_and_can_be_taken_back(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            good, _ = await page.still()
            await page.say("set", key="camera.fov_y", value=400)
            wrong, _ = await page.next("problems")
            await page.say("back")
            again, _ = await page.still()
            return good["hash"], wrong["lines"], again["hash"]

    before, lines, after = run(talk())
    assert lines == [
        "default: camera.fov_y: expected an angle between 0 and 180 degrees, got 400; choose another value"
    ]
    assert before == after


def test_another_page_may_not_connect_and_another_name_sees_nothing(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer:
            for origin in ("http://evil.example", f"http://localhost:{viewer.port}", None):
                with pytest.raises(InvalidStatus) as caught:
                    async with connect(f"ws://127.0.0.1:{viewer.port}/socket", origin=origin):
                        pass
                assert caught.value.response.status_code == 403
            asked = [
                f"127.0.0.1:{viewer.port}",
                f"localhost:{viewer.port}",
                f"evil.example:{viewer.port}",
                "127.0.0.1:1",
            ]
            return [await asyncio.to_thread(status, viewer.port, host, "/") for host in asked]

    assert run(talk()) == [200, 200, 403, 403]


@pytest.mark.parametrize("path", ["/nothing", "/../__init__.py", "/%2e%2e/server.py", "//etc/passwd", "/socket/.."])
def test_nothing_but_the_page_is_served(tmp_path, path):
    async def talk():
        async with served(tmp_path) as viewer:
            return await asyncio.to_thread(status, viewer.port, f"127.0.0.1:{viewer.port}", path)

    assert run(talk()) == 404


def status(port, host, path):
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=PATIENCE)
    connection.request("GET", path, headers={"Host": host})
    return connection.getresponse().status


def test_a_dropped_mesh_becomes_the_scene(tmp_path):
    written(tmp_path / "ball.obj", *sphere(6))
    content = (tmp_path / "ball.obj").read_bytes()
    (tmp_path / "files").mkdir()

    async def talk():
        async with served(tmp_path / "files") as viewer, opened_page(viewer) as page:
            await page.still()
            await page.say("upload", name="ball.obj", size=len(content), adopt=True)
            await page.socket.send(content[:1000])
            await page.socket.send(content[1000:])
            await page.next("received")
            await page.say("set", key="camera.width", value=64)
            await page.say("set", key="camera.height", value=64)
            facts, _ = await page.next("picture", holds=has(size=[64, 64]))
            await page.say("save", what="scene")
            return facts, (await page.next("file"))[1]

    facts, scene = run(talk())
    assert facts["given"]["mesh"]["path"] == "ball.obj"
    (tmp_path / "scene.toml").write_bytes(scene)
    assert render(load_scene(tmp_path / "scene.toml")).hashes["image"] == facts["hash"]


@pytest.mark.parametrize(
    ("name", "content", "line"),
    [
        ("a.obj", b"v 0 0 nan\nf 1 1 1\n", "a.obj: "),
        ("a.exe", b"x", '"a.exe": expected a file ending in .obj, .ply'),
        ("../a.obj", b"x", '"../a.obj": expected a file ending in .obj, .ply'),
        ("a.glb", b"glTF", "a.glb: "),
    ],
)
def test_a_broken_file_is_told_in_one_line(tmp_path, name, content, line):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            good, _ = await page.still()
            await page.say("upload", name=name, size=len(content), adopt=True)
            await page.socket.send(content)
            facts, _ = await page.next("refused")
            await page.say("show", buffer="image")
            again, _ = await page.still()
            assert again["hash"] == good["hash"]
            return facts["lines"]

    (told,) = run(talk())
    assert told.startswith(line) and str(tmp_path) not in told


def test_a_file_too_large_is_refused_before_it_comes(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            await page.say("upload", name="a.obj", size=2**40, adopt=True)
            return (await page.next("refused"))[0]["lines"]

    assert run(talk()) == ["a.obj: expected 1 to 67108864 bytes, got 1099511627776; simplify the mesh"]


def test_the_page_reads_no_file_of_this_machine(tmp_path):
    secret = tmp_path / "secret.obj"
    written(secret, *sphere(3))
    (tmp_path / "files").mkdir()

    async def talk():
        async with served(tmp_path / "files") as viewer, opened_page(viewer) as page:
            await page.still()
            await page.say("set", key="mesh.path", value=str(secret))
            return (await page.next("problems"))[0]["lines"]

    (line,) = run(talk())
    assert line.startswith("mesh.path: expected a shipped mesh or a dropped file, got ")


def test_a_pixel_is_explained(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            await page.still()
            await page.say("explain", column=32, row=32)
            return (await page.next("explanation"))[0]

    facts = run(talk())
    assert facts["pixel"] == [32, 32] and "back_point" in facts["html"]


def test_every_buffer_can_be_seen(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            facts, _ = await page.still()
            names = [name for each in facts["passes"] for name in each["buffers"]]
            hashes = {}
            for name in names:
                await page.say("show", buffer=name)
                shown, content = await page.next("picture", holds=has(buffer=name))
                assert len(content) == 4 * shown["width"] * shown["height"]
                hashes[name] = shown["hash"]
            return hashes

    scene = load_scene("default", **SMALL)
    assert run(talk()) == dict(render(scene, keep=[*scene.method.values]).hashes)


def test_several_pages_have_scenes_of_their_own(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as one, opened_page(viewer) as other:
            await one.say("set", key="phong.ambient", value=0.9)
            first, _ = await one.next("picture", holds=has(ambient=0.9))
            second, _ = await other.still()
            return first["values"]["phong"]["ambient"], second["values"]["phong"]["ambient"]

    assert run(talk()) == (0.9, 0.04)


def test_a_page_brings_its_scene_to_a_new_server(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            await page.say("set", key="phong.ambient", value=0.5)
            before, _ = await page.next("picture", holds=has(ambient=0.5))
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            await page.say("restore", data=before["given"])
            after, _ = await page.next("picture", holds=has(ambient=0.5))
            return before["hash"], after["hash"]

    before, after = run(talk())
    assert before == after


def test_a_server_that_stops_while_it_draws_ends(tmp_path):
    async def talk():
        async with (
            served(tmp_path, **LARGE) as viewer,
            opened_page(viewer) as page,
        ):
            await page.say("set", key="phong.ambient", value=0.5)
            await page.next("picture")
            await asyncio.sleep(0.5)  # the large one is being drawn

    run(talk())


def test_the_bundle_and_the_picture_are_those_of_the_commands(tmp_path):
    async def talk():
        async with served(tmp_path) as viewer, opened_page(viewer) as page:
            found = {}
            for what in ("bundle", "picture"):
                await page.say("save", what=what)
                facts, content = await page.next("file")
                found[facts["name"]] = content
            return found

    found = run(talk())
    with zipfile.ZipFile(io.BytesIO(found["bundle.zip"])) as packed:
        assert {"bundle/uniforms.json", "bundle/passes.json", "bundle/PORTING.md"} <= set(packed.namelist())
        assert json.loads(packed.read("bundle/scene.json"))["settings"]["camera"]["width"] == 64
    render(load_scene("default", **SMALL)).save(tmp_path / "out")
    assert found["image.png"] == (tmp_path / "out" / "image.png").read_bytes()
