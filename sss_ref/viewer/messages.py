"""What the page may say: one model for each kind of message, and one line for what is none of them."""

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from sss_ref.errors import SceneError
from sss_ref.errors.wording import told, written

MOST_TEXT = 300  # letters of a key or a name


class Message(BaseModel):
    """What all messages share."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True, allow_inf_nan=False)


Text = Annotated[str, Field(max_length=MOST_TEXT)]
Way = Annotated[float, Field(ge=-10, le=10)]
Index = Annotated[int, Field(ge=0, le=63)]


class SetKey(Message):
    """A key gets a value; null: it is left to preset and fitting again."""

    kind: Literal["set"]
    key: Text  # dotted, such as lights.0.intensity
    value: Any


class Turn(Message):
    """The camera is dragged; ways in heights of the picture."""

    kind: Literal["turn"]
    right: Way
    up: Way


class Slide(Message):
    """What is seen is dragged along with the pointer."""

    kind: Literal["slide"]
    right: Way
    up: Way


class Zoom(Message):
    """The camera goes to `factor` times its distance."""

    kind: Literal["zoom"]
    factor: Annotated[float, Field(ge=0.05, le=20)]


class Fly(Message):
    """The camera flies; ways in radii of the mesh."""

    kind: Literal["fly"]
    right: Way
    up: Way
    ahead: Way


class ChooseCamera(Message):
    """A camera of another type that shows the same."""

    kind: Literal["camera"]
    type: Literal["orbit", "look_at", "free", "orthographic"]


class FrameMesh(Message):
    """The camera that shows the whole mesh, as in a first scene."""

    kind: Literal["frame"]


class MoveLight(Message):
    """A light is dragged around its target, or farther from it."""

    kind: Literal["move_light"]
    light: Index
    right: Way
    up: Way
    behind: bool
    factor: Annotated[float, Field(ge=0.05, le=20)] = 1.0


class Show(Message):
    """Which buffer is seen."""

    kind: Literal["show"]
    buffer: Text


class Explain(Message):
    """What made a pixel; row 0 at the bottom."""

    kind: Literal["explain"]
    column: int
    row: int


class SaveFile(Message):
    """A file to keep is asked for."""

    kind: Literal["save"]
    what: Literal["scene", "picture", "bundle"]


class Upload(Message):
    """A file is dropped; its bytes follow. adopt: whether a first scene for it is wanted."""

    kind: Literal["upload"]
    name: Text
    size: int
    adopt: bool


class Restore(Message):
    """The scene that a page had before the connection broke."""

    kind: Literal["restore"]
    data: dict[str, Any]


class GoBack(Message):
    """The last scene without mistakes is wanted again."""

    kind: Literal["back"]


class Drawn(Message):
    """A picture has arrived; the next may come."""

    kind: Literal["drawn"]


AnyMessage = Annotated[
    SetKey
    | Turn
    | Slide
    | Zoom
    | Fly
    | ChooseCamera
    | FrameMesh
    | MoveLight
    | Show
    | Explain
    | SaveFile
    | Upload
    | Restore
    | GoBack
    | Drawn,
    Field(discriminator="kind"),
]
READER: TypeAdapter[Any] = TypeAdapter(AnyMessage)


def message_of(text: str) -> Any:
    """The message in a text. Raises SceneError, in one line, for anything else."""
    try:
        return READER.validate_json(text)
    except ValidationError as error:
        where = written(tuple(part for part in error.errors()[0]["loc"]))
        raise SceneError(
            told(f"message: {where}", "what this page sends", "something else", "load the page again")
        ) from None
