import contextlib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sss_ref.dump.mapping import read_mapping
from sss_ref.errors import DumpError


def refusal(tmp_path, text):
    path = tmp_path / "m.toml"
    path.write_text(text)
    with pytest.raises(DumpError) as caught:
        read_mapping(path)
    lines = str(caught.value).splitlines()
    assert all(line.startswith(f"{path}: ") for line in lines)
    return [line.removeprefix(f"{path}: ") for line in lines]


def test_every_key(tmp_path):
    (tmp_path / "m.toml").write_text("""
        origin = "bottom"
        device = "a GPU"
        [buffers.normal_world]
        file = "g.exr"
        part = "gbuffer"
        channels = ["n.x", "n.y"]
        origin = "top"
        encoding = "float16"
        scale = 2
        offset = -1.0
        rounded_from = "float32"
        space = "view"
        normals = "octahedral"
        depth = "ray"
        background = 0
        [buffers.depth]
        file = "depth.RAW"
        shape = [4, 6, 1]
        dtype = "float32"
        channels = "R"
    """)
    mapping = read_mapping(tmp_path / "m.toml")
    normal, depth = mapping.buffers["normal_world"], mapping.buffers["depth"]
    assert (mapping.origin, normal.origin, depth.origin) == ("bottom", "top", None)
    assert mapping.device == "a GPU"
    assert (normal.file, normal.part, normal.channels) == ("g.exr", "gbuffer", ("n.x", "n.y"))
    assert normal.encoding == "float16"
    assert normal.stored == {
        "scale": 2.0,
        "offset": -1.0,
        "rounded_from": "float32",
        "space": "view",
        "normals": "octahedral",
        "depth": "ray",
    }
    assert (normal.background, depth.background, depth.depth) == (0.0, None, "window")
    assert (depth.shape, depth.dtype, depth.channels) == ((4, 6, 1), "float32", ("R",))


def test_all_problems_at_once(tmp_path):
    assert refusal(
        tmp_path,
        """
        orign = "top"
        [buffers.depth]
        file = "a.raw"
        shape = [1, -2]
        [buffers.uv]
        file = "a.jpg"
        scale = 0
        channels = 3
        part = true
        [buffers.lit]
        fil = "x"
        [buffers.image]
        file = "a.dds"
        shape = [1, 2]
        encoding = "half"
        """,
    ) == [
        "buffers.depth.shape[1]: expected a whole number from 1 to 16384, got -2; choose another value",
        "buffers.depth.dtype: expected the dtype of a raw file, got nothing; add it",
        "buffers.uv.file: expected a file name ending in .npy, .exr, .png, .tif, .tiff, .dds, .pfm, "
        '.raw, .bin, got "a.jpg"; convert the file',
        "buffers.uv.part: expected a part's name or number, got true; choose one part",
        "buffers.uv.channels: expected an array, got 3; put the values in brackets, separated by commas",
        "buffers.uv.scale: expected a number that is not zero, got 0; give the factor that undoes the storage",
        "buffers.lit.file: expected a value, got nothing; add it",
        "buffers.lit.fil: expected a known key, got this one; did you mean file?",
        "buffers.image.shape: expected no shape for a file that gives its own, got [1, 2]; remove it",
        'buffers.image.encoding: expected "float32", "float16", "unorm8", "unorm16", "snorm8", "snorm16", "srgb8", '
        '"r11g11b10f", "rgb10a2", "rgb9e5", "uint8", "uint16", "uint32", "int8", "int16" or "int32", '
        'got "half"; choose one of these',
        "orign: expected a known key, got this one; did you mean origin?",
    ]


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("", "buffers: expected a value, got nothing; add it"),
        ("buffers = 3", "buffers: expected a table, got 3; give its keys, each with a value"),
        ("[buffers]", "buffers: expected a table [buffers.NAME], got {}; add one"),
        ("buffers.x = 1", "buffers.x: expected a table, got 1; give its keys, each with a value"),
        ("file = 1\n[buffers.x]\nfile = 'a.npy'", "file: expected a known key, got this one; remove it (known here: "),
        ("[[buffers.x]]", "buffers.x: expected a table, got [{}]; give its keys, each with a value"),
        ("[buffers.x]\nfile = 'a.raw'\nshape = [1]\ndtype = 'uint8'", "buffers.x.shape: expected [height, width]"),
        ("[buffers.x]\nfile = 'a.npy'\noffset = nan", "buffers.x.offset: expected a finite number"),
        ("[buffers", "expected valid TOML, got none at end of document; correct that place"),
        ("[buffers]\nx = ?", "expected valid TOML, got none at line 2, column 5; correct that place"),
        ("a = 1979-13-01", "expected valid TOML, got none at line 1, column 9; correct that place"),
        ("a = " + "[" * 100_000, "expected valid TOML, got brackets or keys nested without end; nest less"),
        (
            "#" * 2**20 + "#",
            "expected a folder of buffers or a mapping file, of at most 1048576 bytes, got 1048577 bytes; check",
        ),
    ],
)
def test_one_problem(tmp_path, text, problem):
    (found,) = refusal(tmp_path, text)
    assert found.startswith(problem)


def test_no_file_and_no_text(tmp_path):
    with pytest.raises(
        DumpError, match="expected a folder of buffers or a mapping file, got No such file or directory; check the path"
    ):
        read_mapping(tmp_path / "none.toml")
    (tmp_path / "m.toml").write_bytes(b"\xff\xfe")
    with pytest.raises(DumpError, match="mapping file in UTF-8, got a byte that is no UTF-8 at byte 0; save"):
        read_mapping(tmp_path / "m.toml")


VALUE = st.recursive(
    st.sampled_from(
        ["true", "-1", "1e400", "nan", '"x"', '"RGB"', '"a.raw"', "9" * 400, "1979-05-27", '"\\u0000.npy"']
    ),
    lambda inner: st.lists(inner, max_size=3).map(lambda values: f"[{', '.join(values)}]"),
    max_leaves=4,
)
KEYS = [
    "file",
    "part",
    "channels",
    "shape",
    "dtype",
    "origin",
    "encoding",
    "scale",
    "offset",
    "rounded_from",
    "normals",
]


@settings(max_examples=300, derandomize=True)
@given(keys=st.dictionaries(st.sampled_from(KEYS), VALUE), tail=st.binary(max_size=20))
def test_arbitrary_tables_raise_nothing_else(tmp_path, keys, tail):
    lines = "".join(f"{key} = {value}\n" for key, value in keys.items())
    for data in (tail, b"[buffers.depth]\n" + lines.encode(), b"[buffers.depth]\n" + lines.encode() + tail):
        (tmp_path / "m.toml").write_bytes(data)
        with contextlib.suppress(DumpError):
            read_mapping(tmp_path / "m.toml")


def test_a_file_name_has_a_limit(tmp_path):
    (tmp_path / "m.toml").write_text(f"[buffers.uv]\nfile = '{'a' * 996}.npy'")
    assert len(read_mapping(tmp_path / "m.toml").buffers["uv"].file) == 1000
    (line,) = refusal(tmp_path, f"[buffers.uv]\nfile = '{'a' * 997}.npy'")
    assert line.startswith("buffers.uv.file: expected a file name of at most 1000 characters, got ")
    assert len(line) < 200
