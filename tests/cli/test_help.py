"""The help of every command: what each option is where it is not given, for that is what a user reads and gets."""

import re

from sss_ref.cli import app

GIVEN = {
    "init": "output=scene.toml force=False",
    "render": "scene=default output=out samples=1 interpreter=kernel",
    "view": "scene=default host=127.0.0.1 port=8710 open=False",
    "batch": "output=batch interpreter=kernel",
    "turntable": "scene=default output=turntable frames=72 fps=24 interpreter=kernel",
    "verify": "interpreter=kernel",
    "diff": "",
    "explain": "scene=default depth=1 glsl=False interpreter=kernel",
    "glsl": "scene=default all=False dialect=glsl registers=False",
    "bundle": "scene=default output=bundle dialect=glsl",
    "webgl": "scene=default judge=False",
    "validate": "run-glsl=False run-wgsl=False auto=False metrics=False quick=False interpreter=kernel",
    "witness": "run-glsl=False run-wgsl=False",
    "neutral": "scene=default run-glsl=False",
    "blame": "profile=vulkan",
    "truth": "scene=default output=truth border=matched samples=64 seed=0",
    "fit": "anisotropy=0.0 lit=straight_down mm-per-unit=1.0 photons=200000",
    "course": "FOLDER=course solutions=False",
    "grade": "format=table seconds=30.0",
    "measure": "scene=default output=measure border=entered fit=True samples=256 photons=100000",
    "info": "json=False",
    "scenes": "",
    "warmup": "",
    "import": "interpreter=kernel",
    "mapping": "scene=default",
}


def told_defaults():
    """Command -> the defaults that its help tells, each as name=value."""
    page = app.generate_docs(output_format="markdown")
    return {
        each.partition("\n")[0]: " ".join(
            f"{name}={default}"
            for name, default in re.findall(r"^\* `(?:.*?--)?([\w-]+).*default: (.*)\]\*$", each, re.M)
        )
        for each in page.split("\n## sss-ref ")[1:]
    }


def test_what_is_not_given_is_told():
    assert told_defaults() == GIVEN
