"""One line for each problem, whatever a file has in it."""

import pytest

from sss_ref.errors.wording import cut, described, gibibytes, key_path, told, written


def test_a_problem():
    assert told("a.toml: near", "a number", '"1"', "write it without quotes") == (
        'a.toml: near: expected a number, got "1"; write it without quotes'
    )


def test_what_a_terminal_would_carry_out_is_spelt():
    """The end of a line, an escape sequence that clears the screen, a line separator, half a surrogate pair."""
    line = told("a\nb", "c", "\x1b[2J\u2028\ud800", "d")
    assert line == "a\\nb: expected c, got \\x1b[2J\\u2028\\ud800; d"


def test_letters_of_every_script_stay():
    assert told("märchen", "皮膚", "é", "d") == "märchen: expected 皮膚, got é; d"


def test_what_is_long_is_cut():
    line = told("a", "b" * 501, "c" * 401, "d")
    assert line == f"a: expected {'b' * 497}..., got {'c' * 397}...; d"
    assert told("a", "b" * 500, "c" * 400, "d") == f"a: expected {'b' * 500}, got {'c' * 400}; d"
    assert cut("a" * 60) == "a" * 60 and cut("a" * 61) == "a" * 57 + "..."


def test_a_long_key_is_cut():
    assert written(("lights", 0, "[" * 100)) == f"lights[0].{'[' * 57}..."
    assert written(()) == "scene"


@pytest.mark.parametrize(
    ("size", "text"), [(2**30, "1 GiB"), (3 * 2**29, "1.5 GiB"), (12345678901, "11.5 GiB"), (2**20, "0.000977 GiB")]
)
def test_an_amount_of_memory(size, text):
    assert gibibytes(size) == text


@pytest.mark.parametrize(
    ("location", "path"),
    [
        (("camera", "orbit", "fov_y"), ("camera", "fov_y")),
        (("lights", 2, "point", "position", 1), ("lights", 2, "position", 1)),
        (("lights", 2), ("lights", 2)),
        (("layers", 0, "translucency", "x", "float"), ("layers", 0, "translucency", "x")),
        (("blur", "kernel", "str"), ("blur", "kernel")),
        (("blur", "mask"), ("blur", "mask")),
        (("shadow_map", "width"), ("shadow_map", "width")),
    ],
)
def test_the_names_of_forms_are_no_keys(location, path):
    assert key_path(location) == path


KNOWN = ("fov_y", "eye", "up", "near")
TAGS = {"discriminator": "'type'", "expected_tags": "'orbit', 'look_at', 'free'"}
PROBLEMS = [
    (
        {"type": "extra_forbidden", "loc": ("camera", "orbit", "fovy"), "input": 3},
        "camera.fovy: expected a known key, got this one; did you mean fov_y?",
    ),
    (
        {"type": "extra_forbidden", "loc": ("camera", "orbit", "zzz"), "input": 3},
        "camera.zzz: expected a known key, got this one; remove it (known here: eye, fov_y, near, up)",
    ),
    (
        {"type": "extra_forbidden", "loc": ("lights", 0, "point", "naer"), "input": 3},
        "lights[0].naer: expected a known key, got this one; did you mean near?",
    ),
    (
        {"type": "missing", "loc": ("camera", "orbit", "distance"), "input": {"type": "orbit"}},
        "camera.distance: expected a value, got nothing; add it",
    ),
    (
        {"type": "float_type", "loc": ("lights", 0, "point", "intensity"), "input": "1"},
        'lights[0].intensity: expected a number, got "1"; write it without quotes, such as 1.5',
    ),
    (
        {"type": "too_long", "loc": ("mesh", "scale"), "input": [1, 2, 3, 4], "ctx": {"max_length": 3}},
        "mesh.scale: expected 3 values, got [1, 2, 3, 4]; remove the others",
    ),
    (
        {"type": "union_tag_invalid", "loc": ("camera",), "input": {"up": 1, "type": "orbt"}, "ctx": TAGS},
        'camera.type: expected "orbit", "look_at" or "free", got "orbt"; choose one of these',
    ),
    (
        {"type": "union_tag_invalid", "loc": ("camera",), "input": {"up": 1}, "ctx": TAGS},
        'camera: expected "orbit", "look_at" or "free", got {"up": 1}; choose one of these',
    ),
    (
        {
            "type": "union_tag_invalid",
            "loc": ("blur",),
            "input": {"type": "a", "form": "b"},
            "ctx": {**TAGS, "discriminator": "'form'"},
        },
        'blur.form: expected "orbit", "look_at" or "free", got "b"; choose one of these',
    ),
    (
        {"type": "unmet", "loc": ("mesh",), "input": 3, "ctx": {"expected": "a", "remedy": "b", "came": None}},
        "mesh: expected a, got 3; b",
    ),
    (
        {
            "type": "unmet",
            "loc": ("mesh",),
            "input": 3,
            "ctx": {"expected": "a", "remedy": "b", "came": "c", "key": ("lights", 1)},
        },
        "lights[1]: expected a, got c; b",
    ),
    (
        {"type": "never_heard_of", "loc": ("mesh",), "input": 3, "msg": "something else"},
        "mesh: expected something else, got 3; correct it",
    ),
]


@pytest.mark.parametrize(("error", "line"), PROBLEMS)
def test_what_validation_finds_is_told_under_its_key(error, line):
    path, problem = described({"msg": "pydantic's own words", **error}, KNOWN)
    assert problem == line and line.startswith(f"{written(path)}: ")
