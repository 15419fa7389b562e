"""How near a reader's shader must come; what it gives is given here, no shader is run."""

import numpy as np
import pytest

from sss_ref.course.checks import written_shaders
from sss_ref.course.checks.answers import NotYet
from sss_ref.course.checks.written_shaders import Signature, _complaint, _vertex_shader, compared_glsl

LINE = "vec2 f(vec3 a, bool b)"


def judged(monkeypatch, expected, got, **known):
    monkeypatch.setattr(written_shaders, "run_glsl", lambda *given: np.float64(got).reshape(len(got), -1))
    compared_glsl("", "float f(float x)", {}, np.float64(expected), "Look.", **known)


@pytest.mark.parametrize(
    ("expected", "got", "within"),
    [(2.0, 2.000199, 1e-4), (2.0, 1.9981, 1e-3), (0.0, 9.9e-8, 1e-4), (-5.0, -5.00049, 1e-4)],
)
def test_a_number_within_its_part_is_right(monkeypatch, expected, got, within):
    judged(monkeypatch, [expected], [got], within=within)


@pytest.mark.parametrize(
    ("expected", "got", "within"),
    [(2.0, 2.000201, 1e-4), (2.0, 1.9979, 1e-3), (0.0, 1.1e-7, 1e-4), (-5.0, -5.00051, 1e-4)],
)
def test_a_number_farther_off_is_counted(monkeypatch, expected, got, within):
    with pytest.raises(NotYet, match=r"^`f` is wrong for 1 of 2 inputs. Look.$"):
        judged(monkeypatch, [expected, expected], [got, expected], within=within)


def test_without_a_part_it_is_a_ten_thousandth(monkeypatch):
    judged(monkeypatch, [1.0], [1.000099])
    with pytest.raises(NotYet, match="wrong for 1 of 1"):
        judged(monkeypatch, [1.0], [1.000101])


def test_an_input_with_one_wrong_component_is_wrong_once(monkeypatch):
    with pytest.raises(NotYet, match="wrong for 1 of 2"):
        judged(monkeypatch, [[1.0, 2], [1, 2]], [[1.0, 3], [1, 2]])
    with pytest.raises(NotYet, match="gives nan or infinity"):
        judged(monkeypatch, [1.0], [np.inf])


def test_the_shader_around_a_readers_function():
    """A truth travels as a number; lines are counted as the reader's."""
    found = Signature.of(LINE)
    assert (found.result, found.name, dict(found.parameters)) == ("vec2", "f", {"a": "vec3", "b": "bool"})
    assert _vertex_shader("BODY", found) == (
        "#version 400\nin vec3 given_a;\nin float given_b;\nout vec2 result;\n#line 1\nBODY\n"
        "void main() { result = vec2(f(given_a, given_b != 0.0)); }\n"
    )
    assert "out float result;" in _vertex_shader("", Signature.of("bool g(float x)"))


def test_a_compilers_complaint_has_the_readers_line():
    assert _complaint("x\n0:3(7): error: no such name\n0:9(1): error: more") == "line 3: no such name."
    assert _complaint("nothing of use").startswith("is its first line as it was")
