"""Every benchmark has a record in benchmarks/results, and every record says of which machine its numbers are."""

import re
import subprocess
import sys
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[1] / "benchmarks"
BENCHMARKS = {path.name for path in FOLDER.glob("*.py")} - {"record.py"}
RECORDS = sorted((FOLDER / "results").glob("*.txt"))
MACHINE = re.compile(
    r"\S.*, \d+ cores, \d+ GiB, \S+ \S+, Python [\d.]+, numpy [\d.]+, numba [\d.]+, "
    r"\d{4}-\d\d-\d\d, commit [0-9a-f]{12}"
)


def head_and_output(record):
    head, _, printed = record.read_text(encoding="utf-8").partition("\n\n")
    return head.splitlines(), printed


@pytest.mark.parametrize("record", RECORDS, ids=lambda path: path.stem)
def test_a_record_names_its_command_and_its_machine(record):
    (command, machine, *notes), printed = head_and_output(record)
    assert re.match(r"\$ python benchmarks/(\w+\.py)( |$)", command)[1] in BENCHMARKS
    assert MACHINE.fullmatch(machine) and len(notes) <= 1
    assert printed.strip()


def test_a_record_is_what_the_benchmark_prints(tmp_path):
    """In a folder of its own: the recorder, a benchmark of one line, and a commit to name."""
    (tmp_path / "record.py").write_text((FOLDER / "record.py").read_text())
    (tmp_path / "greet.py").write_text("import sys\nprint('hello', *sys.argv[1:])")
    identity = ["-c", "user.name=nobody", "-c", "user.email=nobody@localhost"]
    for words in (["init", "-q"], ["add", "."], [*identity, "commit", "-q", "-m", "Greet"]):
        subprocess.run(["git", *words], cwd=tmp_path, check=True)
    command = [sys.executable, "record.py", "--note", "a test", "greet.py", "--size", "3"]
    shown = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    record = tmp_path / "results" / "greet.txt"
    (command, machine, note), printed = head_and_output(record)
    assert (command, note, printed) == ("$ python benchmarks/greet.py --size 3", "a test", "hello --size 3\n")
    assert MACHINE.fullmatch(machine)
    assert record.read_text() == shown


def test_the_corpus_says_of_each_file_what_came_of_it(tmp_path):
    """A triangle that trimesh reads too, an L that it cuts as a fan beyond the L, and no mesh."""
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (tmp_path / "b.obj").write_text("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 2 0\nv 1 1 0\nv 0 1 0\nf 4 5 6 1 2 3\n")
    (tmp_path / "c.obj").write_text("v 0 0 0\n")
    command = [sys.executable, str(FOLDER / "corpus.py"), str(tmp_path)]
    printed = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    assert printed[0].split() == ["suffix", "files", "agrees", "alone", "refused", "differs", "broken"]
    assert printed[1].split() == [".obj", "3", "1", "0", "1", "1", "0"]
    assert [line.partition(".obj")[0] for line in printed[3:]] == ["trimesh has in b", "refused: c"]


def test_the_simulation_of_a_cluster_waits_where_one_would(monkeypatch):
    """Four items of a second on two cores: by themselves, handed out by one a second, stored by a slow file system."""
    monkeypatch.syspath_prepend(str(FOLDER))
    import scale

    costs = scale.Costs(items=[1.0], there=0.0, changes=3.0, written=8.0)
    free = scale.Cluster(cores=2, handing=0.0, starting=0.5, changes=1e30, bandwidth=1e30)
    alone = scale.simulated(4, costs, free)
    assert alone.until == pytest.approx(2.5) and alone.cores == pytest.approx(2 / 2.5)
    handed = scale.simulated(4, costs, replace(free, handing=1.0, starting=0.0))  # begun at 1, 2, 3 and 4
    assert handed.until == pytest.approx(5) and handed.handing == pytest.approx(4 / 5)
    stored = scale.simulated(4, costs, replace(free, changes=3.0, bandwidth=8.0, starting=0.0))  # two seconds an item
    assert stored.until == pytest.approx(9) and stored.files == pytest.approx(8 / 9)


def test_mutants_called_equivalent_are_of_the_sources_as_they_are(monkeypatch):
    monkeypatch.syspath_prepend(str(FOLDER))
    from changed_sources import mutants

    listed = tomllib.loads((FOLDER / "equivalent_mutants.toml").read_text(encoding="utf-8"))["mutant"]
    assert listed and all(each["why"] for each in listed)
    for path in {each["path"] for each in listed}:
        found = {mutant.changed_line for mutant in mutants(Path(path))}
        assert {each["changed"] for each in listed if each["path"] == path} <= found


def test_a_mutant_knows_the_lines_that_are_executed_with_it(monkeypatch, tmp_path):
    """Those of its statement without the ones inside that; none where it is computed on import. No type is changed."""
    monkeypatch.syspath_prepend(str(FOLDER))
    import changed_sources

    source = "N: Literal[1] = 2\ndef f(a: X | Y = 3):\n    if a < (\n        4\n    ):\n        return not a\n"
    (tmp_path / "a.py").write_text(source, encoding="utf-8")
    monkeypatch.setattr(changed_sources, "PACKAGE", tmp_path)
    found = {each.changed_line: [*each.executed] for each in changed_sources.mutants(Path("a.py"))}
    assert found == {
        "N: Literal[1] = (3)": [],
        "def f(a: X | Y = (4)):": [],
        "if (a <= 4):": [3, 4, 5],
        "(5)": [3, 4, 5],
        "return (a)": [6],
    }


def test_what_changes_no_value_is_no_place(monkeypatch, tmp_path):
    """A union that has a name is a type, but in a function a value; a row's number tells LLVM alone which it is."""
    monkeypatch.syspath_prepend(str(FOLDER))
    import changed_sources

    source = "T = X | Y\nD = E | {}\ndef f(a):\n    b = a | 3\n    write_int(4, a, 5)\n    zip(a, strict=True)\n"
    (tmp_path / "a.py").write_text(source, encoding="utf-8")
    monkeypatch.setattr(changed_sources, "PACKAGE", tmp_path)
    found = [each.changed_line for each in changed_sources.mutants(Path("a.py"))]
    assert found == ["D = (E & {})", "b = (a & 3)", "b = a | (4)", "write_int(4, a, (6))"]
