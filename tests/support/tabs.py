"""A page's end of the viewer's socket, for tests that need no browser."""

import asyncio
import json
from contextlib import asynccontextmanager

from websockets.asyncio.client import connect

from sss_ref.viewer.server import Viewer
from sss_ref.viewer.studio import starting_point

SMALL = {f"{table}.{side}": 64 for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")}
PATIENCE = 120  # seconds for anything that is waited for


class Page:
    """What a page does: says messages, and reads until something comes."""

    def __init__(self, socket):
        self.socket = socket

    async def say(self, kind, **facts):
        await self.socket.send(json.dumps({"kind": kind, **facts}))

    async def next(self, *kinds, holds=lambda facts: True):
        """Facts and bytes of the next message of these kinds for which something holds; every picture is received."""
        async with asyncio.timeout(PATIENCE):
            while True:
                facts, content = unpacked(await self.socket.recv())
                if facts["kind"] == "picture":
                    await self.say("drawn")
                if facts["kind"] in kinds and holds(facts):
                    return facts, content

    async def still(self):
        """The next picture in full size."""
        return await self.next("picture", holds=lambda facts: not facts["draft"])


def unpacked(message):
    """Facts and bytes of a message."""
    if isinstance(message, str):
        return json.loads(message), b""
    length = int.from_bytes(message[:4], "little")
    return json.loads(message[4 : 4 + length]), message[4 + length :]


@asynccontextmanager
async def served(folder, scene="default", **overrides):
    """A viewer of a small scene."""
    viewer = Viewer(starting_point(scene, SMALL | overrides), folder, "127.0.0.1", 0)
    ready, stop = asyncio.get_running_loop().create_future(), asyncio.Event()
    running = asyncio.create_task(viewer.run(ready.set_result, stop))
    await ready
    try:
        yield viewer
    finally:
        stop.set()
        async with asyncio.timeout(PATIENCE):
            await running


@asynccontextmanager
async def opened_page(viewer):
    """A page of it."""
    own = f"http://127.0.0.1:{viewer.port}"
    async with connect(own.replace("http", "ws") + "/socket", origin=own, max_size=None) as socket:
        yield Page(socket)
