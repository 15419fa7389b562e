"""Where the command line speaks: results to standard output, everything else to standard error."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer

from rich.console import Console

from sss_ref.cli.options import Execution

DIFFERS, BAD_INPUT = 1, 2  # exit codes other than 0
TABLE_WIDTH = 160  # characters, at most; columns are never squeezed to what a terminal shows in one line
PATIENCE = 1.0  # seconds of work before its progress is shown

out = Console(width=TABLE_WIDTH, highlight=False, soft_wrap=True)
err = Console(stderr=True, highlight=False, soft_wrap=True)


def announce_compilation(execution: Execution) -> None:
    """Say that the first rendering takes longer, if it will."""
    from sss_ref.cache.compiled import is_cold

    if execution.interpreter == "kernel" and is_cold():
        err.print("compiling kernels (once per version; about 7 s) ...")


@contextmanager
def progress(first: str) -> Iterator[Callable[[str], None]]:
    """A function that shows what is being done: on a terminal, from the second second on, and nowhere else."""
    if not err.is_terminal:
        yield lambda text: None
        return
    status = err.status(first)
    timer = Timer(PATIENCE, status.start)
    timer.start()
    try:
        yield status.update
    finally:
        timer.cancel()
        timer.join()
        status.stop()
