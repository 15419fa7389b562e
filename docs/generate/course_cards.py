"""The lessons of the course as cards: picture, title, minutes and aims, as each lesson says them of itself."""

from sss_ref.course.lessons import Lesson, lessons

GRID = """::::::{{grid}} 1 2 2 3
:gutter: 3
:class-container: lessons

{cards}
::::::
"""
CARD = """:::::{{grid-item-card}} {title}
:link: /generated/course/{name}
:link-type: doc
:img-top: /images/course/{name}.jpg
:img-alt: {title}

{aims}
+++
{minutes} minutes
:::::"""


def page() -> str:
    """The Markdown that the course's page includes."""
    return GRID.format(cards="\n".join(map(card, lessons())))


def card(lesson: Lesson) -> str:
    """One lesson's card."""
    plan = lesson.plan
    return CARD.format(title=lesson.title, name=lesson.name, aims=plan["aims"], minutes=plan["minutes"])
