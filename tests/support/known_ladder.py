"""A ladder whose numbers are given, so that nothing is traced or rendered for it."""

from types import SimpleNamespace

import numpy as np

from sss_ref.yardstick.deviation import Deviation
from sss_ref.yardstick.ladder import Ladder
from sss_ref.yardstick.rungs import Rung

SHAPE = (2, 3)
MASKS = {
    "everywhere": np.array([[True, True, True], [True, True, False]]),
    "lit": np.array([[True, True, False], [False, False, False]]),
    "dark": np.array([[False, False, False], [True, False, False]]),
}


def off(share, color=None):
    """A deviation whose numbers are all different parts of one."""
    tail = None if color is None else 2 * color
    return Deviation(5, -share, 2 * share, share, 3 * share, color, tail)


def ladder(mean, error=0.0, masks=MASKS, rungs=(), **given):
    """A ladder of a truth (H, W, 3) and its standard error; given: what would be measured, by its name."""
    mean = np.asarray(mean, float)
    of = SimpleNamespace(
        name="head <1>",
        medium="skin1",
        border="entered",
        left_out=["phong.ambient = 0.1", "phong.specular = 0.2"],
        given=SimpleNamespace(settings=SimpleNamespace(mm_per_unit=12.5)),
    )
    radiance = SimpleNamespace(mean=mean, error=np.broadcast_to(error, mean.shape), samples=64, lost=3)
    found = Ladder(of, radiance, None, tuple(rungs), given.pop("gpu", None))
    found.__dict__.update(regions=SimpleNamespace(masks=masks, length=1.256), **given)
    return found


def known(gpu=True):
    """One of two rungs, with and without what a GPU drew."""
    image = np.full((*SHAPE, 3), 0.5, np.float32)
    rungs = [Rung("burley", "shipped", {}, image, 12.4), Rung("burley", "fitted", {}, image / 2, 99.6)]
    by = {name: {region: off(share * k, 4.0) for k, region in enumerate(MASKS, 1)} for name, share in (
        ("noise", 0.01), ("gpu", 0.0), ("burley, shipped", 0.25), ("burley, fitted", 0.125))}  # fmt: skip
    mean = np.full((*SHAPE, 3), 0.25)
    return ladder(
        mean,
        rungs=rungs,
        noise=by["noise"],
        gpu=by["gpu"] if gpu else None,
        deviations={k: by[k] for k in list(by)[2:]},
    )
