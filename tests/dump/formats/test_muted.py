"""What is printed meanwhile by a library goes nowhere; afterwards all is as it was."""

import os
import sys

import pytest

from sss_ref.dump.formats.muted import muted


def test_nothing_is_printed_meanwhile(capfd):
    os.write(2, b"before\n")
    with muted():
        os.write(2, b"a library in C\n")
        print("a library in Python")
    print("after")
    os.write(2, b"after\n")
    assert capfd.readouterr() == ("after\n", "before\nafter\n")


def test_all_is_as_it_was_after_an_error(capfd):
    with pytest.raises(ValueError), muted():
        raise ValueError
    os.write(2, b"after\n")
    assert capfd.readouterr().err == "after\n"


def test_a_process_without_standard_error(monkeypatch):
    def closed(number):
        raise OSError

    monkeypatch.setattr(os, "dup", closed)
    with muted():
        print("a library in Python", file=sys.stdout)
