import pytest

from sss_ref.dump.sources import known_only, sources_of
from sss_ref.errors import DumpError

NAMES = {"depth", "image", "uv"}


def touched(folder, *names):
    for name in names:
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(b"")
    return folder


def test_files_named_as_buffers(tmp_path):
    sources = known_only(sources_of(touched(tmp_path, "depth.npy", "image.EXR", "uv.dds", "lit.npy", "a.txt")), NAMES)
    assert {source.name: source.path.name for source in sources.found} == {
        "depth": "depth.npy",
        "image": "image.EXR",
        "uv": "uv.dds",
    }
    assert {source.name: source.origin for source in sources.found} == {"depth": "bottom", "image": "top", "uv": "top"}
    assert sources.notes == (
        f"{tmp_path / 'a.txt'}: ignored, its format is not known",
        f"{tmp_path / 'lit.npy'}: ignored, lit is no buffer of this scene",
    )


def test_a_result_folder_keeps_its_buffers_below(tmp_path):
    sources = sources_of(touched(tmp_path, "image.png", "buffers/depth.npy"))
    assert [source.path for source in sources.found] == [tmp_path / "buffers" / "depth.npy"]


def test_all_that_is_wrong_with_a_folder(tmp_path):
    touched(tmp_path, "depth.npy", "depth.exr", "depth.png", "uv.bin", "image.npy")
    with pytest.raises(DumpError) as caught:
        known_only(sources_of(tmp_path), NAMES)
    assert sorted(str(caught.value).splitlines()) == [
        f"{tmp_path / 'uv.bin'}: expected a file that gives its shape, got raw bytes; write a mapping file",
        f"{tmp_path}: expected one file for the buffer depth, got depth.exr, depth.npy, depth.png; remove all but one",
    ]


def test_origin_of_a_mapping(tmp_path):
    tables = """
        [buffers.depth]
        file = "sub/depth.npy"
        [buffers.image]
        file = "image.exr"
        origin = "bottom"
        [buffers.uv]
        file = "uv.raw"
        shape = [2, 2, 2]
        dtype = "float32"
    """
    (tmp_path / "a.toml").write_text(tables)
    (tmp_path / "b.toml").write_text('origin = "top"' + tables)
    sources = sources_of(tmp_path / "a.toml")
    assert sources.found[0].path == tmp_path / "sub" / "depth.npy"
    assert [source.origin for source in sources.found] == ["bottom", "bottom", None]
    assert [source.origin for source in sources_of(tmp_path / "b.toml").found] == ["top", "bottom", "top"]
    assert sources.found[2].at("origin") == f"{tmp_path / 'a.toml'}: buffers.uv.origin"


def test_unknown_names_of_a_mapping_are_kept_to_be_refused_with_the_rest(tmp_path):
    (tmp_path / "a.toml").write_text('[buffers.dept]\nfile = "a.npy"')
    assert [source.name for source in known_only(sources_of(tmp_path / "a.toml"), NAMES).found] == ["dept"]
