"""The command line's own help as a page."""

import re

from sss_ref.cli import app

HEAD = """# Command line

Results go to standard output, everything else to standard error. The exit code is 0; 1 where `verify`, `diff` or
`validate` finds a difference, or `import` a picture that may be two buffers; 2 for bad input, and where memory or
place ran out; 130 where the run was stopped, 141 where nobody reads its output to the end.
"""


def page() -> str:
    """The page: every command with its parameters, as `--help` shows them."""
    text = app.generate_docs(output_format="markdown")
    commands = text[text.index("\n## sss-ref ") :]  # what is before lists them, as the page's own contents do
    commands = re.sub(r"^(sss-ref \w+) -m \w+", r"\1", commands, flags=re.MULTILINE)  # how Sphinx itself was started
    return f"{HEAD}\n{commands.replace('```console', '```shell').strip()}\n"
