"""`sss-ref view`."""

from importlib.util import find_spec
from typing import Annotated

from cyclopts import Parameter
from rich.markup import escape

from sss_ref.cli.console import announce_compilation, err, out
from sss_ref.cli.options import KERNELS, NO_CHANGES, Changes
from sss_ref.errors import SceneError
from sss_ref.errors.wording import told

NEEDED = ("websockets", "tomlkit")


def view(
    scene: Annotated[str, Parameter(help="A scene file, or the name of a shipped scene.")] = "default",
    *,
    host: Annotated[str, Parameter(help="Who may connect: this machine only, or 0.0.0.0 for everyone.")] = "127.0.0.1",
    port: Annotated[int, Parameter(help="Of the page's address; 0: any that is free.")] = 8710,
    browser: Annotated[bool, Parameter(name="--open", negative="", help="Open the page in your browser.")] = False,
    changes: Changes = NO_CHANGES,
) -> int:
    """Show a scene in the browser, and change it there: camera, lights, every key; any buffer, any pixel explained."""
    if not all(map(find_spec, NEEDED)):
        remedy = "python -m pip install 'sss_ref[view]'"
        raise SceneError(told("view", "the extra `view`", "an installation without", remedy))
    if not 0 <= port <= 65535:
        raise SceneError(told("--port", "0 to 65535", str(port), "choose another"))
    from sss_ref.viewer.server import view as serve
    from sss_ref.viewer.studio import starting_point

    announce_compilation(KERNELS)
    document = starting_point(scene, changes.overrides())

    def tell(address: str) -> None:
        out.print(f"{escape(address)} shows {escape(document.source)}; Ctrl-C ends it")
        out.file.flush()  # into a pipe, too: whoever waits for the address reads on
        if browser:
            import webbrowser

            webbrowser.open(address)

    serve(document, host, port, tell)
    err.print("ended")
    return 0
