"""The last exercise has the solution that its check expects."""

import numpy as np
import pytest

import sss_ref
from sss_ref.course.checks.lesson_9 import RIGHT, fingerprint
from sss_ref.course.dumps import three_dumps


@pytest.fixture(scope="module")
def dumped():
    return three_dumps("bust")


@pytest.mark.parametrize("name", RIGHT)
def test_validation_finds_the_stage(name, dumped):
    oracle, dumps = dumped
    culprit = sss_ref.validate(oracle, dumps[name].buffers, explain=False).culprit
    assert fingerprint(name, culprit and culprit.stage) == RIGHT[name]


@pytest.mark.parametrize("name", RIGHT)
def test_no_dump_has_the_bits_of_the_oracle(name, dumped):
    oracle, dumps = dumped
    assert not np.array_equal(dumps[name].image, oracle.image)
