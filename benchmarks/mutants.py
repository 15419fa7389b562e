"""How many mistakes does `validate` find? Every mutant of every stage of some scenes, drawn on OpenGL and judged.

    python benchmarks/mutants.py figure3_with figure5 figure4_wax --size 96

A mutant is a stage with one place changed (sss_ref.validation.cause.mutants). Registers are drawn too, so that each
stage gives something that can be judged. Printed are the survivors, and how many were found at the right stage,
elsewhere, or not at all; mutants that draw the same bits as the right stage count apart.
"""

import argparse
import time
from collections import Counter
from dataclasses import replace

import sss_ref
from sss_ref.errors import ShaderError
from sss_ref.gl import draw
from sss_ref.language import Stage
from sss_ref.language.pipeline import REGISTERS
from sss_ref.validation.cause.mutants import mutants

KEPT = ("all", REGISTERS)


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", default=["figure3_with", "figure5"])
    parser.add_argument("--size", type=int, default=96)
    parser.add_argument("--every", type=int, default=1, help="only every n-th mutant")
    parser.add_argument("--profile", default="vulkan")
    parser.add_argument("--set", nargs="*", default=[], metavar="KEY=TEXT", help="preset=published and the like")
    options = parser.parse_args()
    counts: Counter[str] = Counter()
    start = time.perf_counter()
    for name in options.scenes:
        counts += judged_scene(name, options)
    total = sum(counts.values())
    print(f"{total} mutants in {time.perf_counter() - start:.0f} s")
    for outcome, count in counts.most_common():
        print(f"  {outcome:32} {count:5} {count / total:7.1%}")
    different = total - counts["same bits"] - counts["refused by the compiler"]
    print(f"of the {different} that draw anything else, {counts['found at its stage'] / different:.1%} at their stage")


def judged_scene(name: str, options: argparse.Namespace) -> Counter[str]:
    """Outcome -> how many mutants of a scene had it."""
    tables = ("camera", "shadow_map", "irradiance_map")
    small = {f"{table}.{side}": options.size for table in tables for side in ("width", "height")}
    scene = sss_ref.load_scene(name, **small, **dict(each.split("=", 1) for each in options.set))
    oracle, right = sss_ref.render(scene), draw(scene, keep=KEPT)
    stages = {stage.name: unbound(stage) for one in scene.method.passes for stage in one.stages if not one.on_demand}
    counts: Counter[str] = Counter()
    for stage in stages.values():
        for number, mutant in enumerate(mutants(stage)):
            if number % options.every == 0:
                own = stage.with_body(mutant.body)
                outcome = judged(replace(scene, own_stages={stage.name: own}), oracle, right, stage.name, options)
                counts[outcome] += 1
                if outcome not in ("found at its stage", "same bits"):
                    print(f"{name}: {stage.name}: {mutant.description}: {outcome}", flush=True)
    return counts


def unbound(stage: Stage) -> Stage:
    """A stage as it was defined, so that it can be bound wherever its name stands."""
    return replace(stage, reads={own: own for own in stage.reads}, writes={own: own for own in stage.writes})


def judged(scene, oracle, right, stage: str, options: argparse.Namespace) -> str:
    """What becomes of one mutant."""
    try:
        drawn = draw(scene, keep=KEPT)
    except ShaderError:
        return "refused by the compiler"
    if all(drawn[name].tobytes() == buffer.tobytes() for name, buffer in right.items()):
        return "same bits"
    verdict = sss_ref.validate(oracle, drawn, profile=options.profile, explain=False)
    if not verdict.failed:
        return "not found"
    if verdict.culprit.stage == stage:
        return "found at its stage"
    return f"found at {verdict.culprit.stage}"


if __name__ == "__main__":
    main()
