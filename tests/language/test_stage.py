"""Running a stage as plain Python: values by the names of the buffers, and no warnings from NumPy."""

import warnings
from typing import NamedTuple

import numpy as np
import pytest

from sss_ref.language import stage


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
