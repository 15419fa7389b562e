"""The server of the page: this machine only unless told otherwise, and nobody's page but its own may speak to it."""

import asyncio
import signal
import tempfile
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from http import HTTPStatus
from pathlib import Path

from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.datastructures import Headers
from websockets.http11 import Request, Response

from sss_ref.errors import SceneError
from sss_ref.errors.wording import told
from sss_ref.scene_file.reading import Document
from sss_ref.viewer.dropped import DroppedFiles
from sss_ref.viewer.page_files import HEADERS, is_own_host, only, page_file
from sss_ref.viewer.studio import Studio
from sss_ref.viewer.tab import Tab

LONGEST_MESSAGE = 2**20  # bytes: files come in parts
SOCKET = "/socket"  # where the page speaks; everything else is one of its files


class Viewer:
    """A server for one scene, and for as many pages as look at it."""

    def __init__(self, document: Document, folder: Path, host: str, port: int) -> None:
        self.studio = Studio(document, DroppedFiles(folder))
        self.host, self.port = host, port
        self._pool = ThreadPoolExecutor(1, "drawing")
        self._tabs: set[Tab] = set()

    async def run(self, on_ready: Callable[[str], None], stop: asyncio.Event) -> None:
        """Serve until `stop`. on_ready: called with the page's address. Raises SceneError where nothing can listen."""
        try:
            server = await serve(
                self._talk,
                self.host,
                self.port,
                process_request=self._answer,
                max_size=LONGEST_MESSAGE,
                compression=None,  # pictures go to this machine
                close_timeout=1,
            )
        except OSError as error:
            where, came = f"{self.host}:{self.port}", error.strerror or "none"
            raise SceneError(told(where, "a free port", came, "choose another with --port")) from None
        async with server:
            self.port = _port(server)
            on_ready(address(self.host, self.port))
            await stop.wait()
            for tab in self._tabs:
                tab.is_closed = True
        self._pool.shutdown(cancel_futures=True)

    async def _talk(self, connection: ServerConnection) -> None:
        tab = Tab(connection, self.studio, self._pool)
        self._tabs.add(tab)
        try:
            await tab.serve()
        finally:
            self._tabs.discard(tab)

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """A file of the page, or None where the connection may go on as a socket."""
        host = only(request.headers.get_all("Host"))
        if not is_own_host(host, self.host, self.port):
            return _response(HTTPStatus.FORBIDDEN, b"This is not the address that sss-ref view has printed.\n")
        if request.path == SOCKET:
            origin = only(request.headers.get_all("Origin"))
            is_own = origin == f"http://{host}"
            return None if is_own else _response(HTTPStatus.FORBIDDEN, b"Another page may not speak to this one.\n")
        found = page_file(request.path)
        if found is None:
            return _response(HTTPStatus.NOT_FOUND, b"There is no such file.\n")
        kind, content = found
        return _response(HTTPStatus.OK, content, kind)


def view(document: Document, host: str, port: int, on_ready: Callable[[str], None]) -> None:
    """Serve the page of a scene until Ctrl-C.

    document: what `starting_point` gives. host, port: where to listen; port 0 is any that is free. on_ready: called
    with the page's address. Raises SceneError where nothing can listen.
    """

    async def serving() -> None:
        stop = asyncio.Event()
        loop = asyncio.get_running_loop()
        with suppress(NotImplementedError):  # Windows: there Ctrl-C ends the loop by itself
            for each in (signal.SIGINT, signal.SIGTERM):
                loop.add_signal_handler(each, stop.set)
        await Viewer(document, Path(folder), host, port).run(on_ready, stop)

    with tempfile.TemporaryDirectory(prefix="sss_ref_view_") as folder, suppress(KeyboardInterrupt):
        asyncio.run(serving())


def address(host: str, port: int) -> str:
    """What to type into a browser."""
    name = {"0.0.0.0": "localhost", "::": "localhost"}.get(host, host)
    return f"http://{f'[{name}]' if ':' in name else name}:{port}/"


def _port(server: Server) -> int:
    port: int = next(iter(server.sockets)).getsockname()[1]
    return port


def _response(status: HTTPStatus, content: bytes, kind: str = "text/plain; charset=utf-8") -> Response:
    headers = Headers({"Content-Type": kind, "Content-Length": str(len(content)), "Connection": "close", **HEADERS})
    return Response(status, status.phrase, headers, content)
