"""`sss-ref` as a process of its own, whose interpreter may be set up for a short run."""

import gc
import os
import sys
from io import TextIOWrapper
from typing import NoReturn

NEW_OBJECTS = 300_000  # after which rubbish is looked for: a rendering is over before; Python's 700 are soon there


def run() -> NoReturn:
    """Run the command line and end the process with its exit code."""
    gc.set_threshold(NEW_OBJECTS)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # or NumPy starts threads when it is loaded, used by nothing
    from sss_ref.cache.left_out import leave_out
    from sss_ref.cli import main

    leave_out()
    if isinstance(sys.stdout, TextIOWrapper):  # None where it was closed
        sys.stdout.reconfigure(errors="backslashreplace")  # as standard error: a name may be no text of the locale
    try:
        sys.exit(main())
    finally:
        gc.freeze()  # or Python would look for rubbish in all that is loaded, several times, before it ends
