"""Answers to the exercises: the solutions, the errors that readers make, and what is no answer at all."""

import inspect
import math
import runpy
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np

from sss_ref.course import checks
from sss_ref.course.lessons import lessons
from sss_ref.language import length, vec3
from sss_ref.passes.shadow_map import LightDistance
from sss_ref.truth.chandrasekhar import half_space_reflectance

SOLUTIONS = Path(__file__).parents[2] / "solutions"


def solutions():
    """Check -> its solution."""
    found = {}
    for lesson in lessons():
        if (SOLUTIONS / lesson.path.name).exists():
            written = runpy.run_path(str(SOLUTIONS / lesson.path.name))
            found |= {getattr(checks, name): written[name] for name in lesson.exercises}
    return found


def kind_of(check):
    """line, stage, shader or port: what a check's docstring begins with."""
    return inspect.getdoc(check).partition(":")[0].removeprefix("A ")


def no_end(*given):
    raise SystemExit


def no_return(*given):
    pass


def one_by_one(*given):
    yield 1.0


def divides(*given):
    return 1 / 0


def recursive(*given):
    return recursive(*given)


NO_FUNCTIONS = [None, 3.5, "depth", (1.0, 2.0), np.zeros(3), ["x"], {"A": None}]
NO_LINES = [  # what a function may give that is no answer of any exercise
    no_return,
    no_end,
    one_by_one,
    divides,
    recursive,
    lambda: 1.0 if sys.argv else None,
    lambda a, b, c, d, e, f, g: 1.0,
    lambda *given: "0.5",
    lambda *given: (0.5, "x"),
    lambda *given: [[1.0], [1.0, 2.0]],
    lambda *given: np.zeros((2, 2, 2)),
    lambda *given: np.zeros(3, complex),
    lambda *given: np.array(["a", "b"]),
    lambda *given: np.array([None], object),
    lambda *given: 1j,
    lambda *given: math.nan,
    lambda *given: np.inf,
    lambda *given: len,
    lambda *given: {1: 2},
]


NO_PORTS = [  # what a function of the project may give, and ask for, that is no picture
    *(no_return, no_end, one_by_one, divides, recursive),
    lambda: None,
    lambda: "0.5",
    lambda: 0.5,
    lambda: (0.5, 1.0),
    lambda: [[1.0], [1.0, 2.0]],
    lambda: np.zeros((2, 2)),
    lambda: np.zeros((64, 64), complex),
    lambda: np.full((64, 64), "a"),
    lambda: np.full((64, 64, 3), np.nan),
    lambda: np.full((64, 64), np.inf),
    lambda positon_world: positon_world,
    lambda image: image,
    lambda *given: np.zeros((64, 64)),
]


class Other(NamedTuple):
    other: float


def untyped(fragment_position, light_position):
    return LightDistance(length(fragment_position - light_position))


def nothing(position_world: vec3) -> LightDistance:
    """No return."""


def a_text(position_world: vec3) -> LightDistance:
    return "position_world"


def a_tuple(position_world: vec3) -> LightDistance:
    return (length(position_world), 1.0)


def a_vector(position_world: vec3) -> LightDistance:
    return LightDistance(position_world)


def another_struct(position_world: vec3) -> Other:
    return Other(length(position_world))


def chooses(position_world: vec3) -> LightDistance:
    if length(position_world) > 1.0:
        return LightDistance(1.0)
    return LightDistance(length(position_world))


def a_float(position_world: vec3) -> float:
    return length(position_world)


def inexact(position_world: vec3) -> LightDistance:
    return LightDistance(length(position_world) * 0.1)


def unread(position_world: vec3, light_position: vec3) -> LightDistance:
    return LightDistance(length(position_world))


NO_STAGES = [
    untyped,
    nothing,
    a_text,
    a_tuple,
    a_vector,
    another_struct,
    chooses,
    a_float,
    inexact,
    unread,
    lambda x: x,
]


def no_shaders(source):
    """Texts that are no right answer where `source` is one."""
    head, body = source.strip().split("{", 1)
    result, name = head.split()[0], head.split()[1].partition("(")[0]
    wrong_type = "mat3(1.0)"
    return [
        "",
        "return 1.0;",
        source.replace(f" {name}(", " other("),
        source.replace(";", "", 1),
        source.replace("return", "give"),
        f"{head}{{ return {wrong_type}; }}",
        f"{head}{{ }}{body}",
        f"{head}{{ return {result}(0.0 / zero); }}",
        f"{head}{{ return {result}(0); }}",
        f"def {name}():\n    return 1.0",
    ]


