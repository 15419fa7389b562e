"""Built-ins that are called: component by component, or with whole vectors."""

import numpy as np

from sss_ref.language.intrinsics import by_component, pow, size, texel, whole
from sss_ref.language.types import vec3


def test_one_takes_components_and_the_other_whole_vectors():
    taken = []

    def seen(*arguments):
        taken.append(arguments)
        return np.float32(len(taken))

    v, w = vec3(*map(np.float32, (1, 2, 3))), vec3(*map(np.float32, (4, 5, 6)))
    assert whole(seen)(v, w) == 1 and taken == [(v, w)]
    taken.clear()
    assert list(by_component(seen)(v, 0.5)) == [1, 2, 3]
    assert taken == [(1, 0.5), (2, 0.5), (3, 0.5)] and all(type(each[1]) is np.float32 for each in taken)


def test_a_texture_is_taken_whole():
    texture = np.arange(24, dtype=np.float32).reshape(2, 4, 3)
    assert (texel.by_component, size.by_component, pow.by_component) == (False, False, True)
    assert list(size(texture)) == [4, 2]
