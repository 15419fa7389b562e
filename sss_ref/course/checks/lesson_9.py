"""The exercises of lesson 9: validate your shader."""

from collections.abc import Callable

from sss_ref.course.checks.answers import NotYet
from sss_ref.course.dumps import WRONG_STAGE


def wrong_stages(answer: Callable[[], dict[str, str | None]]) -> None:
    """09: the stage that is wrong in each of the dumps A, B and C; None for the one that is right."""
    got = answer()
    for name, expected in WRONG_STAGE.items():
        if name not in got:
            raise NotYet(f"nothing is said of {name}.")
        if got[name] == expected:
            continue
        if expected is None:
            raise NotYet(f"{name} has other bits than the oracle. Could a right processor have them?")
        if got[name] is None:
            raise NotYet(f"{name} looks right. Give `sss_ref.validate` its buffers.")
        raise NotYet(f"{got[name]} is not what is wrong in {name}: did it make a mistake, or was it given one?")
