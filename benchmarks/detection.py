"""Faults that a picture hardly shows: what `validate` says of them beside SSIM and FLIP of the final pictures.

    python benchmarks/detection.py                # needs scikit-image and flip-evaluator

Prints a table in Markdown. A fault is the scene rendered with one number or choice changed.
"""

import argparse

import numpy as np

import sss_ref
from sss_ref.pictures.png_file import srgb8

FAULTS = {
    "exponent .751 for .75": ("figure3_with", {"translucency.exponent": 0.751}),
    "shininess 33 for 32": ("figure3_with", {"phong.shininess": 33.0}),
    "T scaled by .0505 for .05": ("figure3_with", {"translucency.scale": 0.0505}),
    "shadow map read bilinear for nearest": ("figure3_with", {"shadow_map.filter": "bilinear"}),
    "slope bias 1.4 for 1.5": ("figure3_with", {"shadow_map.bias_slope": 1.4}),
    "lookup 0.1 % off the centre": ("figure3_with", {"shadow_map.lookup_inset": 0.999}),
    "kernel with the green of the paper's table": ("figure3_with", {"blur.kernel": "schoenberger"}),
    "taps 1 % too far out": ("figure3_with", {"blur.mm_per_offset": 1.212}),
    "ambient 3 % too bright": ("figure3_with", {"phong.ambient": 0.103}),
    "camera a thousandth of a degree off": ("figure3_with", {"camera.azimuth": 16.001}),
    "irradiance map not dilated": ("figure5", {"irradiance_map.dilate": 0}),
}


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=512)
    size = parser.parse_args().size
    small = {f"{table}.{side}": size for table in ("camera",) for side in ("width", "height")}
    print("| fault | stage named | pixels outside | first explanation | SSIM | FLIP |\n|---|---|---|---|---|---|")
    for fault, (name, overrides) in FAULTS.items():
        right = sss_ref.render(sss_ref.load_scene(name, **small))
        wrong = sss_ref.render(sss_ref.load_scene(name, **small, **overrides))
        found = sss_ref.validate(right, {name: wrong[name] for name in right.buffers})
        one = found.culprit
        named = (f"`{one.stage}`", share(one.failing, one.compared)) if one else ("none", "0 %")
        explained = found.finding.hypotheses[0].text if one and found.finding.hypotheses else "none"
        ssim, flip = compared(right.image, wrong.image)
        print(f"| {fault} | {' | '.join(named)} | {explained} | {ssim:.6f} | {flip:.5f} |", flush=True)


def share(failing: int, compared: int) -> str:
    """A share in per cent, or the pixels themselves if they are few."""
    return f"{failing / compared:.1%}" if failing >= 1e-3 * compared else f"{failing} pixels"


def compared(a: np.ndarray, b: np.ndarray) -> tuple[float, float]:
    """SSIM and mean FLIP of two pictures, as a screen shows them."""
    import flip_evaluator
    from skimage.metrics import structural_similarity

    pictures = [srgb8(image).astype(np.float32) / 255 for image in (a, b)]
    ssim = structural_similarity(*pictures, channel_axis=2, data_range=1.0)
    _, flip, _ = flip_evaluator.evaluate(*(np.ascontiguousarray(p[::-1]) for p in pictures), "LDR")
    return float(ssim), float(flip)


if __name__ == "__main__":
    main()
