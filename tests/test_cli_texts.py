"""What the command line prints of what it is given, by its parts: nothing is rendered."""

import os
import subprocess
import sys
from types import SimpleNamespace

import pytest

from sss_ref import cli
from sss_ref.cli import batch_commands, explaining, verdicts
from sss_ref.errors import SceneError
from sss_ref.explanation.rows import Row


@pytest.mark.parametrize(
    ("raised", "told"),
    [
        (MemoryError("of NumPy"), "memory: expected enough for what was asked, got no more; ask for a smaller size or"),
        (OSError(28, "No space left"), "sss-ref: expected a system that goes on, got No space left; see to that"),
        (OSError(24, "Too many files", "a.npy"), "a.npy: expected a system that goes on, got Too many files; see to"),
        (
            ImportError("of Python", name="PIL"),
            "PIL: expected a library that loads, got a refusal; install it again or",
        ),
        (OSError("of a library"), "sss-ref: expected a system that goes on, got a refusal; see to that"),
        (SceneError("of [ours]"), "of [ours]"),
    ],
)
def test_what_stops_a_command_is_one_line(raised, told, monkeypatch, capsys):
    def app(*tokens, **options):
        raise raised

    monkeypatch.setattr(cli, "app", app)
    assert cli.main([]) == 2
    assert capsys.readouterr().err.startswith(f"error: {told}")


