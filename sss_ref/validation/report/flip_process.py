"""The process in which FLIP runs: on input that it does not like it ends the process it is in.

Run as `python flip_process.py PICTURES`: an .npz file of pairs 0_NAME (reference) and 1_NAME, uint8 (H, W, 3). It
prints JSON, NAME -> mean FLIP error. It is run by its path and imports nothing of the package, so it starts quickly.
"""

import json
import sys

import numpy as np


def main(pictures: str) -> None:
    """Compare every pair."""
    import flip_evaluator

    with np.load(pictures) as file:
        given = {name: file[name].astype(np.float32) / 255 for name in file.files}
    names = [name[2:] for name in given if name.startswith("0_")]
    means = {name: flip_evaluator.evaluate(given[f"0_{name}"], given[f"1_{name}"], "LDR")[1] for name in names}
    print(json.dumps({name: float(mean) for name, mean in means.items()}))


if __name__ == "__main__":
    main(*sys.argv[1:])
