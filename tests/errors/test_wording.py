"""One line for each problem, whatever a file has in it."""

from sss_ref.errors.wording import cut, told, written


def test_a_problem():
    assert told("a.toml: near", "a number", '"1"', "write it without quotes") == (
        'a.toml: near: expected a number, got "1"; write it without quotes'
    )


def test_what_a_terminal_would_carry_out_is_spelt():
    """The end of a line, an escape sequence that clears the screen, a line separator, half a surrogate pair."""
    line = told("a\nb", "c", "\x1b[2J\u2028\ud800", "d")
    assert line == "a\\nb: expected c, got \\x1b[2J\\u2028\\ud800; d"


def test_letters_of_every_script_stay():
    assert told("märchen", "皮膚", "é", "d") == "märchen: expected 皮膚, got é; d"


def test_what_is_long_is_cut():
    line = told("a", "b" * 501, "c" * 401, "d")
    assert line == f"a: expected {'b' * 497}..., got {'c' * 397}...; d"
    assert told("a", "b" * 500, "c" * 400, "d") == f"a: expected {'b' * 500}, got {'c' * 400}; d"
    assert cut("a" * 60) == "a" * 60 and cut("a" * 61) == "a" * 57 + "..."


def test_a_long_key_is_cut():
    assert written(("lights", 0, "[" * 100)) == f"lights[0].{'[' * 57}..."
    assert written(()) == "scene"
