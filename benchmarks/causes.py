"""Does `validate` name the cause? Ports with one mistake each, from the fault tables of the tests.

    python benchmarks/causes.py --size 64

For every mistake: is the first explanation the right one, is there none that fits, or is it another one?
"""

import argparse
import sys
import time
from collections import Counter
from functools import cache
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))

from planted import PLANTED, Planted, oracle_of, scene_of  # the tables are beside the tests that use them
from planted_newer import NEWER

from sss_ref.rendering.result import Result
from sss_ref.validation.report.report import Report
from sss_ref.validation.scope import SECONDS, Scope
from sss_ref.validation.stage_by_stage import validate


def main() -> None:
    """Print what was said of each, and the counts."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=64)
    parser.add_argument("--only", default="", help="mistakes with this in their name")
    parser.add_argument("--seconds", type=float, default=SECONDS, help="for the explanations of each")
    options = parser.parse_args()
    scope = Scope(seconds=options.seconds, power=False)
    counts: Counter[str] = Counter()
    for planted in (each for each in (*PLANTED, *NEWER) if options.only in each.name):
        start = time.perf_counter()
        right = oracle(planted.scene, options.size)
        report = validate(right, planted.drawn(right.scene), explain=scope)
        outcome = outcome_of(planted, report)
        counts[outcome] += 1
        print(f"{planted.name}: {outcome}, {time.perf_counter() - start:.1f} s", flush=True)
        for line in (report.summary, *report.explanations[:1]):
            print(f"    {line}")
    print(", ".join(f"{outcome} {count}" for outcome, count in counts.most_common()))


@cache
def oracle(scene: str, side: int) -> Result:
    """The right rendering of a scene, once."""
    return oracle_of(scene_of(scene, side))


def outcome_of(planted: Planted, report: Report) -> str:
    """How near the report comes to the cause."""
    if report.passed:
        return "not seen"
    if not report.explanations:
        return "stage only"
    return "cause first" if planted.is_named_by(report.explanations[0]) else "wrong cause first"


if __name__ == "__main__":
    main()
