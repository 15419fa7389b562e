"""Work that tells which threads share it."""

import threading
import time


class Meeting:
    """Stands in for a piece of work: no thread goes on before `count` of them are at one."""

    def __init__(self, count):
        self.threads = set()
        self._all_there = threading.Barrier(count)

    def __call__(self, *_):
        self.threads.add(threading.get_ident())
        self._all_there.wait(10)
        time.sleep(0.02)
