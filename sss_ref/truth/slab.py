"""T(d): how much of the light comes through a slab of thickness d, and how much comes back."""

from sss_ref.truth.photon import Setup, Volume
from sss_ref.truth.tally import Progress, Tally, Walk, nothing_walked


def slab(
    volume: Volume,
    thickness: float,
    photons: int,
    diffuse: bool = True,
    threads: int | None = None,
    on_progress: Progress | None = None,
) -> Tally:
    """Walk so many photons into a slab of a volume: `tally.share(TRANSMITTED)` is T, `share_error` its standard error.

    thickness: mm. diffuse: whether light enters from all sides (cosine), or straight down. Shares are of the light that
    has entered: what the border reflects at once is not in them. Raises SceneError for what is no slab.
    threads: all processors where it is None. on_progress(done, photons) is told now and then.
    """
    return nothing_walked(Walk(volume, Setup(thickness, diffuse), ())).more(photons, threads, on_progress)
