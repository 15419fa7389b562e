"""How far validating goes: which stage it judges, and what it looks for besides."""

from dataclasses import dataclass

SECONDS, FEW_SECONDS = 30.0, 1.0  # for explanations of a failure, in full and in haste


@dataclass(frozen=True)
class Scope:
    """How far validating goes.

    stage: the only one that is judged, by name, or "rasterizer"; None for all. causes: whether to look for what would
    explain a failure. seconds: after which no further explanation is begun; what was not tried is said. power: whether
    to work out how small an error would have been seen.
    """

    stage: str | None = None
    causes: bool = True
    seconds: float = SECONDS
    power: bool = True


FULL, VERDICTS_ALONE = Scope(), Scope(causes=False, power=False)
QUICK = Scope(seconds=FEW_SECONDS, power=False)
