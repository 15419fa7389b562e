"""Running a stage as plain Python: values by the names of the buffers, and no warnings from NumPy."""

import warnings
from typing import NamedTuple

import numpy as np
import pytest

from sss_ref.errors import StageError
from sss_ref.language import max, select, stage, vec2, vec3


class Quotients(NamedTuple):
    quotient: float
    inverse: float


@stage(source="test")
def divided(dividend: float, divisor: float) -> Quotients:
    """A quotient and the other way round."""
    return Quotients(dividend / divisor, divisor / dividend)


def test_run_gives_each_value_the_name_of_its_buffer():
    bound = divided.bound(inverse="inverse_lit_2")
    assert bound.run([np.float32(1.0), np.float32(4.0)]) == {"quotient": 0.25, "inverse_lit_2": 4.0}


def test_run_takes_inputs_in_the_order_of_the_parameters_not_of_the_names_they_are_bound_to():
    crossed = divided.bound(dividend="divisor", divisor="dividend")
    assert crossed.run([np.float32(1.0), np.float32(4.0)])["quotient"] == 0.25


def test_run_lets_no_warning_through():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        results = divided.run([np.float32(1.0), np.float32(0.0)])
        with pytest.raises(RuntimeWarning):
            divided(np.float32(1.0), np.float32(0.0))
    assert np.isposinf(results["quotient"])


class Chosen(NamedTuple):
    chosen: float


@stage(source="test")
def larger_half(a: float, b: float, halved: bool) -> Chosen:
    """The larger of two numbers, or half of it."""
    larger = max(a, b)
    return Chosen(select(halved, larger * 0.5, 1.0))


def test_with_another_type_each_component_is_computed_as_a_number_is():
    by_channel = larger_half.retyped(a=vec3, chosen=vec3)
    assert dict(by_channel.parameters) == {"a": vec3, "b": float, "halved": bool}
    assert dict(by_channel.outputs) == {"chosen": vec3}
    a, b = np.float32([1, 3, 5]), np.float32(3)
    (together,) = by_channel(vec3(*a), b, np.True_)
    assert list(together) == [larger_half(each, b, np.True_).chosen for each in a] == [1.5, 1.5, 2.5]
    assert list(by_channel(vec3(*a), b, np.False_).chosen) == [1, 1, 1]
    assert dict(larger_half.parameters)["a"] is float  # the first is as it was


def test_another_type_keeps_the_names_it_is_bound_to():
    assert larger_half.bound(a="left").retyped(a=vec3, chosen=vec3).reads["a"] == "left"


def test_another_type_must_fit_the_source():
    with pytest.raises(StageError, match="expected vec2, got float"):
        larger_half.retyped(chosen=vec2)
    with pytest.raises(StageError, match="has no parameter or output `c` to give another type"):
        larger_half.retyped(c=vec2)


def test_a_stage_with_another_body_computes_it_as_plain_python_too():
    """A stage of the same name whose lines are another's: what is run is what every shader of it says."""

    @stage(source="test")
    def turned(dividend: float, divisor: float) -> Quotients:
        """The other way round."""
        return Quotients(divisor / dividend, dividend / divisor)

    bound = divided.bound(inverse="inverse_lit_2").with_body(turned.body)
    assert bound.name == "divided" and bound.body is turned.body
    assert bound.run([np.float32(1.0), np.float32(4.0)]) == {"quotient": 4.0, "inverse_lit_2": 0.25}
    assert divided(1.0, 4.0) == Quotients(0.25, 4.0)
