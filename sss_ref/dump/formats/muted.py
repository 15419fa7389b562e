"""Libraries that tell the terminal what is wrong with a file, where our one line is to stand."""

import os
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from io import StringIO
from threading import Lock

STDERR = 2
_one_at_a_time = Lock()


@contextmanager
def muted() -> Iterator[None]:
    """Standard error as the system has it, and Python's standard output, lead nowhere in the meantime.

    OpenEXR's C part writes to the one, its Python part to the other. What another thread prints meanwhile is lost too.
    """
    with _one_at_a_time, redirect_stdout(StringIO()), open(os.devnull, "wb") as nowhere:
        try:
            before = os.dup(STDERR)
        except OSError:  # a process without standard error
            yield
            return
        os.dup2(nowhere.fileno(), STDERR)
        try:
            yield
        finally:
            os.dup2(before, STDERR)
            os.close(before)
