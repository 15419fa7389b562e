"""What goes to and fro between a page and its tab, with nothing drawn and no socket."""

import asyncio
import json
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import pytest
from tabs import unpacked

from sss_ref.errors import SceneError
from sss_ref.viewer import tab as module
from sss_ref.viewer.dropped import DroppedFiles
from sss_ref.viewer.studio import DrawnPicture
from sss_ref.viewer.tab import Tab

PATIENCE = 20  # seconds for anything that is waited for


class Connection:
    """A page's end: what is put in comes to the tab, what the tab sends is got."""

    def __init__(self):
        self.heard, self.said = asyncio.Queue(), asyncio.Queue()

    async def send(self, message):
        self.said.put_nowait(unpacked(message))

    async def __aiter__(self):
        while (message := await self.heard.get()) is not None:
            yield message

    def say(self, kind, **facts):
        self.heard.put_nowait(json.dumps({"kind": kind, **facts}))

    async def next(self):
        return await asyncio.wait_for(self.said.get(), PATIENCE)


class Studio:
    """Draws nothing: a picture says which order it is of."""

    def __init__(self, folder):
        self.document = SimpleNamespace(data={"camera": {}}, source="scene.toml")
        self.files, self.orders = DroppedFiles(folder), []

    def picture(self, order, is_stale):
        self.orders.append((order, is_stale))
        if order.buffer == "wrong":
            raise SceneError("a: expected b, got c\nd: expected e, got f")
        return DrawnPicture(None, {"kind": "picture", "draft": order.is_draft, "buffer": order.buffer}, b"pixels")

    def explanation(self, data, pixel):
        return {"kind": "explanation", "pixel": pixel}


def talk(folder, script):
    """Let a script talk with a tab: script(connection, studio, tab)."""

    async def talking():
        connection, studio = Connection(), Studio(folder)
        with ThreadPoolExecutor(1) as pool:
            tab = Tab(connection, studio, pool)
            assert not tab.is_closed
            serving = asyncio.create_task(tab.serve())
            await script(connection, studio, tab)
            connection.heard.put_nowait(None)
            await asyncio.wait_for(serving, PATIENCE)
        assert tab.is_closed

    asyncio.run(talking())


async def begun(connection):
    """Hello and the first two pictures, the second in full size."""
    hello, _ = await connection.next()
    assert (hello["kind"], hello["source"], hello["limit"]) == ("hello", "scene.toml", 2**26)
    for is_draft in (True, False):
        facts, pixels = await connection.next()
        assert (facts["draft"], facts["buffer"], pixels) == (is_draft, "image", b"pixels")
        connection.say("drawn")


def test_a_small_picture_comes_first_and_the_whole_one_after_a_fifth_of_a_second(tmp_path, monkeypatch):
    waited = []

    async def wait_for(waiting, seconds):
        if seconds != PATIENCE:
            waited.append(seconds)
        return await WAIT_FOR(waiting, seconds)

    monkeypatch.setattr(module.asyncio, "wait_for", wait_for)

    async def script(connection, studio, tab):
        await begun(connection)
        assert waited == [0.2]
        connection.say("show", buffer="normal_world")
        facts, _ = await connection.next()
        assert (facts["draft"], facts["buffer"]) == (True, "normal_world")

    talk(tmp_path, script)


WAIT_FOR = asyncio.wait_for


def test_no_picture_is_sent_before_the_last_has_arrived(tmp_path):
    async def script(connection, studio, tab):
        await connection.next()
        await connection.next()
        with pytest.raises(TimeoutError):
            await asyncio.wait_for(connection.said.get(), 0.5)
        connection.say("drawn")
        assert not (await connection.next())[0]["draft"]

    talk(tmp_path, script)


def test_a_whole_picture_is_out_of_date_after_a_change_and_a_draft_when_the_page_is_gone(tmp_path):
    async def script(connection, studio, tab):
        await begun(connection)
        (_, draft), (_, whole) = studio.orders
        assert not draft() and not whole()
        connection.say("show", buffer="uv")
        await connection.next()
        assert not draft() and whole()
        tab.is_closed = True
        assert draft()

    talk(tmp_path, script)


def test_mistakes_are_told_a_line_each(tmp_path):
    async def script(connection, studio, tab):
        await begun(connection)
        connection.say("show", buffer="wrong")
        facts, _ = await connection.next()
        lines = ["a: expected b, got c", "d: expected e, got f"]
        assert facts == {"kind": "problems", "lines": lines, "given": {"camera": {}}}
        connection.heard.put_nowait("{")
        while (facts := (await connection.next())[0])["kind"] != "refused":
            assert facts["kind"] == "problems"
        assert len(facts["lines"]) == 1

    talk(tmp_path, script)


def test_a_dropped_file_comes_in_parts(tmp_path):
    async def script(connection, studio, tab):
        await begun(connection)
        connection.heard.put_nowait(b"of nothing that was announced")
        connection.say("upload", name="a.obj", size=5, adopt=False)
        for part in (b"v 1", b" 2"):
            assert not (tmp_path / "a.obj").exists()
            connection.heard.put_nowait(part)
        assert (await connection.next())[0] == {"kind": "received", "name": "a.obj"}
        assert (tmp_path / "a.obj").read_bytes() == b"v 1 2"
        connection.say("explain", column=1, row=2)
        assert (await connection.next())[0] == {"kind": "explanation", "pixel": [1, 2]}

    talk(tmp_path, script)
