"""All that must be neutral, tried on one scene."""

from collections.abc import Collection, Iterator
from dataclasses import dataclass

from sss_ref.errors import SceneError
from sss_ref.errors.wording import nearest, told
from sss_ref.neutral.artists import Artist, ReferenceArtist
from sss_ref.neutral.relations import RELATIONS, Compared, Easel
from sss_ref.scene.scene import Scene


@dataclass(frozen=True)
class NeutralTrial:
    """What came of one change.

    name, says: which it is. compared: how many buffers were. broken: the first of them that is another, with its first
    pixel, or "". not_tried: why there was nothing to compare, or "".
    """

    name: str
    says: str
    compared: int = 0
    broken: str = ""
    not_tried: str = ""

    def __str__(self) -> str:
        """The outcome in a sentence."""
        if self.not_tried:
            return f"not tried: {self.name}: {self.not_tried}"
        return f"broken: {self.name}: {self.broken}" if self.broken else f"holds: {self.name}: {self.compared} buffers"


def neutral(scene: Scene, artist: Artist | None = None, only: Collection[str] = ()) -> Iterator[NeutralTrial]:
    """Change what must change nothing, and compare all buffers bit for bit, one change after the other.

    scene: with the user's own stages, if they are to be tried (see `with_stage`). artist: what draws; without, the
    reference. only: names of changes, of RELATIONS; without, all.
    Raises SceneError for any other name, and what the artist raises.
    """
    for wrong in (name for name in only if name not in RELATIONS):
        raise SceneError(told("neutral", f"one of {', '.join(RELATIONS)}", wrong, nearest(wrong, RELATIONS)))
    drawing = artist or ReferenceArtist()
    easel = Easel(scene, drawing, drawing.whole(scene))
    for name, relation in RELATIONS.items():
        if not only or name in only:
            yield _outcome(name, (relation.__doc__ or "").splitlines()[0], relation(easel))


def _outcome(name: str, says: str, found: Compared) -> NeutralTrial:
    if isinstance(found, str):
        return NeutralTrial(name, says, not_tried=found)
    compared = list(found)
    broken = next((str(each) for each in compared if each.differs), "")
    return NeutralTrial(name, says, len(compared), broken)
