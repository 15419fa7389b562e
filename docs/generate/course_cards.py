"""The lessons of the course as cards for students and as a plan for teachers, as each lesson says them of itself."""

from markup import table

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

*{minutes} minutes*
:::::"""


def page() -> str:
    """The Markdown that the course's page includes."""
    return GRID.format(cards="\n".join(map(card, lessons())))


def card(lesson: Lesson) -> str:
    """One lesson's card."""
    plan = lesson.plan
    return CARD.format(title=lesson.title, name=lesson.name, aims=plan["aims"], minutes=plan["minutes"])


def plan() -> str:
    """The Markdown that the teachers' page includes: a row for each lesson."""
    rows = [[f"[{each.title}](/generated/course/{each.name})", *planned(each)] for each in lessons()]
    return table(["lesson", "minutes", "aims", "before"], rows) + "\n"


def planned(lesson: Lesson) -> list[str]:
    """Minutes, aims and what it builds on."""
    return [lesson.plan[key] for key in ("minutes", "aims", "before")]
