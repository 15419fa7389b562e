#!/usr/bin/env bash
# Build the documentation into docs/_build/html, with warnings as errors. Needs `pip install ".[docs]"` beforehand, and no
# network; neither do the pages. Notebooks run once: their results are kept in docs/_build/executed until they, or what
# they run, change.
set -euo pipefail
cd "$(dirname "$0")"
python -m sphinx --builder html --fail-on-warning --keep-going --fresh-env "$@" . _build/html

remote='<(script|img|link|iframe|source)[^>]+(src|href)="(https?:)?//|(@import|url\()["'"'"' ]*(https?:)?//'
if grep -rlE "$remote" _build/html --include='*.html' --include='*.css'; then
    echo "these pages load something from the network" >&2
    exit 1
fi
