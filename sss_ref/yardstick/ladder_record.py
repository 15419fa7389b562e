"""A ladder as JSON, whole: what was measured, of what, by what."""

from dataclasses import asdict
from typing import Any

from sss_ref.results.manifest import package_version
from sss_ref.rules import RULES_VERSION
from sss_ref.truth.truth_folder import recorded
from sss_ref.yardstick.ladder import By, Ladder
from sss_ref.yardstick.regions import SAID

FORMAT = "sss_ref measure 1"


def as_record(ladder: Ladder) -> dict[str, Any]:
    """The record; lengths in mm, errors as shares, times in ms of one processor."""
    return {
        "format": FORMAT,
        "sss_ref": package_version(),
        "rules_version": RULES_VERSION,
        "scene": ladder.of.name,
        "settings": ladder.of.given.settings.model_dump(mode="json"),
        "left_out": ladder.of.left_out,
        "medium": ladder.of.medium,
        "truth": recorded(ladder.radiance),
        "white": ladder.truth.white,
        "diffusion_length_mm": ladder.regions.length,
        "regions": {name: {"pixels": int(mask.sum()), "is": SAID[name]} for name, mask in ladder.masks.items()},
        "noise": _by(ladder.noise),
        "gpu": None if ladder.gpu is None else _by(ladder.gpu),
        "techniques": [
            {
                "method": rung.method,
                "parameters": rung.parameters,
                "keys": rung.keys,
                "milliseconds": rung.milliseconds,
                "errors": _by(ladder.deviations[rung.name]),
            }
            for rung in ladder.rungs
        ],
    }


def _by(found: By) -> dict[str, Any]:
    return {region: asdict(one) for region, one in found.items()}
