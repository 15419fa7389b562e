"""What is drawn on a sheet of pictures, call by call: where each word, line and picture goes, whatever Pillow it is."""

from collections.abc import Callable
from typing import Any

import pytest
from PIL import Image, ImageDraw

Note = tuple[Any, ...]


def noted(monkeypatch: pytest.MonkeyPatch) -> list[Note]:
    """Notes of everything drawn from now on. Words are not drawn; each letter is half as wide as its size."""
    notes: list[Note] = []

    def text(draw: Any, place: Any, words: str, ink: Any, font: Any) -> None:
        notes.append(("text", tuple(place), words, ink, font.size))

    def circle(draw: Any, place: Any, radius: int, outline: Any, width: int) -> None:
        notes.append(("circle", tuple(place), radius, outline, width))

    monkeypatch.setattr(ImageDraw.ImageDraw, "text", text)
    monkeypatch.setattr(ImageDraw.ImageDraw, "textlength", lambda draw, words, font: len(words) * font.size / 2)
    monkeypatch.setattr(ImageDraw.ImageDraw, "circle", circle)
    _also(monkeypatch, ImageDraw.ImageDraw, "rectangle", lambda draw, box, *ink: notes.append(("box", box, *ink)))
    _also(monkeypatch, Image.Image, "paste", lambda sheet, shown, at, *mask: notes.append(("paste", at, shown.size)))
    return notes


def _also(monkeypatch: pytest.MonkeyPatch, kind: type, name: str, note: Callable[..., None]) -> None:
    original = getattr(kind, name)

    def both(*arguments: Any) -> Any:
        if name == "rectangle" or isinstance(arguments[1], Image.Image):
            note(*arguments)
        return original(*arguments)

    monkeypatch.setattr(kind, name, both)
