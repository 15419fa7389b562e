"""The documentation site; `docs/build.sh` builds it, without network and with warnings as errors."""

import inspect
import os
import sys
from importlib.util import find_spec
from pathlib import Path

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS / "generate"))

import house_docstrings  # noqa: E402
import pages  # noqa: E402

from sss_ref.course.frames import WANTED  # noqa: E402
from sss_ref.rules import RULES_VERSION  # noqa: E402

project = "sss_ref"
author = "the authors of sss_ref"
extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx_copybutton",
    "sphinx_design",
]
exclude_patterns = ["_build", "conf.py", "generate", "generated/lessons.md"]
nitpicky = True
nitpick_ignore_regex = [("py:.*", "(numpy|np|collections|concurrent|os|pathlib|typing|Path|PathLike|NDArray|Matrix).*")]

html_theme = "furo"
html_title = "sss_ref"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = [(name, {"defer": "defer"}) for name in ("rows.js", "sliders.js")]
html_extra_path = ["generated/site"]
html_copy_source = False
html_show_copyright = False
html_theme_options = {"top_of_page_buttons": []}

# MathJax as a file of our own, so that pages are read without network; its SVG form needs no fonts.
mathjax_folder = Path(next(iter(find_spec("sphinx-mathjax-offline").submodule_search_locations)), "static", "mathjax")
html_static_path.append(str(mathjax_folder / "tex-svg.js"))
mathjax_path = "tex-svg.js"

myst_enable_extensions = ["attrs_inline", "colon_fence", "deflist", "dollarmath", "substitution"]
myst_heading_anchors = 3
myst_substitutions = {"rules_version": RULES_VERSION}

nb_custom_formats = {".py": ["jupytext.reads", {"fmt": "py:percent"}]}
nb_execution_mode = "cache"
nb_execution_cache_path = str(DOCS / "_build" / "executed" / pages.what_notebooks_run())
nb_execution_timeout = 300
nb_execution_raise_on_error = True
nb_ipywidgets_js = {}  # no script from the network: where a notebook has sliders, the page has pictures to choose from
os.environ[WANTED] = "1"  # for the notebooks that run
nb_mime_priority_overrides = [("html", "application/vnd.jupyter.widget-view+json", None)]  # it has a page, too
nb_merge_streams = True

autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
autodoc_typehints_format = "short"
default_role = "code"


def setup(app):
    """Write the generated pages, and read docstrings in their own form."""
    pages.write(DOCS / "generated")
    app.connect("autodoc-process-docstring", explain_arguments)


def explain_arguments(app, what, name, documented, options, lines):
    """Turn the arguments and attributes that a docstring explains, or a comment beside them, into fields."""
    names = inspect.signature(documented).parameters if what in ("function", "method", "class") else ()
    told = house_docstrings.with_fields("\n".join(lines), names, "ivar" if what == "class" else "param")
    beside = house_docstrings.comments(documented) if what == "class" else {}
    fields = [f":ivar {name}: {text}" for name, text in beside.items()]
    lines[:] = [*told.splitlines(), "", *fields, ""]
