"""Where a user works, and what language and clock the machine has, changes nothing that is written."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from saved_scene import SCENE, TETRAHEDRON

import sss_ref

SET = 'import locale; locale.setlocale(locale.LC_ALL, "")  # as programs with windows do'
WORK = f"""
{SET}
import sys
from sss_ref.cli import main
for line in sys.argv[1:]:
    if main(line.split("|")):
        sys.exit(line)
print(locale.localeconv()["decimal_point"])
"""
COMMANDS = (
    "render|small.toml|-o|result",
    "bundle|small.toml|-o|bundle",
    "glsl|-o|shaders|--scene|small.toml",
    "validate|small.toml|result|--report|report|--junit|verdicts.xml",
)
FILES = {"result/manifest.json", "bundle/uniforms.json", "shaders/camera_1.frag", "report/report.json", "verdicts.xml"}
OF_THE_RUN = ("milliseconds", "environment", "seconds")  # keys of a manifest and a report
SECONDS = re.compile(rb'time="[0-9.]+"|[0-9.]+ s</span>')
HERE = Path(sss_ref.__file__).parents[1]
ELSEWHERE = "Prüf stände (2) & 50 %"


@pytest.fixture(scope="module")
def german(tmp_path_factory):
    """Settings of a German machine on the other side of the world, its numbers with a comma."""
    folder = tmp_path_factory.mktemp("locales")
    settings = {"LOCPATH": str(folder), "LC_ALL": "de_DE.UTF-8", "TZ": "Pacific/Chatham"}
    if localedef := shutil.which("localedef"):
        subprocess.run(
            [localedef, "-i", "de_DE", "-f", "UTF-8", str(folder / "de_DE.UTF-8")], capture_output=True, check=False
        )
    if subprocess.run(
        [sys.executable, "-c", SET], env=os.environ | settings, capture_output=True, check=False
    ).returncode:
        pytest.skip("needs the sources of a German locale; install Debian's package locales")
    return settings


def test_nothing_that_is_written_changes(german, tmp_path):
    check_same(tmp_path, german, HERE)


@pytest.mark.full
def test_nor_where_the_package_lies(german, tmp_path):
    """Its kernels are compiled anew there."""
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(HERE / "sss_ref", tmp_path / ELSEWHERE / "sss_ref", ignore=ignored)
    check_same(tmp_path, german, tmp_path / ELSEWHERE)


def check_same(folder, settings, package):
    """package: the folder that has it, of the second run."""
    plain, point = written(folder / "plain", {"LC_ALL": "C.UTF-8", "TZ": "UTC"}, HERE)
    other, comma = written(folder / ELSEWHERE, settings, package)
    assert (point, comma) == (".", ",")
    assert plain.keys() >= FILES
    assert [name for name in plain.keys() | other.keys() if plain.get(name) != other.get(name)] == []


def written(folder, settings, package):
    """Every file that commands write in a folder with a scene, and the decimal point there."""
    folder.mkdir(exist_ok=True)
    (folder / "tetrahedron.obj").write_text(TETRAHEDRON)
    (folder / "small.toml").write_text(SCENE)
    done = subprocess.run(
        [sys.executable, "-c", WORK, *COMMANDS],
        env=os.environ | {"PYTHONPATH": str(package), "PYTHONDONTWRITEBYTECODE": "1"} | settings,
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    places = ("result", "bundle", "shaders", "report")
    paths = [folder / "verdicts.xml", *(path for each in places for path in (folder / each).rglob("*"))]
    files = {path.relative_to(folder).as_posix(): content_of(path, folder) for path in paths if path.is_file()}
    return files, done.stdout.split()[-1]


def content_of(path, folder):
    """What a file says besides the folder that it is in and how long a run took."""
    content = path.read_bytes().replace(bytes(folder), b"")
    if path.name in ("manifest.json", "report.json"):
        return {key: value for key, value in json.loads(content).items() if key not in OF_THE_RUN}
    return SECONDS.sub(b"", content) if path.suffix in (".html", ".xml") else content
