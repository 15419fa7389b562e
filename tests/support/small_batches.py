"""A sweep of a few small pictures of the tetrahedron, for the tests of batches."""

from sss_ref.batch.sweep_file import checked_sweep

SMALL = {"camera": {"width": 32, "height": 24}, "shadow_map": {"width": 32, "height": 32}}
AZIMUTHS = [0, 90, 180, 270]


def small_sweep(**changes):
    """Four pictures from around, of the scene in the folder of `data_folder`."""
    return checked_sweep({"scene": "small", "set": SMALL, "vary": {"camera.azimuth": AZIMUTHS}, **changes}, "sweep")


def items_of(folder):
    """Name -> bytes of each file, of all complete items below a batch's folder."""
    return {
        item.name: {path.name: path.read_bytes() for path in sorted(item.iterdir())}
        for item in sorted((folder / "items").glob("??/*"))
        if not item.name.startswith(".")
    }
