"""Validating from files and on the command line: the report, its page, its JSON, and what cannot be judged."""

import json
import shutil
from dataclasses import replace

import numpy as np
import pytest
from scenes import around, two_slabs, written

import sss_ref
from sss_ref.cli import main
from sss_ref.errors import SceneError
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.report.report import Report
from sss_ref.validation.report.report_data import as_json
from sss_ref.validation.report.report_page import as_html
from sss_ref.validation.verdict.clusters import Clusters
from sss_ref.validation.verdict.verdict import Verdict, WrongPixel

SMALL = ["--size", "48x48", "--set", "shadow_map.width=48", "--set", "shadow_map.height=48", "--interpreter", "arrays"]
OVERRIDES = {f"{t}.{s}": 48 for t in ("camera", "shadow_map") for s in ("width", "height")}


@pytest.fixture(scope="module")
def oracle():
    return render(load_scene("sphere", **OVERRIDES), interpreter="arrays")


@pytest.fixture
def dump(oracle, tmp_path):
    """A folder of NPY files: what a right implementation would have dumped."""
    folder = tmp_path / "dump"
    folder.mkdir()
    for name, buffer in oracle.buffers.items():
        np.save(folder / f"{name}.npy", buffer)
    return folder


def test_a_right_dump_passes(dump, capsys):
    assert main(["validate", "sphere", str(dump), *SMALL]) == 0
    assert "every stage gives what it should" in capsys.readouterr().out


def test_a_wrong_dump_fails_and_is_reported(dump, oracle, tmp_path, capsys):
    wrong = render(load_scene("sphere", **OVERRIDES, **{"phong.shininess": 20.0}), interpreter="arrays")
    for name in ("phong", "lit", "scattered", "image"):
        np.save(dump / f"{name}.npy", wrong[name])
    assert main(["validate", "sphere", str(dump), *SMALL, "--report", str(tmp_path / "report")]) == 1
    printed = capsys.readouterr().out
    assert "fail: stage phong_shading of pass camera is the first that is wrong" in printed
    assert "shininess is 20 instead of" in printed
    page = (tmp_path / "report" / "report.html").read_text()
    assert "shininess is 20 instead of" in page and page.count("data:image/png;base64,") == 4
    assert "http" not in page.replace("http://www.w3.org", "")
    assert "float lambert = diffuse * max_(dot_(normal_world, to_light), 0.0);" in page
    data = json.loads((tmp_path / "report" / "report.json").read_text())
    assert data["passed"] is False and data["explanations"][0]["text"].startswith("shininess is 20 ")
    failed = [one for one in data["buffers"] if not one["passed"]]
    assert [one["buffer"] for one in failed] == ["phong"]
    assert data["details"] and all(line in printed for line in data["details"])
    assert all(sum(one["outcomes"]) == one["pixels"] for one in data["buffers"])
    assert all(len(one["widths"]) == len(data["width_classes"]) for one in data["buffers"])
    column, row = failed[0]["first"]["at"]
    assert failed[0]["first"]["triangles"] == [int(oracle["triangle"][row, column])]
    assert failed[0]["clusters"]["sentence"] in page and "translucency_ratio_throughout" in [
        one["stage"] for one in data["power"]
    ]
    assert list(data["seconds"]) == ["reading", "rendering", "rebased", "hypotheses", "chained", "power"]
    assert "chained " in printed.split("time: ")[1]
    assert data["profile"] == "vulkan" and data["device"] is None and "device not given" in printed + page


