"""The exercises of lesson 10: diffusion."""

import math
from typing import Any

from sss_ref.course.checks.answers import NotYet, called, near
from sss_ref.course.checks.kinds import NUMBER
from sss_ref.truth.chandrasekhar import half_space_reflectance


def free_path(answer: Any) -> None:
    """A line: the free path, in mm, that belongs to an even random number, for an extinction per mm."""
    chances, extinctions = (0.1, 0.25, 0.5, 0.9), (0.5, 1.0, 2.5)
    got = {
        (chance, extinction): called(answer, NUMBER, chance, extinction)
        for extinction in extinctions
        for chance in chances
    }
    if min(got.values()) < 0:
        raise NotYet("a path has a length of 0 or more, and yours has less.")
    going = {key: math.exp(-key[1] * path) for key, path in got.items()}
    if all(near(share, 1 - chance) for (chance, _), share in going.items()):
        return
    if all(near(share, chance) for (chance, _), share in going.items()):
        return
    raise NotYet(
        f"in a material with 1 per mm your even number 0.25 is a path of {got[0.25, 1.0]:.3f} mm and 0.5 one of "
        f"{got[0.5, 1.0]:.3f} mm; after these lengths {going[0.25, 1.0]:.0%} and {going[0.5, 1.0]:.0%} of all photons "
        "still go straight. Which share should that be, if a quarter and a half of your numbers are smaller?"
    )


def photons_needed(answer: Any) -> None:
    """A line: the number of photons for which a share is known to a relative standard error."""
    for share, relative in [(0.5, 0.01), (0.5, 0.1), (0.9, 0.01), (0.01, 0.1)]:
        expected = (1 - share) / share / relative**2
        got = called(answer, NUMBER, share, relative)
        if abs(got - expected) > 1 + 1e-5 * expected:  # rounded up to a whole photon, or not
            error = math.sqrt(share * (1 - share) / got) if got > 0 else math.inf
            raise NotYet(
                f"with {got:.6g} photons a share of {share:g} has the standard error {error:.3g}, "
                f"{error / share:.2%} of it and not {relative:.0%}. Is a rare thing as soon counted as a common one?"
            )


def albedo_of(answer: Any) -> None:
    """A line: the albedo of the half-space without border that gives back a share of the light, to a thousandth."""
    for reflectance in (0.1, 0.3, 0.6, 0.85, 0.95):
        got = called(answer, NUMBER, reflectance)
        if not 0 <= got < 1:
            raise NotYet(f"an albedo is at least 0 and less than 1, and for {reflectance:g} yours is {got:g}.")
        back = half_space_reflectance(got)
        if abs(back - reflectance) > 1e-3:
            raise NotYet(
                f"a half-space of your albedo {got:.4f} gives back {back:.4f}, not {reflectance:g}. The curve always "
                "rises: what do you know of the albedo you look for, once you have tried one?"
            )