ERRORS = {  # what readers write
    checks.distance_of_a_wall: [
        lambda depth, angle: depth * math.cos(angle),
        lambda depth, angle: depth / math.sin(angle) if angle else depth,
        lambda depth, angle: depth / math.cos(math.radians(angle)),
    ],
    checks.cover_once: [
        lambda edges, owned: all(e > 0 for e in edges),
        lambda edges, owned: all(e >= 0 and own for e, own in zip(edges, owned, strict=True)),
        lambda edges, owned: all(e > 0 for e in edges) or any(owned),
    ],
    checks.mirrored: [
        lambda normal, to_light: -to_light,
        lambda normal, to_light: to_light,
        lambda normal, to_light: normal * sum(a * b for a, b in zip(normal, to_light, strict=True)) - to_light,
    ],
    checks.colour_kept: [
        lambda weights: weights / weights.max(axis=0),
        lambda weights: weights / weights.sum(axis=1, keepdims=True),
        lambda weights: weights + (1 - weights.sum(axis=0)) / len(weights),
        lambda weights: weights.sum(axis=0),
        lambda weights: weights.astype(int),
        lambda weights: weights.astype(str),
        lambda weights: weights.tolist(),
        lambda weights: weights > 0.5,
    ],
    checks.way_inside: [
        lambda crossings: crossings[-1] - crossings[-2],
        lambda crossings: sum(crossings[2::2]) - sum(crossings[1:-1:2]),
        lambda crossings: np.diff(crossings)[::2],
    ],
    checks.texel_that_holds: [
        lambda u, width: int(u * (width - 1)),
        lambda u, width: int(u * width),
        lambda u, width: min(math.ceil(u * width), width - 1),
        lambda u, width: min(u * width, width - 1),
    ],
    checks.blur_on_the_body: [
        lambda pixels, distance, fov_y, height: pixels * distance * math.tan(math.radians(fov_y / 2)) / height,
        lambda pixels, distance, fov_y, height: pixels * 2 * distance * math.tan(fov_y / 2) / height,
        lambda pixels, distance, fov_y, height: pixels * 2 * distance * math.tan(math.radians(fov_y)) / height,
    ],
    checks.ulps_between: [
        lambda a, b: round(abs(float(a) - float(b)) / float(np.spacing(b))),
        lambda a, b: round(abs(float(a) - float(b)) / float(np.finfo(np.float32).eps)),
        lambda a, b: int(b.view(np.int32)) - int(a.view(np.int32)),
    ],
    checks.free_path: [
        lambda chance, extinction: -math.log(chance),
        lambda chance, extinction: -math.log(chance) * extinction,
        lambda chance, extinction: math.log(chance) / extinction,
        lambda chance, extinction: math.exp(-extinction * chance),
        lambda chance, extinction: -math.log2(chance) / extinction,
    ],
    checks.photons_needed: [
        lambda share, relative: share * (1 - share) / relative**2,
        lambda share, relative: (1 - share) / share / relative,
        lambda share, relative: math.sqrt((1 - share) / share) / relative,
        lambda share, relative: 0,
    ],
    checks.albedo_of: [
        lambda reflectance: 1 - ((1 - reflectance) / (1 + 2 * reflectance)) ** 2,
        half_space_reflectance,
        lambda reflectance: 1.0,
    ],
    checks.blurred_twice: [
        lambda first, second: first**2 + second**2,
        lambda first, second: max(first, second),
        lambda first, second: (first + second) / 2,
    ],
    checks.millimetres_per_offset: [
        lambda distances, weights, wanted: wanted / np.sqrt((distances**2).mean()),
        lambda distances, weights, wanted: wanted / (weights @ distances / weights.sum()),
        lambda distances, weights, wanted: wanted / np.sqrt(weights @ distances**2),
        lambda distances, weights, wanted: wanted * np.sqrt(np.average(distances**2, weights=weights)),
    ],
    checks.exponent_between: [
        lambda thin, through_thin, thick, through_thick: math.log(through_thick / through_thin, thick / thin),
        lambda thin, through_thin, thick, through_thick: math.log(through_thin / through_thick) / (thick - thin),
        lambda thin, through_thin, thick, through_thick: 0.6,
    ],
    checks.samples_for: [
        lambda error, samples, wanted: samples * (error / wanted) ** 2 - samples,
        lambda error, samples, wanted: samples * math.sqrt(error / wanted),
        lambda error, samples, wanted: 0,
    ],
    checks.error_without_noise: [
        lambda picture, truth, error: math.sqrt(((picture - truth) ** 2).mean()) / truth.mean() - error.mean(),
        lambda picture, truth, error: np.sqrt(np.maximum((picture - truth) ** 2 - error**2, 0).mean()) / truth.mean(),
        lambda picture, truth, error: np.abs(picture - truth).mean() / truth.mean(),
    ],
    checks.best_factor: [
        lambda picture, truth: (truth / picture).mean(),
        lambda picture, truth: picture @ truth / (truth @ truth),
        lambda picture, truth: math.sqrt((truth @ truth) / (picture @ picture)),
    ],
    checks.wrong_stages: [
        lambda: {"A": "shadow_lookup_nearest", "B": "phong_shading", "C": "scatter_inside"},  # the first other bits
        lambda: {"A": "translucency_ratio", "B": None, "C": "scatter_inside"},  # a consequence
        lambda: {"A": "shadow_lookup_nearest", "B": None, "C": None},  # by eye
        lambda: {"A": "shadow_lookup_nearest", "C": "scatter_inside"},
        lambda: {"A": "shadow_lokup_nearest", "B": None, "C": "scatter_inside"},  # a typo
        lambda: {"A": "the lookup", "B": None, "C": "scatter_inside"},
        lambda: {"A": ["shadow_lookup_nearest"], "B": None, "C": "scatter_inside"},
        lambda: ("shadow_lookup_nearest", None, "scatter_inside"),
        lambda: None,
        lambda: "shadow_lookup_nearest",
    ],
}


def wrong_answers(check, solution):
    """Everything that is wrong for a check."""
    kinds = {
        "line": NO_LINES,
        "port": NO_PORTS,
        "stage": NO_STAGES,
        "shader": no_shaders(solution) if isinstance(solution, str) else [],
    }
    return [*NO_FUNCTIONS, *kinds[kind_of(check)], *ERRORS.get(check, [])]
