"""What becomes of each photon of a range, counted (compiled)."""

from sss_ref.cache.compiled import compiled
from sss_ref.numerics.random_numbers import restart
from sss_ref.truth.photon import walk

ORDERS = 3  # scattered never, once, more often


@compiled
def count_photons(stream, volume, setup, squared_radii, photons, counts):
    """Walk photons first ... last - 1 and add each to the counts."""
    for photon in range(photons[0], photons[1]):
        restart(stream, photon)
        fate, x, y, scatterings = walk(stream, volume, setup)
        counts[fate, min(scatterings, ORDERS - 1), ring(squared_radii, x * x + y * y)] += 1


@compiled
def ring(squared_radii, square):
    """The first ring whose outer radius is not smaller, by its square; their number for what lies beyond all."""
    first, last = 0, len(squared_radii)
    while first < last:
        middle = (first + last) // 2
        if squared_radii[middle] < square:
            first = middle + 1
        else:
            last = middle
    return first
