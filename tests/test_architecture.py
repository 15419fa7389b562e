"""What the texts for developers name is there, and the picture of the rooms shows them all."""

import re
import sys
from pathlib import Path

import pytest
from package_sources import PACKAGE, import_graph

ROOT = Path(__file__).parents[1]
NAMES = ("docs/architecture.md", "CONTRIBUTING.md", "README.md")
PAGES = {name: (ROOT / name).read_text(encoding="utf-8") for name in NAMES}
BACK_DOORS = {("rendering", "results")}  # Result.save
WRITTEN = {"dist/", "out/manifest.json"}  # by a command of the page
THINGS = ["a stage", "a dump format", "a hypothesis", "a dialect", "a method"]

sys.path.insert(0, str(ROOT / "docs" / "generate"))

import rooms  # noqa: E402


def named_paths(text):
    """What stands between backticks and is spelled like a file or a folder of the repository or of the package."""
    return re.findall(r"`((?:\w+/)+[\w.]*|\w+\.(?:py|md|toml))`", re.sub(r"```.*?```", "", text, flags=re.DOTALL))


def is_there(path):
    return any((folder / path).exists() for folder in (ROOT, PACKAGE)) or path in WRITTEN


@pytest.mark.parametrize("name", NAMES[:2])
def test_every_file_and_folder_that_a_page_names_is_there(name):
    paths = named_paths(PAGES[name])
    assert len(paths) >= 5
    assert not [path for path in paths if not is_there(path)]


def test_the_house_has_every_room_once():
    found = [room for _, storey in rooms.floors() for room in storey]
    assert sorted(found) == sorted({path.name.removesuffix(".py") for path in PACKAGE.iterdir() if is_room(path)})


def is_room(path):
    return (path / "__init__.py").is_file() or (path.suffix == ".py" and path.stem != "__init__")


def test_a_floor_stands_on_those_below_it():
    floor = {room: level for level, (_, storey) in enumerate(rooms.floors()) for room in storey}
    imports = {
        (module.split(".")[1], name.split(".")[1])
        for module, needed in import_graph().items()
        for name in needed
        if "." in module and "." in name
    }
    assert {(room, above) for room, above in imports if floor[above] > floor[room]} <= BACK_DOORS


def test_each_way_leads_through_several_rooms_and_the_picture_shows_it():
    through = rooms.ways()
    assert {number for numbers in through.values() for number in numbers} == {"1", "2", "3", "4"}
    assert all(sum(number in numbers for numbers in through.values()) > 3 for number in "1234")
    picture = rooms.picture()
    assert picture.count("<circle") == sum(map(len, through.values()))
    assert all(f">{room}</text>" in picture for _, storey in rooms.floors() for room in storey)


def test_it_is_said_where_each_thing_is_added():
    heads = tuple(f"| {thing} |" for thing in THINGS)
    rows = [line for line in PAGES["docs/architecture.md"].splitlines() if line.startswith(heads)]
    assert len(rows) == len(THINGS)
    assert all(len(named_paths(cell)) >= 1 for row in rows for cell in row.split("|")[2:5])
