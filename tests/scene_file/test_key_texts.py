from typing import Literal

from sss_ref.scene_file.key_texts import key_texts
from sss_ref.scene_file.quantities import Number, Table
from sss_ref.scene_file.settings import PhongSettings
from sss_ref.scene_file.viewpoints import OrbitCamera


class Lamp(Table):
    """A table of this test."""

    watts: Number = 60.0
    """What it takes,
    in all."""
    kind: Literal["bulb"]
    colour: str = "white"
    """As a word."""


class Torch(Lamp):
    """One that inherits, says a text anew, and has a key of its own."""

    colour: str = "red"
    """As it glows."""
    battery: str
    """What is in it."""


def test_a_text_is_what_stands_below_the_key():
    assert key_texts(Lamp) == {"watts": "What it takes,\nin all.", "kind": "", "colour": "As a word."}


def test_inherited_keys_keep_their_texts_unless_they_are_said_anew():
    assert key_texts(Torch) == {**key_texts(Lamp), "colour": "As it glows.", "battery": "What is in it."}


def test_tables_of_scene_files_have_theirs():
    assert key_texts(PhongSettings)["shininess"] == "Exponent of the highlight."
    assert key_texts(OrbitCamera)["near"] == "Distance of the near plane, scene units."
    assert [*key_texts(OrbitCamera)] == [*OrbitCamera.model_fields]