def test_the_device_and_the_metrics_are_told(dump, oracle, tmp_path, capsys):
    pytest.importorskip("flip_evaluator", reason="install .[metrics]")
    tables = "".join(f'[buffers.{name}]\nfile = "{name}.npy"\n' for name in oracle.buffers)
    (dump / "mapping.toml").write_text(f'device = "Imaginary <GPU>"\n{tables}')
    arguments = ["validate", "sphere", str(dump / "mapping.toml"), *SMALL, "--metrics", "--profile", "gl"]
    assert main([*arguments, "--report", str(tmp_path / "report")]) == 0
    printed = capsys.readouterr().out
    assert printed.startswith("profile gl, Imaginary <GPU>\n") and "image: SSIM 1.000000, FLIP 0.000000" in printed
    page = (tmp_path / "report" / "report.html").read_text()
    assert "Imaginary &lt;GPU&gt;" in page and "image: SSIM 1.000000" in page and "What would explain it" not in page
    data = json.loads((tmp_path / "report" / "report.json").read_text())
    assert data["device"] == "Imaginary <GPU>" and data["likeness"][-1]["buffer"] == "image"


def test_numbers_that_json_does_not_have(dump, oracle, tmp_path, capsys):
    """A NaN lies infinitely far beyond its interval."""
    np.save(dump / "image.npy", np.full_like(oracle["image"], np.nan))
    assert main(["validate", "sphere", str(dump), *SMALL, "--report", str(tmp_path)]) == 1
    (image,) = (
        one for one in json.loads((tmp_path / "report.json").read_text())["buffers"] if one["buffer"] == "image"
    )
    assert image["worst"]["ulps"] is None and image["worst"]["got"] == "(nan, nan, nan)"
    assert "Infinity" not in (tmp_path / "report.json").read_text()
    capsys.readouterr()


def test_files_with_fewer_bits_than_their_textures(dump, oracle, capsys):
    """What the blur read is not what the file holds; a wrong blur fails nevertheless."""
    np.save(dump / "lit.npy", oracle["lit"].astype(np.float16))
    tables = "".join(f'[buffers.{name}]\nfile = "{name}.npy"\n' for name in oracle.buffers if name != "lit")
    mapping = dump / "mapping.toml"
    arguments = ["validate", "sphere", str(mapping), *SMALL, "--quick"]
    lit = '[buffers.lit]\nfile = "lit.npy"\n'
    mapping.write_text(tables + lit)
    assert main(arguments) == 1
    assert "stage scatter_inside of pass blur is the first that is wrong" in capsys.readouterr().out
    mapping.write_text(f'{tables}{lit}rounded_from = "float32"\n')
    assert main(arguments) == 0
    np.save(dump / "scattered.npy", oracle["scattered"] * np.float32(1.01))
    assert main(arguments) == 1
    assert "stage scatter_inside of pass blur is the first that is wrong" in capsys.readouterr().out


def test_rows_from_the_top(dump, oracle, capsys):
    for name, buffer in oracle.buffers.items():
        np.save(dump / f"{name}.npy", buffer[::-1])
    assert main(["validate", "sphere", str(dump), *SMALL, "--quick"]) == 1
    assert main(["validate", "sphere", str(dump), *SMALL, "--origin", "top"]) == 0
    capsys.readouterr()


@pytest.mark.parametrize("profile", ["ieee", "vulkan", "gl", "mediump"])
def test_every_profile_accepts_the_oracle(dump, oracle, profile, capsys):
    assert main(["validate", "sphere", str(dump), *SMALL, "--profile", profile]) == 0
    capsys.readouterr()


def test_a_profile_says_how_far_off_is_right(oracle):
    """1e-6 beside every colour: right on a GPU, wrong where every operation is correctly rounded."""
    beside = dict(oracle.buffers) | {"phong": (oracle["phong"] * np.float32(1.000001)).astype(np.float32)}
    for later in ("lit", "scattered", "image"):
        del beside[later]
    assert sss_ref.validate(oracle, beside, profile="gl", explain=False).passed
    found = sss_ref.validate(oracle, beside, profile="ieee", explain=False)
    assert not found.passed and found.culprit.stage == "phong_shading"


