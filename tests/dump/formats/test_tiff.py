import struct
import subprocess
import sys

import numpy as np
import pytest
import tifffile

from sss_ref.dump.files import parts_of
from sss_ref.errors import DumpError


def tiff(width, height, texels, bits=32, sample_format=3, photometric=1, orientation=1):
    """A little-endian TIFF file with one strip, tag by tag."""
    tags = {
        256: width,
        257: height,
        258: bits,
        259: 1,  # uncompressed
        262: photometric,
        273: 8,  # where the strip begins
        274: orientation,
        277: 1,  # channels
        278: height,
        279: len(texels),
        339: sample_format,
    }
    entries = b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags.items())
    directory = struct.pack("<H", len(tags)) + entries + bytes(4)
    return struct.pack("<2sHI", b"II", 42, 8 + len(texels)) + texels + directory


def read(tmp_path, data):
    (tmp_path / "x.tif").write_bytes(data)
    return parts_of(tmp_path / "x.tif")


@pytest.mark.parametrize(
    ("kind", "sample_format", "storage"),
    [
        ("<f4", 3, "float32"),
        ("<f2", 3, "float16"),
        ("u1", 1, "unorm8"),
        ("<u2", 1, "unorm16"),
        ("<u4", 1, "uint32"),
        ("<i4", 2, "int32"),
    ],
)
def test_every_type(tmp_path, kind, sample_format, storage):
    values = np.random.default_rng(1).integers(0, 100, (3, 5)).astype(kind)
    (texels,) = read(tmp_path, tiff(5, 3, values.tobytes(), values.itemsize * 8, sample_format))
    assert np.array_equal(texels.data[..., 0], values) and texels.data.dtype == np.dtype(kind).newbyteorder("=")
    assert (texels.storage, texels.channels, texels.part) == (storage, ("R",), "0")


@pytest.mark.parametrize("planar", ["contig", "separate"])
def test_pages_and_channels_side_by_side_or_in_planes(tmp_path, planar):
    pages = np.random.default_rng(2).random((2, 4, 6, 3), np.float32)
    with tifffile.TiffWriter(tmp_path / "x.tif") as file:
        for page in pages:
            stored = page.transpose(2, 0, 1) if planar == "separate" else page
            file.write(stored, photometric="rgb", planarconfig=planar)
    found = parts_of(tmp_path / "x.tif")
    assert [texels.part for texels in found] == ["0", "1"]
    for texels, page in zip(found, pages, strict=True):
        assert np.array_equal(texels.data, page) and texels.channels == ("R", "G", "B")


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "expected a whole TIF file, got one that is damaged"),
        (tiff(5, 3, bytes(60), photometric=0), "got axes YX, photometric 0, orientation 1"),
        (tiff(5, 3, bytes(60), orientation=4), "got axes YX, photometric 1, orientation 4"),
        (tiff(100000, 3, bytes(60)), "got 100000 x 3"),
        (tiff(5, 3, bytes(120), bits=64), "got float64"),
    ],
)
def test_what_is_refused(tmp_path, data, message):
    with pytest.raises(DumpError) as caught:
        read(tmp_path, data)
    assert message in str(caught.value)


def test_without_tifffile_the_message_says_how_to_get_it(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "tifffile", None)
    with pytest.raises(DumpError, match=r"got none; pip install 'sss_ref\[validate\]'"):
        read(tmp_path, tiff(5, 3, bytes(60)))


COMPRESSIONS = [
    ("lzw", None),
    ("lzw", True),
    ("adobe_deflate", None),
    ("adobe_deflate", True),
    ("packbits", None),
    ("zstd", True),
]


@pytest.mark.parametrize(("compression", "predictor"), COMPRESSIONS)
@pytest.mark.parametrize("kind", ["f4", "f2", "u1", "u2"])
@pytest.mark.parametrize("layout", [{}, {"tile": (16, 16)}, {"byteorder": ">"}, {"planarconfig": "separate"}])
def test_compressions_that_lose_nothing(tmp_path, compression, predictor, kind, layout):
    """With the horizontal predictor for integers and that of floating point for floats, OpenImageIO's default."""
    values = (np.random.default_rng(3).random((20, 24, 3)) * 200).astype(kind)
    order = {"byteorder": layout["byteorder"]} if "byteorder" in layout else {}
    form = {key: value for key, value in layout.items() if key != "byteorder"}
    stored = values.transpose(2, 0, 1) if "planarconfig" in layout else values
    with tifffile.TiffWriter(tmp_path / "x.tif", **order) as file:
        file.write(stored, photometric="rgb", compression=compression, predictor=predictor, **form)
    (texels,) = parts_of(tmp_path / "x.tif")
    assert np.array_equal(texels.data, values) and texels.data.dtype == values.dtype


@pytest.mark.parametrize(("compression", "number"), [("deflate", 32946), ("lzma", 34925)])
def test_the_rarer_compressions(tmp_path, compression, number):
    """Deflate under the number that it had before TIFF's own supplement; and LZMA."""
    values = np.random.default_rng(4).random((8, 6), np.float32)
    tifffile.imwrite(tmp_path / "x.tif", values, compression=compression)
    with tifffile.TiffFile(tmp_path / "x.tif") as file:
        assert int(file.pages[0].compression) == number
    (texels,) = parts_of(tmp_path / "x.tif")
    assert np.array_equal(texels.data[..., 0], values)


def test_a_compression_that_loses_bits_is_refused_by_name(tmp_path):
    tifffile.imwrite(tmp_path / "x.tif", np.zeros((16, 16, 3), np.uint8), photometric="rgb", compression="jpeg")
    with pytest.raises(DumpError, match=r"that loses nothing \(none, LZW, .*\), got JPEG \(7\); save it with one"):
        parts_of(tmp_path / "x.tif")


def test_without_imagecodecs_the_message_names_it_and_plain_files_are_read(tmp_path, monkeypatch):
    tifffile.imwrite(tmp_path / "x.tif", np.zeros((4, 4), np.float32), compression="lzw", predictor=True)
    tifffile.imwrite(tmp_path / "plain.tif", np.zeros((4, 4), np.float32))
    monkeypatch.setitem(sys.modules, "imagecodecs", None)
    told = r"expected the package imagecodecs, which reads the compression LZW with predictor 3, got none; pip install"
    with pytest.raises(DumpError, match=told):
        parts_of(tmp_path / "x.tif")
    assert parts_of(tmp_path / "plain.tif")[0].data.shape == (4, 4, 1)


def test_a_smaller_copy_of_a_page_is_no_page(tmp_path):
    with tifffile.TiffWriter(tmp_path / "x.tif") as file:
        file.write(np.ones((8, 8), np.float32))
        file.write(np.zeros((4, 4), np.float32), subfiletype=1)
    (texels,) = parts_of(tmp_path / "x.tif")
    assert texels.data.shape == (8, 8, 1)


def test_only_our_line_is_told_of_a_broken_file(tmp_path):
    """In a process of its own: where a program has no handler for what is logged, Python prints it."""
    data = bytearray(tiff(2, 2, bytes(16)))
    data[data.index(struct.pack("<HHII", 273, 4, 1, 8)) + 4] = 255  # so many places where the strip begins
    (tmp_path / "x.tif").write_bytes(data)
    code = "import sys, pathlib; from sss_ref.dump.files import parts_of; parts_of(pathlib.Path(sys.argv[1]))"
    done = subprocess.run([sys.executable, "-c", code, tmp_path / "x.tif"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("Traceback") and "expected a whole TIF file" in done.stderr