PRINTED = "import sys; from sss_ref.cli.own_process import run; sys.argv[1:] = {words}; run()"
NO_COMMAND = ["nowhere"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs a disk that is always full: /dev/full of Linux")
@pytest.mark.parametrize(
    ("words", "stream", "told"),
    [(["scenes"], "stdout", "got No space left"), (["scenes", "--help"], "stdout", ""), (NO_COMMAND, "stderr", "")],
)
def test_where_nothing_can_be_printed_a_command_is_no_verdict(words, stream, told):
    """Python itself would end with 1, which is a difference."""
    with open("/dev/full", "w") as full:
        streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | {stream: full}
        command = [sys.executable, "-c", PRINTED.format(words=words)]
        done = subprocess.run(command, **streams, text=True, check=False)
    assert done.returncode == 2
    if stream == "stdout":
        assert done.stderr.count("\n") == 1 and told in done.stderr


@pytest.mark.parametrize("words", [["scenes"], ["scenes", "--help"]])
def test_where_nobody_reads_on_a_command_is_no_verdict(words):
    begin, end = os.pipe()
    os.close(begin)
    command = [sys.executable, "-c", PRINTED.format(words=words)]
    done = subprocess.run(command, stdout=end, stderr=subprocess.PIPE, text=True, check=False)
    os.close(end)
    assert (done.returncode, done.stderr) == (141, "")  # as a shell says of a broken pipe


def test_a_name_that_the_terminal_cannot_show_is_spelt_out(tmp_path):
    command = [
        sys.executable,
        "-c",
        PRINTED.format(words=["batch", str(tmp_path / "s.toml"), "-o", str(tmp_path / "\xe9")]),
    ]
    (tmp_path / "s.toml").write_text('outputs = ["png"]\nvary.camera.width = [0]')
    environment = os.environ | {"PYTHONIOENCODING": "ascii:strict"}
    done = subprocess.run(command, capture_output=True, env=environment, text=True, check=False)
    assert done.returncode == 1 and rf"/\xe9{os.sep}items.csv" in done.stdout


def test_a_row_of_an_explanation_stands_in_columns():
    row = Row("line", 1, "a = b + c", "(1, 2)", "3f800000 40000000", "mm")
    source = "      a = b + c".ljust(76)
    assert explaining._line(row).plain == source + "(1, 2)".ljust(42) + "  " + "3f800000 40000000".ljust(28) + "mm"


@pytest.mark.parametrize(("letters", "below"), [(71, False), (72, True), (90, True)])
def test_the_value_of_a_long_line_stands_below_it(letters, below):
    """Four blanks before it, and 76 characters for both: one at least is left before a value."""
    found = explaining._line(Row("line", 0, "x" * letters, "1")).plain
    source = f"    {'x' * letters}".ljust(76)
    assert found == (f"{source}\n{' ' * 76}1" if below else f"{source}1")
    assert explaining._line(Row("turn", 0, "x" * letters)).plain == f"    {'x' * letters}"


@pytest.mark.parametrize(("kind", "style"), [("read", "dim"), ("line", ""), ("call", "dim"), ("turn", "bold")])
def test_how_a_row_looks(kind, style):
    assert explaining._line(Row(kind, 0, "x")).style == style


def test_a_pixel_is_two_whole_numbers():
    assert explaining._pixel("256,300") == (256, 300) and explaining._pixel(" 1, 2 ") == (1, 2)
    for wrong in ("20", "20,", ",20", "1;2", "-1,2", "1,2.5", "9" * 5000 + ",1"):
        with pytest.raises(SceneError, match="--pixel: expected COLUMN,ROW"):
            explaining._pixel(wrong)


def verdict(**changes):
    about = {"pass_name": "camera", "stage": "phong", "buffer": "phong", "compared": 200, "equal": 150, "chained": None}
    counts = {"outcomes": (200, 0, 3), "estimated": (False, True, True)}
    rest = {"background": SimpleNamespace(wrong=7), "widths": SimpleNamespace(most=None)}
    return SimpleNamespace(**{**about, **counts, **rest, **changes})


def test_the_cells_of_a_verdict(monkeypatch):
    monkeypatch.setattr("sss_ref.validation.verdict.widths.compact", lambda most: "w")
    shown = ["camera", "phong", "phong", "200", "75.00%", "200", "-", "~3", "7", "-", "w"]
    assert verdicts._cells(verdict()) == shown
    empty = verdict(compared=0, equal=0, chained=0, background=None, outcomes=(0, 0, 0))
    assert verdicts._cells(empty) == ["camera", "phong", "phong", "0", "-", "-", "-", "-", "-", "-", "w"]
    assert verdicts._cells(verdict(chained=1))[-2] == "0.50%"


@pytest.mark.parametrize(
    ("inherits", "failed", "empty", "style"),
    [(True, True, False, "yellow"), (False, True, True, "red"), (False, False, True, "dim"), (False,) * 3 + (None,)],
)
def test_the_colour_of_a_verdict(inherits, failed, empty, style):
    assert verdicts._style(SimpleNamespace(inherits=inherits, failed=failed, empty=empty)) == style


@pytest.mark.parametrize("rate", [1, 100])
def test_a_film_may_have_up_to_a_hundred_pictures_a_second(rate):
    batch_commands._check_film(rate, ("png",))
    for wrong in (0, 101):
        with pytest.raises(SceneError, match=f"pictures per second: expected 1 to 100, got {wrong}; 24 looks smooth"):
            batch_commands._check_film(wrong, ("png",))
    with pytest.raises(SceneError, match='--video: expected the output "png", got npz, exr; add it'):
        batch_commands._check_film(rate, ("npz", "exr"))


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.123456, "0.1235"),
        (3, "3"),
        ("wax", "wax"),
        ([1.0], "1"),
        ([1, 0.5], "[1, 0.5]"),
        ({"type": "orbit", "azimuth": 30.0, "distance": 4}, "[30, 4]"),
        ({"azimuth": 30.0}, "30"),
        (True, "True"),
    ],
)
def test_a_value_as_a_caption(value, text):
    assert batch_commands._short(value) == text


@pytest.mark.parametrize("count", [5, 6])
def test_of_items_that_fail_alike_five_are_told(tmp_path, capsys, count):
    failed = [SimpleNamespace(item=k, message=f"item {k}: no [light]") for k in range(count)]
    done = SimpleNamespace(
        of_state=lambda state: failed if state == "failed" else [],
        tables=(tmp_path / "items.csv", tmp_path / "items.parquet"),
        cameras=None,
    )
    assert batch_commands._told(done) == 1
    printed = capsys.readouterr()
    assert printed.err == f"failed: item 0, 1, 2, 3, 4{' and 1 more' if count == 6 else ''}: no [light]\n"
    assert printed.out == f"0 rendered, 0 were there, {count} failed: {tmp_path / 'items.csv'}\n"
