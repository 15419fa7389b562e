"""One page in a browser: its messages are taken as they come, and of the pictures it wants the newest is drawn."""

import asyncio
import json
from collections.abc import Callable, Coroutine
from concurrent.futures import Executor
from contextlib import suppress
from typing import Any, TypeVar

from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from sss_ref.errors import SssRefError
from sss_ref.viewer import messages
from sss_ref.viewer.dropped import SIZE_LIMIT, DroppedFile
from sss_ref.viewer.keeping import FILES, kept_file
from sss_ref.viewer.menu import menu
from sss_ref.viewer.session import Session, started
from sss_ref.viewer.studio import Order, Studio, Superseded

QUIET = 0.2  # seconds without a change, after which the whole picture is drawn
T = TypeVar("T")


class Tab:
    """A page at the other end of a connection. pool: the one thread that draws, for all pages in turn."""

    def __init__(self, connection: ServerConnection, studio: Studio, pool: Executor) -> None:
        self.connection, self.studio, self.pool = connection, studio, pool
        self.session = Session(studio.document.data)
        self.is_closed = False
        self._changed, self._arrived = asyncio.Event(), asyncio.Event()
        self._dropped: DroppedFile | None = None
        self._explaining: asyncio.Task[None] | None = None

    async def serve(self) -> None:
        """Talk to the page until it goes away."""
        hello = {"kind": "hello", "menu": menu(), "source": self.studio.document.source, "limit": SIZE_LIMIT}
        self._changed.set()
        self._arrived.set()
        try:
            async with asyncio.TaskGroup() as tasks:
                self._tasks = tasks
                await self._tell(hello)
                drawing = tasks.create_task(self._draw())
                async for message in self.connection:
                    await self._told_of(self._take(message))
                self.is_closed = True
                drawing.cancel()
        except* ConnectionClosed:
            pass
        finally:
            self.is_closed = True

    async def _draw(self) -> None:
        """Draw small while changes come, and whole once they rest; what is out of date is given up."""
        while True:
            await self._changed.wait()
            self._changed.clear()
            await self._picture(is_draft=True)
            with suppress(TimeoutError):
                await asyncio.wait_for(self._changed.wait(), QUIET)
                continue
            await self._picture(is_draft=False)

    async def _picture(self, is_draft: bool) -> None:
        session, version = self.session, self.session.version
        order = Order(session.data, session.buffer, is_draft)

        def is_stale() -> bool:
            return self.is_closed or (not is_draft and session.version != version)

        try:
            picture = await self._apart(lambda: self.studio.picture(order, is_stale))
        except Superseded:
            return
        except SssRefError as error:
            await self._tell({"kind": "problems", "lines": str(error).splitlines(), "given": order.data})
            return
        session.accept(order.data, picture.scene)
        await self._arrived.wait()
        self._arrived.clear()
        await self._send(picture.facts, picture.pixels)

    async def _take(self, message: str | bytes) -> None:
        """Do what the page says."""
        if isinstance(message, bytes):
            await self._receive(message)
        else:
            await self._obey(messages.message_of(message))

    async def _told_of(self, work: Coroutine[Any, Any, None]) -> None:
        """Do some work; what is wrong with it is told in one line."""
        try:
            await work
        except SssRefError as error:
            await self._tell({"kind": "refused", "lines": str(error).splitlines()})

    async def _obey(self, message: Any) -> None:
        match message:
            case messages.Drawn():
                self._arrived.set()
            case messages.Upload(name=name, size=size, adopt=adopt):
                self._dropped = self.studio.files.announced(name, size, adopt)
            case messages.Explain(column=column, row=row):
                if self._explaining:
                    self._explaining.cancel()  # what has not begun never does
                self._explaining = self._meanwhile(self._explain((column, row)))
            case messages.SaveFile(what=what):
                self._meanwhile(self._save(what))
            case _:
                self.session.take(message)
                self._changed.set()

    def _meanwhile(self, work: Coroutine[Any, Any, None]) -> asyncio.Task[None]:
        """Some work that the page's next messages do not wait for."""
        return self._tasks.create_task(self._told_of(work))

    async def _explain(self, pixel: tuple[int, int]) -> None:
        data = self.session.data
        await self._tell(await self._apart(lambda: self.studio.explanation(data, pixel)))

    async def _save(self, what: str) -> None:
        data = self.session.data
        content = await self._apart(lambda: kept_file(what, self.studio, data))
        await self._send({"kind": "file", **FILES[what]}, content)

    async def _receive(self, part: bytes) -> None:
        """The next bytes of a dropped file; a whole mesh becomes the scene, if that is wanted."""
        if self._dropped is None:
            return  # of a file that was refused
        self._dropped.add(part)
        if not self._dropped.is_whole:
            return
        file, self._dropped = self._dropped, None
        path = self.studio.files.keep(file)
        if file.adopt:
            self.session.begin(await self._apart(lambda: started(path)))
            self._changed.set()
        await self._tell({"kind": "received", "name": file.name})

    async def _apart(self, job: Callable[[], T]) -> T:
        """What a job gives that runs in the drawing thread."""
        return await asyncio.get_running_loop().run_in_executor(self.pool, job)

    async def _tell(self, facts: dict[str, Any]) -> None:
        await self.connection.send(json.dumps(facts))

    async def _send(self, facts: dict[str, Any], content: bytes) -> None:
        """Bytes, and before them what they are: the length of a text in 4 bytes, the text, the bytes."""
        head = json.dumps(facts).encode()
        await self.connection.send(b"".join((len(head).to_bytes(4, "little"), head, content)))
