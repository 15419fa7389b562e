"""The process in which FLIP runs, with a FLIP that is made up."""

import json
import sys
from types import SimpleNamespace

import numpy as np

from sss_ref.validation.report.flip_process import main


def test_each_pair_is_compared_in_numbers_from_0_to_1(tmp_path, monkeypatch, capsys):
    """The reference first; told is the mean, the second of what FLIP gives."""
    asked = []

    def evaluate(reference, test, kind):
        asked.append((reference[0, 0].tolist(), test[0, 0].tolist(), reference.dtype, kind))
        return "a map", np.float32(0.25 * len(asked)), {}

    monkeypatch.setitem(sys.modules, "flip_evaluator", SimpleNamespace(evaluate=evaluate))
    pictures = {
        f"{side}_{name}": np.full((2, 3, 3), value, np.uint8)
        for name, values in {"image": (0, 255), "1_lit": (51, 102)}.items()
        for side, value in zip("01", values, strict=True)
    }
    np.savez(tmp_path / "pictures.npz", **pictures)
    main(str(tmp_path / "pictures.npz"))
    assert json.loads(capsys.readouterr().out) == {"image": 0.25, "1_lit": 0.5}
    fifth, two_fifths = (float(np.float32(code) / np.float32(255)) for code in (51, 102))
    assert asked == [
        ([0.0] * 3, [1.0] * 3, np.float32, "LDR"),
        ([fifth] * 3, [two_fifths] * 3, np.float32, "LDR"),
    ]
