"""What a folder of a traced scene holds, and which folder may become one."""

import json

import numpy as np
import pytest
from boxes import looking_down, parallel_light, write_box
from PIL import Image

from sss_ref.errors import DumpError, SceneError
from sss_ref.scene.load import load_scene
from sss_ref.truth.eye_rays import Sums
from sss_ref.truth.photon import Volume
from sss_ref.truth.radiance import Radiance
from sss_ref.truth.tracing import Tracing
from sss_ref.truth.truth_folder import begun, recorded, write_truth

MEDIUM = Volume(2.0, 0.5), Volume(3.0, 0.25), Volume(1.0, 1.0)


@pytest.fixture(scope="module")
def radiance(tmp_path_factory):
    """Of four samples, of which the first pixel has lost one in red; 1, 2, 3, 4 and so on for each pixel's channels."""
    box = write_box(tmp_path_factory.mktemp("box") / "box.obj", (-1.0, -1.0, -1.0), (1.0, 1.0, 1.0))
    scene = load_scene(looking_down(box, [parallel_light((0.0, 0.6, 0.8))], size=2))
    values = np.arange(1.0, 13).reshape(2, 2, 3)
    counted = np.full((2, 2, 3), 4)
    counted[0, 0, 0] = 3
    return Radiance(Tracing(scene, MEDIUM, "entered", True, 5), 4, Sums(values, values**2, counted))


def test_means_and_errors_are_of_what_was_not_lost(radiance):
    """sqrt((mean of squares - squared mean) / (n - 1)): of 1 in three samples, and of 2 in four."""
    assert radiance.lost == 1
    assert radiance.mean[0, 0].tolist() == [1 / 3, 0.5, 0.75]
    assert radiance.error[0, 0, 0] == pytest.approx(((1 / 3 - 1 / 9) / 2) ** 0.5, rel=1e-12)
    assert radiance.error[0, 0, 1] == pytest.approx(((4 / 4 - 1 / 4) / 3) ** 0.5, rel=1e-12)
    few = Radiance(radiance.of, 1, Sums(np.ones(4), np.ones(4), np.array([0, 1, 2, 2])))
    assert few.mean.tolist() == [1, 1, 0.5, 0.5] and few.error.tolist() == [np.inf, np.inf, 0.5, 0.5]


def test_the_record_says_what_was_traced_and_how_far(radiance):
    found = recorded(radiance)
    assert list(found) == [
        *("format", "scene", "settings", "inputs", "volumes_per_mm", "border", "across_pixel", "seed", "samples"),
        *("lost", "mean", "mean_error"),
    ]
    assert (found["format"], found["border"], found["across_pixel"]) == ("sss_ref truth 1", "entered", True)
    assert (found["seed"], found["samples"], found["lost"]) == (5, 4, 1)
    assert found["volumes_per_mm"][1] == {"scattering": 3, "absorption": 0.25, "anisotropy": 0, "ior": 1}
    red, green, _ = found["mean"]
    assert green == (2 + 5 + 8 + 11) / 16 and red == pytest.approx((1 / 3 + (4 + 7 + 10) / 4) / 4, rel=1e-12)
    squares = [(k * k / 4 - (k / 4) ** 2) / 3 for k in (2, 5, 8, 11)]
    assert found["mean_error"][1] == pytest.approx(sum(squares) ** 0.5 / 4, rel=1e-12)


def test_a_folder_is_written_and_goes_on(radiance, tmp_path):
    folder = tmp_path / "new" / "truth"
    assert begun(folder, radiance.of).samples == 0
    write_truth(folder, radiance)
    assert sorted(path.name for path in folder.iterdir()) == [
        *("image.png", "radiance.npy", "standard_error.npy", "sums.npz", "truth.json")
    ]
    mean, error = np.load(folder / "radiance.npy"), np.load(folder / "standard_error.npy")
    assert mean.dtype == error.dtype == np.float32
    assert np.array_equal(mean, radiance.mean.astype(np.float32)) and error.shape == (2, 2, 3)
    assert np.array_equal(error, radiance.error.astype(np.float32))
    assert Image.open(folder / "image.png").getpixel((0, 1))[1] == 188  # .5 in the lower row
    text = (folder / "truth.json").read_text()
    assert json.loads(text) == json.loads(json.dumps(recorded(radiance)))
    assert text.endswith("}\n") and text.splitlines()[1] == '  "format": "sss_ref truth 1",'
    assert np.array_equal(begun(folder, radiance.of).sums.square, radiance.sums.square)
    with pytest.raises(SceneError, match="expected the sums of this scene, material and seed"):
        begun(folder, Tracing(radiance.of.scene, MEDIUM))


def test_a_folder_with_other_files_is_left_alone(radiance, tmp_path):
    assert begun(tmp_path, radiance.of).samples == 0  # it is empty
    (tmp_path / "notes.txt").touch()
    for folder in (tmp_path, tmp_path / "notes.txt"):
        with pytest.raises(DumpError) as error:
            begun(folder, radiance.of)
        assert str(error.value) == (
            f"{folder}: expected a new folder or one of sss-ref truth, got other files; choose another folder"
        )
    with pytest.raises(DumpError, match="expected a place to write to, got File exists; choose another folder"):
        write_truth(tmp_path / "notes.txt", radiance)
