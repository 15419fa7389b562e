"""The picture of the rooms: floors of a house, and in each room the numbers of the ways that go through it."""

import re
from pathlib import Path

PAGE = Path(__file__).parents[1] / "architecture.md"
WIDTH, FLOOR, MARGIN, LABEL, GAP = 360, 44, 12, 66, 6
ROOF = 40
COLOURS = {"1": "#8a4b08", "2": "#b8860b", "3": "#1f6f8b", "4": "#7a3b69"}
STYLE = (
    "text{font-family:system-ui,sans-serif;font-size:10.5px;fill:#5a5148}"
    ".room{font-family:ui-monospace,Menlo,monospace;font-size:10.5px;font-weight:600;fill:#2b2622}"
    ".way{font-size:8.5px;font-weight:700;fill:#fff}"
)


def floors() -> list[tuple[str, list[str]]]:
    """The floors from the ground up, each with its rooms, as the page's first table has them."""
    found: list[tuple[str, list[str]]] = []
    for floor, rooms in re.findall(
        r"^\| ([a-z]*) ?\| (`[a-z_]+[/.].*?) \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE
    ):
        names = [name.removesuffix(".py") for name in re.findall(r"`([a-z_]+(?:\.py)?)/?`", rooms)]
        if floor:
            found.append((floor, names))
        else:
            found[-1][1].extend(names)
    return found


def ways() -> dict[str, list[str]]:
    """Room -> the numbers of the ways through it: those whose section names a file of the room."""
    found: dict[str, list[str]] = {}
    for number, text in re.findall(
        r"^## (\d)\. (.*?)(?=^## )", PAGE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    ):
        for room in dict.fromkeys(re.findall(r"`([a-z_]+)/[\w/.]*`", text)):
            found.setdefault(room, []).append(number)
    return found


def picture() -> str:
    """The house as SVG, as wide as a phone; it is drawn larger where there is room."""
    storeys, through = floors(), ways()
    height = ROOF + FLOOR * len(storeys) + 2 * MARGIN
    eaves = ROOF + MARGIN - 4
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" role="img">',
        f"<style>{STYLE}</style>",
        f'<rect width="{WIDTH}" height="{height}" rx="8" fill="#f7f2ea"/>',
        f'<path d="M{MARGIN} {eaves} L{WIDTH / 2} {MARGIN} L{WIDTH - MARGIN} {eaves} Z" fill="#b5654a"/>',
    ]
    for level, (floor, rooms) in enumerate(reversed(storeys)):
        parts += storey(floor, rooms, MARGIN + ROOF + level * FLOOR, through)
    return "\n".join([*parts, "</svg>\n"])


def storey(floor: str, rooms: list[str], top: float, through: dict[str, list[str]]) -> list[str]:
    """One floor: its name, and its rooms side by side."""
    middle = top + FLOOR / 2
    parts = [f'<text x="{MARGIN}" y="{middle + 3}">{floor}</text>']
    left, wide = MARGIN + LABEL, (WIDTH - 2 * MARGIN - LABEL - GAP * (len(rooms) - 1)) / len(rooms)
    for number, room in enumerate(rooms):
        parts += chamber(room, left + number * (wide + GAP), top + GAP / 2, wide, through.get(room, []))
    return parts


def chamber(room: str, x: float, y: float, wide: float, numbers: list[str]) -> list[str]:
    """One room: its name, and below it the ways through it."""
    centre, high = x + wide / 2, FLOOR - GAP
    parts = [
        f'<rect x="{x:.1f}" y="{y:.1f}" width="{wide:.1f}" height="{high}" rx="3" fill="#fffdf9" stroke="#c9bba8"/>',
        f'<text class="room" x="{centre:.1f}" y="{y + (15 if numbers else 22):.1f}" text-anchor="middle">{room}</text>',
    ]
    for k, number in enumerate(numbers):
        at = centre + (k - (len(numbers) - 1) / 2) * 15
        parts += [
            f'<circle cx="{at:.1f}" cy="{y + 27:.1f}" r="6" fill="{COLOURS[number]}"/>',
            f'<text class="way" x="{at:.1f}" y="{y + 30:.1f}" text-anchor="middle">{number}</text>',
        ]
    return parts
