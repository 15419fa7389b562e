"""The reflectance of a half-space that scatters isotropically and has no border: exact, so that walks can be checked.

Chandrasekhar, "Radiative Transfer" (1950): with the albedo a, light that comes in at the cosine m to the normal leaves
again with the share 1 - H(m) * sqrt(1 - a), where H(m) * (sqrt(1 - a) + a/2 * integral of n * H(n)/(m + n) dn) = 1.
"""

import math

import numpy as np

NODES = 64  # of Gauss and Legendre on 0 to 1
ITERATIONS = 10_000
ENOUGH = 1e-14


def half_space_reflectance(albedo: float, cosine: float = 1.0) -> float:
    """The share of light that leaves again; albedo from 0 to below 1, cosine above 0."""
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    nodes, weights = (nodes + 1) / 2, weights / 2
    kept = math.sqrt(1 - albedo)
    h, change = np.ones(NODES), math.inf
    for _ in range(ITERATIONS):
        if change < ENOUGH:
            break
        new = 1 / (kept + albedo / 2 * (weights * nodes * h / (nodes[:, np.newaxis] + nodes)).sum(axis=1))
        change = float(np.abs(new - h).max())
        h = (new + h) / 2  # the mean converges fast, which the new one alone does not near albedo 1
    at = 1 / (kept + albedo / 2 * float((weights * nodes * h / (cosine + nodes)).sum()))
    return 1 - at * kept


def diffuse_half_space_reflectance(albedo: float) -> float:
    """The same for light from all sides (cosine): 2 * integral of m * R(m) dm."""
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    cosines = (nodes + 1) / 2
    return sum(
        float(weight * cosine) * half_space_reflectance(albedo, float(cosine))
        for cosine, weight in zip(cosines, weights, strict=True)
    )
