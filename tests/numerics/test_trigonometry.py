import random

import gmpy2
import pytest

from sss_ref.numerics.trigonometry import cosine, sine, tangent


def test_quarter_turns_are_exact():
    assert [sine(d) for d in (0, 90, 180, 270, -90)] == [0, 1, 0, -1, -1]
    assert [cosine(d) for d in (0, 90, 180, 270, -90)] == [1, 0, -1, 0, 0]
    assert (sine(30), cosine(60), tangent(45)) == (0.5, 0.5, 1.0)


@pytest.mark.parametrize("ours, theirs", [(sine, gmpy2.sin), (cosine, gmpy2.cos), (tangent, gmpy2.tan)])
def test_equals_mpfr_rounded_once(ours, theirs):
    generator = random.Random(1)
    with gmpy2.context(gmpy2.get_context(), precision=300):
        for _ in range(1000):
            degrees = generator.uniform(-89.9, 89.9)
            expected = float(theirs(gmpy2.mpfr(degrees) * gmpy2.const_pi() / 180))
            assert ours(degrees).hex() == expected.hex()
