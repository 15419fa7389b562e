"""Every check of the course takes the right answer and turns down the errors that readers make."""

import inspect
import math

import numpy as np
import pytest

from sss_ref.course import checks
from sss_ref.language import reflect
from sss_ref.truth.chandrasekhar import half_space_reflectance


def bisected(rising, value):
    low, high = 0.0, 1 - 1e-9
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if rising(middle) < value else (low, middle)
    return high


RIGHT = {
    checks.distance_of_a_wall: [lambda depth, angle: depth / math.cos(angle)],
    checks.cover_once: [
        lambda edges, owned: all(e > 0 or (e == 0 and own) for e, own in zip(edges, owned, strict=True)),
    ],
    checks.mirrored: [
        lambda normal, to_light: reflect(-to_light, normal),
        lambda normal, to_light: normal * (2 * sum(a * b for a, b in zip(normal, to_light, strict=True))) - to_light,
    ],
    checks.colour_kept: [lambda weights: weights / weights.sum(axis=0)],
    checks.way_inside: [
        lambda crossings: sum(out - into for into, out in zip(crossings[::2], crossings[1::2], strict=True))
    ],
    checks.texel_that_holds: [lambda u, width: min(int(u * width), width - 1)],
    checks.blur_on_the_body: [
        lambda pixels, distance, fov_y, height: pixels * 2 * distance * math.tan(math.radians(fov_y / 2)) / height,
    ],
    checks.ulps_between: [lambda a, b: abs(int(a.view(np.int32)) - int(b.view(np.int32)))],
    checks.wrong_stages: [lambda: {"A": "shadow_lookup_nearest", "B": None, "C": "scatter_inside"}],
    checks.free_path: [
        lambda chance, extinction: -math.log(chance) / extinction,
        lambda chance, extinction: -math.log1p(-chance) / extinction,
    ],
    checks.photons_needed: [
        lambda share, relative: (1 - share) / (share * relative**2),
        lambda share, relative: math.ceil((1 - share) / share / relative**2),
    ],
    checks.albedo_of: [lambda reflectance: bisected(half_space_reflectance, reflectance)],
    checks.blurred_twice: [math.hypot, lambda first, second: (first**2 + second**2) ** 0.5],
    checks.millimetres_per_offset: [
        lambda distances, weights, wanted: wanted / np.sqrt(np.average(distances**2, weights=weights)),
        lambda distances, weights, wanted: wanted * (weights.sum() / (weights @ distances**2)) ** 0.5,
    ],
    checks.exponent_between: [
        lambda thin, through_thin, thick, through_thick: -math.log(through_thick / through_thin, thick / thin),
    ],
}
WRONG = {
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
    ],
    checks.way_inside: [
        lambda crossings: crossings[-1] - crossings[-2],
        lambda crossings: sum(crossings[2::2]) - sum(crossings[1:-1:2]),
    ],
    checks.texel_that_holds: [
        lambda u, width: int(u * (width - 1)),
        lambda u, width: int(u * width),
        lambda u, width: min(math.ceil(u * width), width - 1),
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
    checks.wrong_stages: [
        lambda: {"A": "shadow_lookup_nearest", "B": "phong_shading", "C": "scatter_inside"},  # the first other bits
        lambda: {"A": "translucency_ratio", "B": None, "C": "scatter_inside"},  # a consequence
        lambda: {"A": "shadow_lookup_nearest", "B": None, "C": None},  # by eye
        lambda: {"A": "shadow_lookup_nearest", "C": "scatter_inside"},
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
}


def cases(answers):
    return [
        pytest.param(check, answer, id=f"{check.__name__}-{number}")
        for check, given in answers.items()
        for number, answer in enumerate(given)
    ]


@pytest.mark.parametrize(("check", "answer"), cases(RIGHT))
def test_right_answers_pass(check, answer, capsys):
    check(answer)
    checks.verdict(check, answer)
    assert capsys.readouterr().out == "Right.\n"


@pytest.mark.parametrize(("check", "answer"), cases(WRONG))
def test_wrong_answers_get_a_hint(check, answer, capsys):
    with pytest.raises(checks.NotYet):
        check(answer)
    checks.verdict(check, answer)
    assert capsys.readouterr().out.startswith("Not yet: ")


def test_every_check_is_tried_both_ways():
    functions = [value for value in vars(checks).values() if inspect.isfunction(value)]
    found = {one for one in functions if list(inspect.signature(one).parameters) == ["answer"]}
    assert set(RIGHT) == set(WRONG) == found