def test_only_some_pixels(dump, oracle, tmp_path, capsys):
    """A wrong corner is not seen in a region beside it, nor under a mask."""
    image = oracle["image"].copy()
    image[:8, :8] += 1
    np.save(dump / "image.npy", image)
    assert main(["validate", "sphere", str(dump), *SMALL, "--quick"]) == 1
    assert main(["validate", "sphere", str(dump), *SMALL, "--region", "8,8,40,40"]) == 0
    mask = np.zeros((48, 48), np.uint8)
    mask[:8, :8] = 1
    np.save(tmp_path / "mask.npy", mask)
    assert main(["validate", "sphere", str(dump), *SMALL, "--exclude", str(tmp_path / "mask.npy")]) == 0
    assert main(["validate", "sphere", str(dump), *SMALL, "--region", "8,8,99,1"]) == 2
    capsys.readouterr()


def test_what_cannot_be_used(dump, tmp_path, capsys):
    for arguments, message in (
        (["sphere"], "expected a folder of buffers, a mapping file, --run-glsl or --run-wgsl, got none"),
        (["sphere", str(tmp_path / "none")], str(tmp_path / "none")),
        (["wedge", str(dump)], "48"),
    ):
        assert main(["validate", *arguments, *(SMALL if arguments[0] == "sphere" else [])]) == 2
        assert message in capsys.readouterr().err
    shutil.copy(dump / "lit.npy", dump / "litt.npy")
    assert main(["validate", "sphere", str(dump), *SMALL]) == 0  # passed over, with a note
    assert "litt" in capsys.readouterr().err


@pytest.mark.parametrize("storage", ["float16", "unorm8", "unorm16"])
def test_what_a_texture_rounds_is_no_error_but_what_it_should_not_hold_is(oracle, storage):
    rounded = {
        "float16": lambda v: v.astype(np.float16).astype(np.float32),
        "unorm8": lambda v: (np.rint(np.clip(v, 0, 1) * 255) / 255).astype(np.float32),
        "unorm16": lambda v: (np.rint(np.clip(v, 0, 1) * 65535) / 65535).astype(np.float32),
    }[storage]
    names = ("albedo", "lit") if storage != "float16" else ("position_world", "normal_world", "thickness", "lit")
    buffers = dict(oracle.buffers) | {name: rounded(oracle[name]) for name in names}
    for later in ("scattered", "image"):  # made of a texture `lit` of full precision, which is not there
        del buffers[later]
    assert sss_ref.validate(oracle, buffers, dict.fromkeys(names, storage), explain=False).passed
    found = sss_ref.validate(oracle, buffers)
    assert not found.passed and found.culprit.buffer in names


def test_a_narrow_texture_is_recognised(oracle):
    buffers = dict(oracle.buffers) | {"thickness": oracle["thickness"].astype(np.float16).astype(np.float32)}
    found = sss_ref.validate(oracle, buffers)
    assert found.culprit.buffer == "thickness"
    assert 'it was stored as float16: declare encoding = "float16"' in [each.text for each in found.finding.hypotheses]


MISHAPS = {
    "its rows are upside down": lambda v: v[::-1],
    "its channels are in reverse order": lambda v: v[..., ::-1],
    "its sign is turned": lambda v: -v,
    "it is n*.5+.5": lambda v: (v * np.float32(0.5) + np.float32(0.5)).astype(np.float32),
}


@pytest.mark.parametrize("text", MISHAPS)
def test_mishaps_on_the_way_are_recognised(oracle, text):
    buffers = {"normal_world": np.ascontiguousarray(MISHAPS[text](oracle["normal_world"]))}
    found = sss_ref.validate(oracle, buffers)
    assert not found.passed and text in [each.text for each in found.finding.hypotheses]


def test_in_tests_of_ones_own(oracle):
    sss_ref.assert_valid(oracle, oracle.buffers)
    wrong = dict(oracle.buffers) | {"stored_distance": oracle["stored_distance"] + np.float32(0.01)}
    with pytest.raises(AssertionError, match=r"fail: stage shadow_lookup_nearest of pass camera is the first that is"):
        sss_ref.assert_valid(oracle, wrong)


