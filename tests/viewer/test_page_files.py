"""Who may ask for the page, by the name that is asked for, and what of it there is."""

import socket

import pytest

from sss_ref.viewer.page_files import NAMES, is_own_host, only, page_file

HERE, ANYWHERE = "127.0.0.1", "0.0.0.0"


@pytest.mark.parametrize(
    ("header", "host", "expected"),
    [
        ("127.0.0.1:80", HERE, True),
        ("localhost:80", HERE, True),
        ("LOCALHOST:80", HERE, True),
        ("[::1]:80", "::1", True),
        ("127.0.0.1:81", HERE, False),
        ("127.0.0.1", HERE, False),
        ("evil.example:80", HERE, False),
        ("127.0.0.1.evil.example:80", HERE, False),
        ("192.168.1.2:80", HERE, False),
        ("", HERE, False),
        (None, HERE, False),
        ("192.168.1.2:80", ANYWHERE, True),
        (f"{socket.gethostname()}:80", ANYWHERE, True),
        ("evil.example:80", ANYWHERE, False),
        ("studio:80", "studio", True),
    ],
)
def test_a_host_is_ours_or_it_is_not(header, host, expected):
    assert is_own_host(header, host, 80) is expected


@pytest.mark.parametrize("name", NAMES)
def test_every_file_of_the_page_is_there_and_asks_for_nothing_elsewhere(name):
    kind, content = page_file(f"/{name}")
    assert kind.endswith("; charset=utf-8")
    assert b"https://" not in content and content.count(b"http://") == content.count(b"http://www.w3.org/2000/svg")


def test_the_page_itself_comes_without_a_name():
    assert page_file("/") == page_file("/index.html") and page_file("/?a=1") == page_file("/")
    assert page_file("/server.py") is None


def test_a_header_given_twice_counts_as_none():
    assert (only(["a"]), only([]), only(["a", "a"])) == ("a", None, None)
