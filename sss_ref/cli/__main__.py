"""`python -m sss_ref.cli` is `python -m sss_ref`."""

from sss_ref.cli.own_process import run

run()