def test_buffers_of_another_form_are_refused(oracle):
    with pytest.raises(SceneError, match=r"expected names of light_triangle, .*, got 'depht'"):
        sss_ref.validate(oracle, {"depht": oracle["depth"]})
    with pytest.raises(SceneError, match=r"expected lit as float32 \(48, 48, 3\), got float64 \(48, 48, 3\); convert"):
        sss_ref.validate(oracle, {"lit": oracle["lit"].astype(np.float64)})


def test_a_failing_rasterizer_has_no_lines_to_show(tmp_path):
    path = written(tmp_path / "slabs.obj", *two_slabs())
    one, other = (render(load_scene(around(path, 32), **{"camera.azimuth": a}), "arrays") for a in (20, 25))
    found = sss_ref.validate(one, other.buffers)
    assert found.finding.section is None and found.culprit.stage == "rasterizer"
    assert "rasterizer" in as_html(found, "title") and not as_json(found)["passed"]


def verdict_of(**changed):
    """A verdict on 100 pixels that are right."""
    given = dict.fromkeys(("compared", "equal", "within", "bounded", "comparable"), 100)
    given |= dict.fromkeys(("ambiguous", "unbounded", "undefined"), 0)
    return Verdict("camera", "phong_shading", "phong", **(given | {"ulps": (), "widths": None} | changed))


@pytest.mark.parametrize(
    ("count", "told"),
    [
        (0, ""),
        (1, "; dump b0 to narrow"),
        (4, "; dump b0, b1, b2, b3 to narrow"),
        (5, "; dump b0, b1, b2, b3, 1 more to narrow"),
        (9, "; dump b0, b1, b2, b3, 5 more to narrow"),
    ],
)
def test_four_buffers_that_would_narrow_bounds_are_named(count, told):
    one = verdict_of(passing=0.25, narrowing=tuple(f"b{k}" for k in range(count)))
    summary = Report((one,), ()).summary
    start = "pass: 1 buffers, every stage gives what it should; phong: bounds so wide that 25% of its range passes"
    assert summary == start + told


@pytest.mark.parametrize(
    ("count", "told"),
    [
        (1, ""),
        (2, ", or one before it whose output was not given (a/s0),"),
        (7, ", or one before it whose output was not given (a/s0, a/s1, a/s2, a/s3, a/s4, a/s5),"),
        (8, ", or one before it whose output was not given (1 more, a/s1, a/s2, a/s3, a/s4, a/s5, a/s6),"),
        (10, ", or one before it whose output was not given (3 more, a/s3, a/s4, a/s5, a/s6, a/s7, a/s8),"),
    ],
)
def test_six_suspects_are_named_the_nearest_ones(count, told):
    wrong = verdict_of(within=75, suspects=tuple(f"a/s{k}" for k in range(count)))
    said = (
        f"fail: stage phong_shading of pass camera{told} is the first that is wrong: 25.0% of the pixels of phong are "
    )
    assert Report((wrong,), ()).summary.startswith(said + "out of reach, worst ")


@pytest.mark.parametrize(
    ("comparable", "told"), [(111, "pass: "), (112, "pass as far as was judged, 89% of the pixels")]
)
def test_nine_of_ten_pixels_are_nearly_the_whole(comparable, told):
    assert Report((verdict_of(comparable=comparable),), ()).summary.startswith(told)


@pytest.mark.parametrize(("failing", "few"), [(7, True), (8, False)])
def test_fewer_than_eight_wrong_pixels_are_too_few_to_explain(failing, few):
    pixel = WrongPixel((1, 2), "2.0", "1.0", (3,), 1234.5, 0.5)
    wrong = verdict_of(within=100 - failing, first=pixel, worst=pixel, clusters=Clusters((), "they lie here"))
    details = Report((wrong,), ()).details
    far = "the worst pixel is 1.23e+03 ulp beyond its interval, 0.5 times its width"
    assert details[:3] == [f"first {pixel}", far, "they lie here"]
    assert details[3:] == ["too few pixels are wrong to say what would explain it"] * few
    lost = replace(wrong, worst=replace(pixel, widths=float("inf")))
    assert far not in Report((lost,), ()).details
