"""What `sss-ref validate` prints of a report that is made up; verdicts have tests of their own."""

from types import SimpleNamespace

from sss_ref.cli.verdicts import print_report
from sss_ref.explanation.rows import Row, Section


def verdict(buffer, **changes):
    about = {"pass_name": "camera", "stage": "phong", "buffer": buffer, "compared": 200, "equal": 150, "chained": 10}
    counts = {"outcomes": (150, 0, 50, 0, 0), "estimated": (False,) * 5, "widths": SimpleNamespace(most=3.0)}
    looks = {"inherits": False, "failed": True, "empty": False, "background": None}
    return SimpleNamespace(**{**about, **counts, **looks, **changes})


def report(**changes):
    whole = {"profile": "vulkan", "device": None, "verdicts": [verdict("lit")], "finding": None, "sensitivity": []}
    rest = {"likeness": (), "missing": (), "seconds": {"reading": 0.04, "judging": 12.0}}
    said = {"summary": "fail: [stage] phong", "details": ["first [1,2]"], "explanations": ["a [sum]"]}
    return SimpleNamespace(**{**whole, **rest, **said, **changes})


def printed(capsys, **changes):
    print_report(report(**changes))
    return [line.rstrip() for line in capsys.readouterr().out.splitlines()]


HEAD = "  pass     stage   buffer   pixels   same bits   certain   ambiguous   fail   undefined   unbounded   outside"
TABLE = [
    "each stage, given what was drawn before it",
    "",
    f"{HEAD}   chained   width",
    f" {'─' * 127}",
    "  camera   phong   lit         200      75.00%       150           -     50           -           -         -"
    "     5.00%       3",
    "",
    "width: of the interval in which a value is right, in ulp; of 95 % of the values at most so much",
]
LAST = ["time: reading 0.0 s, judging 12.0 s", "fail: [stage] phong", "  first [1,2]", "  a [sum]"]


def test_a_report_is_a_table_and_the_outcome_last(capsys):
    assert printed(capsys) == ["profile vulkan, device not given", *TABLE, *LAST]


def test_no_name_is_cut(capsys):
    """Of the longest pass, stage and buffer there are, beside counts of 8192^2 pixels."""
    buffer, longest = "inner_inside_stored_distance", ["inner_shadow_map", "phong_shading_directional_orthographic"]
    named = dict(zip(("pass_name", "stage"), longest, strict=True))
    counts = {"compared": 2**26, "equal": 2**26, "chained": 2**26, "outcomes": (2**26,) * 5, "estimated": (True,) * 5}
    shown = printed(capsys, verdicts=[verdict(buffer, **named, **counts)])
    assert "…" not in "".join(shown) and shown[5].split()[:4] == [*longest, buffer, "67108864"]


def test_what_else_is_known_stands_between(capsys):
    shown = printed(
        capsys, device="a [bold] device", sensitivity=["phong: [1e-3]"], likeness=[0.5, "[x]"], missing=("uv", "depth")
    )
    assert shown == [
        "profile vulkan, a [bold] device",
        *TABLE,
        "smallest relative error that this run would see:",
        "  phong: [1e-3]",
        "metrics of pictures, which decide nothing:",
        "  0.5",
        "  [x]",
        "not given: uv, depth",
        *LAST,
    ]


def test_the_worst_pixel_is_shown_line_by_line_without_what_is_inside(capsys):
    bounds = (1.0, 2.0)
    rows = [
        Row("read", 0, "normal", "(0, 0, 1)"),
        Row("line", 0, "a = b[0]", "[1]", bounds=bounds),
        Row("call", 1, "inside", "2"),
        Row("turn", 0, "round 1"),
        Row("got", 0, "drawn", "3"),
    ]
    shown = printed(capsys, finding=SimpleNamespace(section=Section(2, "phong", "", rows)))
    assert shown[len(TABLE) + 1 : -len(LAST)] == [
        "stage phong at the worst pixel",
        "",
        "             value       may be",
        f" {'─' * 31}",
        "  normal     (0, 0, 1)",
        "  a = b[0]   [1]         [1, 2]",
        "  drawn      3",
        "",
    ]
    without = printed(capsys, finding=SimpleNamespace(section=None))
    assert without == printed(capsys, finding=None)


def test_a_caption_says_what_is_estimated(capsys):
    estimated = verdict("lit", outcomes=(150, 3, 47, 0, 0), estimated=(False, True, False, False, False))
    shown = printed(capsys, verdicts=[verdict("uv"), estimated])
    assert shown[-len(LAST) - 1].endswith("at most so much; ~: estimated")
    assert "   ~3   " in shown[6] and "~" not in shown[5]
