"""The exercises of lesson 5: thickness and translucency."""

from collections.abc import Callable, Sequence

from sss_ref.course.checks.answers import NotYet, near


def way_inside(answer: Callable[[Sequence[float]], float]) -> None:
    """05: how far a ray runs inside bodies, from the distances at which it enters and leaves them in turn."""
    for crossings in ([1.0, 3.0], [1.0, 1.5, 4.0, 4.25], [0.5, 1.0, 2.0, 4.0, 4.5, 4.75]):
        expected = sum(crossings[1::2]) - sum(crossings[::2])
        got = answer(crossings)
        if not near(got, expected):
            raise NotYet(
                f"a ray that crosses surfaces at {crossings} runs {expected:g} inside, and yours {got:g}. "
                "Which of the stretches between two crossings are body, and which are air?"
            )
