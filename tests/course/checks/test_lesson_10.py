"""Lesson 10: which half-spaces an albedo is asked for, and how exactly."""

import pytest

from sss_ref.course import checks

ALBEDOS = {0.1: 0.4548662895, 0.3: 0.8149690075, 0.6: 0.9668261819, 0.85: 0.9967854175, 0.95: 0.9996858422}


def test_which_albedos_are_looked_for_and_how_exactly():
    """Of five half-spaces; one that gives back .0008 too much will do, of .0012 it will not."""
    asked = []
    checks.albedo_of(lambda reflectance: asked.append(reflectance) or ALBEDOS[reflectance])
    assert asked == [*ALBEDOS] == [0.1, 0.3, 0.6, 0.85, 0.95]
    slope = 0.3173  # of what comes back, by the albedo, at the first
    checks.albedo_of(lambda reflectance: ALBEDOS[reflectance] + 0.0008 / slope * (reflectance == 0.1))
    with pytest.raises(checks.NotYet, match=r"a half-space of your albedo 0\.4586 gives back 0\.1012, not 0\.1\."):
        checks.albedo_of(lambda reflectance: ALBEDOS[reflectance] + 0.0012 / slope)
