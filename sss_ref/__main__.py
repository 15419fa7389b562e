"""`python -m sss_ref`: the command line where the package is on the path but not installed."""

from sss_ref.cli.own_process import run

run()
