"""The folders of validation import one way, from what may be accepted to what is said of it."""

from package_sources import circles, import_graph

ROOM = "sss_ref.validation."
ORDER = ("accept", "verdict", "cause", "witness", "report", "stage_by_stage")
ASIDE = ("clock", "profile_file", "scope")  # they need none of the others


def part_of(module):
    return module.removeprefix(ROOM).partition(".")[0]


def test_each_part_imports_from_those_before_it():
    graph = {module: needed for module, needed in import_graph().items() if module.startswith(ROOM)}
    assert {part_of(module) for module in graph} == {*ORDER, *ASIDE}
    found = {(part_of(a), part_of(b)) for a, all_needed in graph.items() for b in all_needed if b.startswith(ROOM)}
    allowed = {(a, b) for k, a in enumerate(ORDER) for b in (*ORDER[: k + 1], *ASIDE)}
    assert found <= allowed and {("cause", "verdict"), ("report", "cause")} <= found
    assert not circles({module: needed & set(graph) for module, needed in graph.items()})
