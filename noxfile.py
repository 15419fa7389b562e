"""Where the package must work: every Python, the lowest versions it asks for, and a wheel without the checkout.

    python -m pip install nox uv
    nox --list
    nox -s wheel lowest
    nox -s tests-3.12

Needs network; a Python that is not here is skipped. What follows `--` goes to pytest.
"""

import json
from pathlib import Path

import nox

PYTHONS = ["3.11", "3.12", "3.13", "3.14"]
EVERYTHING = ("-m", "full or not full")
GOLDEN = ("-n", "0", "tests/test_golden.py")  # a test for each scene and preset
COMMANDS = (  # of README; the last one's hashes are known
    "render -o out",
    "verify out",
    "bundle figure3_with -o bundle",
    "glsl -o shaders --scene figure3_with",
    "explain teaching --pixel 512,600 --stage back_point",
    "render figure5 --preset paper -o small --size 128x128 --set shadow_map.width=128 --set shadow_map.height=128",
)

nox.options.sessions = ["wheel", "lowest", "tests"]
nox.options.default_venv_backend = "uv|virtualenv"


@nox.session(python=PYTHONS)
def tests(session: nox.Session) -> None:
    """All tests, the long ones too, with the newest versions of everything."""
    session.install(".[test,gl]")
    session.run("python", "-m", "pytest", *(session.posargs or EVERYTHING), env=alone(session))


@nox.session(venv_backend="uv")
def lowest(session: nox.Session) -> None:
    """The golden hashes with the lowest versions that pyproject.toml lets in."""
    session.install("--resolution", "lowest-direct", ".", "pytest>=8.3", "pytest-xdist>=3.6", "hypothesis>=6.120")
    session.run("uv", "pip", "list", external=True)
    session.run("python", "-m", "pytest", *(session.posargs or GOLDEN), env=alone(session))


@nox.session
def wheel(session: nox.Session) -> None:
    """The wheel alone, in a folder without the checkout, does what README says and has the checkout's hashes."""
    folder = Path(session.create_tmp()).resolve()
    session.install("build")
    session.run("python", "-m", "build", "--outdir", str(folder / "dist"))
    (built,) = (folder / "dist").glob("*.whl")
    session.install("--force-reinstall", str(built))
    golden = json.loads(Path("data/golden.json").read_text(encoding="utf-8"))["scenes"]["figure5 paper"]
    session.chdir(folder)
    for command in COMMANDS:
        session.run("sss-ref", *command.split(), env=alone(session))
    found = json.loads((folder / "small" / "manifest.json").read_text(encoding="utf-8"))
    if {each["name"]: each["sha256"] for each in found["buffers"]} != golden:
        session.error("the wheel's hashes are not those of data/golden.json")


def alone(session: nox.Session) -> dict[str, str]:
    """The environment of a user who has nothing of ours: no compiled kernels, no checkout on the path."""
    return {"SSS_REF_CACHE_DIR": str(Path(session.create_tmp()).resolve() / "cache"), "PYTHONPATH": ""}
