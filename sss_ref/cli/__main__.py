"""`python -m sss_ref.cli`: the command line where the package is on the path but not installed."""

import sys

from sss_ref.cli import main

sys.exit(main())
