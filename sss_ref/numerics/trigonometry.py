"""Sines, cosines and tangents whose bits do not depend on the machine: 50 digits, rounded once (rule A4)."""

from functools import cache, lru_cache
from typing import Any

RECENT = 256  # angles whose result is remembered: scenes of a batch have the same lenses


@cache
def fifty_digits() -> Any:
    """The functions of mpmath at 50 digits, in a context of their own: nobody else's precision changes."""
    from mpmath import MPContext

    context = MPContext()
    context.dps = 50
    return context


@lru_cache(RECENT)
def sine(degrees: float) -> float:
    """Sine of an angle in degrees, correctly rounded; exact at the multiples of 90."""
    mp = fifty_digits()
    return float(mp.sinpi(mp.mpf(degrees) / 180))


@lru_cache(RECENT)
def cosine(degrees: float) -> float:
    """Cosine of an angle in degrees, correctly rounded; exact at the multiples of 90."""
    mp = fifty_digits()
    return float(mp.cospi(mp.mpf(degrees) / 180))


@lru_cache(RECENT)
def tangent(degrees: float) -> float:
    """Tangent of an angle in degrees, -90 < degrees < 90, correctly rounded."""
    mp = fifty_digits()
    angle = mp.mpf(degrees) / 180
    return float(mp.sinpi(angle) / mp.cospi(angle))
