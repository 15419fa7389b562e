"""Processes that render items, and what reaches them."""

import signal
from concurrent.futures import Future
from types import SimpleNamespace

import pytest

from sss_ref.batch import executors


class Pool:
    """Stands in for one that starts its processes when it is given the first item: Ctrl-C comes just then."""

    def __init__(self, *setting):
        pass

    def submit(self, work, packed, item):
        signal.raise_signal(signal.SIGINT)
        BLOCKED.append(signal.pthread_sigmask(signal.SIG_BLOCK, ()))
        rendered = Future()
        rendered.set_result(item)
        return rendered

    def shutdown(self, cancel_futures):
        pass


BLOCKED = []


@pytest.fixture
def interruptible():
    """Ctrl-C, also where this process was started to ignore it."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="needs signals that can be blocked, as Linux has")
def test_an_interrupt_reaches_none_of_the_processes_that_begin(monkeypatch, interruptible):
    """Each would print a traceback of what it was importing."""
    monkeypatch.setattr(executors, "ProcessPoolExecutor", Pool)
    before = signal.pthread_sigmask(signal.SIG_BLOCK, ())
    with pytest.raises(KeyboardInterrupt):
        list(executors.in_processes(2)(SimpleNamespace(packed=lambda: b""), [0, 1]))
    assert [before | {signal.SIGINT}] == BLOCKED
    assert signal.pthread_sigmask(signal.SIG_BLOCK, ()) == before
