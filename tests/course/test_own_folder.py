"""A student's folder gets the lessons, keeps what the student changed, and says what is new."""

import json
import sys

import pytest

from sss_ref.cli import main
from sss_ref.course import own_folder
from sss_ref.course.lessons import lessons
from sss_ref.course.own_folder import KEPT, NEW, RENEWED, SAME, START, LaidOut, write_course
from sss_ref.errors import CourseError

LESSON = "03_phong.ipynb"

pytest.importorskip("jupytext", reason="pip install 'sss_ref[course]'")


@pytest.fixture
def folder(tmp_path):
    write_course(tmp_path / "own")
    return tmp_path / "own"


@pytest.fixture
def newer(monkeypatch):
    """A release whose third lesson says something else."""
    text = own_folder.notebook
    changed = lambda script: text(script.replace("# # 3. Phong", "# # 3. Bui Tuong Phong"))  # noqa: E731
    monkeypatch.setattr(own_folder, "notebook", changed)


def outcome(folder, name=LESSON):
    (found,) = (each for each in write_course(folder) if each.name == name)
    return found


def test_every_lesson_and_a_start_page_that_links_them_all(folder):
    names = [f"{lesson.name}.ipynb" for lesson in lessons()]
    assert sorted(path.name for path in folder.glob("*")) == sorted([*names, START, own_folder.RECORD])
    start = (folder / START).read_text(encoding="utf-8")
    assert all(f"({name})" in start for name in names)


def test_a_lesson_is_a_notebook_without_outputs(folder):
    book = json.loads((folder / LESSON).read_text(encoding="utf-8"))
    assert (book["nbformat"], book["metadata"]["kernelspec"]["name"]) == (4, "python3")
    assert {cell["cell_type"] for cell in book["cells"]} == {"code", "markdown"}
    assert not any(cell.get("outputs") for cell in book["cells"])


def test_no_file_holds_a_solution(folder):
    texts = "".join(path.read_text(encoding="utf-8") for path in folder.rglob("*") if path.is_file())
    assert "scatter_inside" not in texts and not (folder / "solutions").exists()


def test_a_second_call_changes_nothing(folder):
    before = {path: path.stat().st_mtime_ns for path in folder.iterdir() if path.name != own_folder.RECORD}
    assert {each.outcome for each in write_course(folder)} == {SAME}
    assert before == {path: path.stat().st_mtime_ns for path in before}


def test_what_the_student_wrote_is_kept(folder):
    (folder / LESSON).write_text("answers")
    assert outcome(folder) == LaidOut(LESSON, KEPT)
    assert (folder / LESSON).read_text() == "answers"


def test_a_new_version_of_an_untouched_lesson_takes_its_place(folder, newer):
    assert outcome(folder) == LaidOut(LESSON, RENEWED)
    assert "Bui Tuong Phong" in (folder / LESSON).read_text(encoding="utf-8")


def test_a_new_version_of_an_edited_lesson_goes_beside_it_once(folder, newer):
    (folder / LESSON).write_text("answers")
    assert outcome(folder) == LaidOut(LESSON, KEPT, "03_phong.new.ipynb")
    assert (folder / LESSON).read_text() == "answers"
    assert "Bui Tuong Phong" in (folder / "03_phong.new.ipynb").read_text(encoding="utf-8")
    assert outcome(folder) == LaidOut(LESSON, KEPT)


def test_a_lesson_that_was_deleted_comes_back(folder):
    (folder / LESSON).unlink()
    assert outcome(folder) == LaidOut(LESSON, NEW)


def test_a_folder_with_something_else_is_refused(tmp_path):
    (tmp_path / "thesis.txt").write_text("")
    with pytest.raises(CourseError, match="expected a new or empty folder, or the course's own, got one with other"):
        write_course(tmp_path)
    with pytest.raises(CourseError, match="got a file; choose another"):
        write_course(tmp_path / "thesis.txt")
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.txt"]


@pytest.mark.parametrize("text", ["{", "[]", "[" * 100_000], ids=len)
def test_a_broken_record_is_told(folder, text):
    (folder / own_folder.RECORD).write_text(text)
    with pytest.raises(CourseError, match="expected the course's record, got another text; delete the file"):
        write_course(folder)


def test_without_the_extra_it_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "jupytext", None)
    with pytest.raises(CourseError, match=r"run python -m pip install 'sss_ref\[course\]'"):
        write_course(tmp_path / "own")
    assert not (tmp_path / "own").exists()


def test_the_command_says_what_became_of_each_file(tmp_path, capsys):
    assert main(["course", str(tmp_path / "own")]) == 0
    assert f"{LESSON}: new\n" in capsys.readouterr().out
    (tmp_path / "own" / LESSON).write_text("answers")
    assert main(["course", str(tmp_path / "own")]) == 0
    assert f"{LESSON}: yours, kept\n" in capsys.readouterr().out


def test_solutions_come_into_a_folder_of_their_own(tmp_path):
    """In a folder that may be deep, with a record for people to read."""
    folder = tmp_path / "course" / "own"
    names = [each.name for each in write_course(folder, solutions=True)]
    shipped = sorted(path.name for path in own_folder.shipped_folder("solutions").glob("*.py"))
    assert shipped and [name for name in names if "/" in name] == [f"solutions/{name}" for name in shipped]
    assert sorted(path.name for path in (folder / "solutions").iterdir()) == shipped
    text = (folder / own_folder.RECORD).read_text(encoding="utf-8")
    assert text.startswith('{\n "START.ipynb": "') and text.endswith("\n}\n")
