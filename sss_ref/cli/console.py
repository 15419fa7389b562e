"""Where the command line speaks: results to standard output, everything else to standard error."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from threading import Timer

from rich.console import Console
from rich.markup import escape

from sss_ref.cli.options import Execution

DIFFERS, BAD_INPUT = 1, 2  # exit codes other than 0
READER_GONE = 141  # what a shell says of a program that ends because nobody reads on: no verdict
TABLE_WIDTH = 240  # characters, at most: no name is cut, whatever a terminal shows in one line
PATIENCE = 1.0  # seconds of work before its progress is shown


class Stream(Console):
    """A console that ends the command, without a word, where nobody reads on."""

    def on_broken_pipe(self) -> None:
        """Raise SystemExit, not with the 1 of the base class, which would be a difference."""
        with suppress(SystemExit):
            super().on_broken_pipe()
        raise SystemExit(READER_GONE)


out = Stream(width=TABLE_WIDTH, highlight=False, soft_wrap=True)
err = Stream(stderr=True, highlight=False, soft_wrap=True)


def complain(problem: str) -> int:
    """Say what keeps a command from going on, as far as somebody listens; its exit code."""
    with suppress(OSError):
        err.print(f"[red]error:[/] {escape(problem)}")
    return BAD_INPUT


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
