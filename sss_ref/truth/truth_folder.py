"""The folder of a traced scene: its sums, from which it goes on, and what they say so far."""

import json
from pathlib import Path

import numpy as np

from sss_ref.errors import DumpError
from sss_ref.errors.wording import told
from sss_ref.pictures.png_file import image_encoding_of, write_png
from sss_ref.truth.radiance import Radiance, nothing_gathered, read_radiance
from sss_ref.truth.tracing import Tracing

SUMS, RECORD = "sums.npz", "truth.json"


def begun(folder: Path, of: Tracing) -> Radiance:
    """What a folder has of a tracing, or no sample where there is no such folder yet.

    Raises DumpError for a folder with other files, SceneError for one with the samples of another tracing.
    """
    if (folder / SUMS).exists():
        return read_radiance(folder / SUMS, of)
    if folder.exists() and not (folder.is_dir() and not any(folder.iterdir())):
        raise DumpError(
            told(str(folder), "a new folder or one of sss-ref truth", "other files", "choose another folder")
        )
    return nothing_gathered(of)


def write_truth(folder: Path, radiance: Radiance) -> None:
    """Write what is known so far: sums, `radiance.npy`, `standard_error.npy`, a picture and a record.

    Both arrays are float32 (H, W, 3), row 0 at the bottom. Raises DumpError where nothing can be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        radiance.save(folder / SUMS)
        mean = radiance.mean.astype(np.float32)
        np.save(folder / "radiance.npy", mean)
        np.save(folder / "standard_error.npy", radiance.error.astype(np.float32))
        write_png(folder / "image.png", mean, encode=image_encoding_of(radiance.of.scene.settings))
        text = json.dumps(recorded(radiance), indent=2)
        (folder / RECORD).write_text(text + "\n", encoding="utf-8")
    except OSError as error:
        reason = error.strerror or "none"
        raise DumpError(told(str(folder), "a place to write to", reason, "choose another folder")) from None


def recorded(radiance: Radiance) -> dict[str, object]:
    """What was traced, how far, and the mean of all pixels with its standard error."""
    of = radiance.of
    pixels = radiance.mean[..., 0].size
    return {
        "format": "sss_ref truth 1",
        "scene": of.scene.source,
        "settings": of.scene.settings.model_dump(mode="json"),
        "inputs": of.scene.input_hashes(),
        "volumes_per_mm": [volume._asdict() for volume in of.volumes],
        "border": of.border,
        "across_pixel": of.across_pixel,
        "seed": of.seed,
        "samples": radiance.samples,
        "lost": radiance.lost,
        "mean": radiance.mean.mean(axis=(0, 1)).tolist(),
        "mean_error": (np.sqrt(np.square(radiance.error).sum(axis=(0, 1))) / pixels).tolist(),
    }
