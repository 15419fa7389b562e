"""Profiles from files: what a file gives lies on the profile it is based on, and what is wrong is told."""

import pytest

from sss_ref.errors import ProfileError
from sss_ref.interpret.intervals.profile import PROFILES, Profile
from sss_ref.numerics.bounded import Bounded
from sss_ref.numerics.ieee import Ieee
from sss_ref.validation.profile_file import profile_of


@pytest.fixture
def read(tmp_path):
    def of(text):
        path = tmp_path / "device.toml"
        path.write_text(text)
        return profile_of(path)

    return of


@pytest.mark.parametrize("name", PROFILES)
def test_a_name_is_enough(name):
    assert profile_of(name) is PROFILES[name]


def test_named_profiles():
    assert PROFILES["vulkan"] == Profile()
    assert PROFILES["ieee"].arithmetic == Ieee() and PROFILES["ieee"].position_slack == 0
    assert PROFILES["gl"].arithmetic.relative == 1e-5 and PROFILES["gl"].position_slack == 1 / 256


def test_a_file_changes_what_it_names(read):
    assert read("") == PROFILES["vulkan"]
    assert read('contraction = "free"') == Profile(contraction="free")
    changed = read('based_on = "gl"\nsubpixel_bits = 4\nweight_bits = 0\n[bounds]\ndivide_ulp = 4.5\n')
    assert changed == Profile(Bounded(relative=1e-5, divide_ulp=4.5), subpixel_bits=4, weight_bits=0)


def test_bounds_on_top_of_ieee_are_vulkans_where_the_file_is_silent(read):
    assert read('based_on = "ieee"').arithmetic == Ieee()
    assert read('based_on = "ieee"\n[bounds]\nexp_ulp = 1').arithmetic == Bounded(exp_ulp=1.0)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            'based_on = "dx"',
            'based_on: expected "ieee", "vulkan", "wgsl", "gl" or "mediump", got "dx"; choose one of these',
        ),
        ("snap = 3", 'snap: expected "nearest" or "any", got 3; choose one of these'),
        (
            'contraction = "none"',
            'contraction: expected "unfused", "fused" or "free", got "none"; choose one of these',
        ),
        ("subpixel_bits = 5", "subpixel_bits: expected 4 or 8, got 5; choose one of these"),
        ("weight_bits = -1", "weight_bits: expected a whole number from 0 to 16384, got -1; choose another value"),
        ("reversed_depth = 1", "reversed_depth: expected true or false, got 1; write it without quotes"),
        ("speed = 1", "speed: expected a known key, got this one; remove it (known here: based_on, bounds,"),
        ("bounds = 4", "bounds: expected a table, got 4; give its keys, each with a value"),
        ("[bounds]\ndivide_ulp = nan", "bounds.divide_ulp: expected a finite number"),
        ("[bounds]\ndivide_ulp = -1.0", "bounds.divide_ulp: expected a number >= 0, got -1.0; choose another value"),
        ("[bounds]\nexp_ulps = 3", "bounds.exp_ulps: expected a known key, got this one; did you mean exp_ulp?"),
        ("weight_bits = ", "expected valid TOML, got none at end of document; correct that place"),
    ],
)
def test_what_is_wrong_is_told(read, tmp_path, text, told):
    with pytest.raises(ProfileError) as raised:
        read(text)
    assert str(raised.value).startswith(f"{tmp_path / 'device.toml'}: {told}")


def test_all_that_is_wrong_is_told_at_once(read):
    with pytest.raises(ProfileError) as raised:
        read('snap = "some"\n[bounds]\nexp_ulp = "3"')
    assert len(str(raised.value).splitlines()) == 2


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(ProfileError, match=r"expected a profile file or a profile \(ieee, vulkan, wgsl, gl, mediump\)"):
        profile_of(tmp_path / "none.toml")
