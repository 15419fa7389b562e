"""The files of the page, and who may ask for them: this machine's own browser, by the address that it was given."""

import ipaddress
import socket
from collections.abc import Iterable
from importlib.resources import files

TYPES = {"html": "text/html", "css": "text/css", "js": "text/javascript", "svg": "image/svg+xml"}
NAMES = ("index.html", "viewer.css", "main.js", "link.js", "picture.js", "controls.js", "menu.js", "icon.svg")
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; connect-src 'self'; "
    "img-src 'self' blob: data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
HEADERS = {
    "Content-Security-Policy": POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-store",
}


def page_file(path: str) -> tuple[str, bytes] | None:
    """Type and content of what a path of the page's address names; None where there is nothing."""
    name = path.partition("?")[0].removeprefix("/") or NAMES[0]
    if name not in NAMES:
        return None
    content = (files("sss_ref.viewer") / "page" / name).read_bytes()
    return f"{TYPES[name.rpartition('.')[2]]}; charset=utf-8", content


def is_own_host(header: str | None, host: str, port: int) -> bool:
    """Whether a Host header names this server: a page of another name that leads here does not.

    host: what the server listens at. Where that is every address of the machine, any numeric address will do.
    """
    name, found, number = (header or "").rpartition(":")
    if not found or number != str(port):
        return False
    name = name.strip("[]").lower()
    if name in own_names(host):
        return True
    return not is_loopback(host) and is_address(name)


def own_names(host: str) -> set[str]:
    """The names of a server that listens at `host`."""
    here = {"localhost", "127.0.0.1", "::1"}
    return here if is_loopback(host) else here | {host.lower(), socket.gethostname().lower()}


def is_loopback(host: str) -> bool:
    """Whether only this machine reaches what listens at `host`."""
    return host == "localhost" or (is_address(host) and ipaddress.ip_address(host).is_loopback)


def is_address(name: str) -> bool:
    """Whether a name is an address in numbers."""
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def only(values: Iterable[str]) -> str | None:
    """The one value of a header; None where it is missing or given twice."""
    found = list(values)
    return found[0] if len(found) == 1 else None
