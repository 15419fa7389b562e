"""Words of a text and the numbers they are."""

import time

import numpy as np
import pytest

from sss_ref.mesh.words import Words, floats, named, plain, wholes

TEXT = b"\t one  two#three\n\n # four\nfive\x0bsix"


def test_words_are_what_stands_between_blanks():
    words = Words.of(TEXT)
    assert [words[k] for k in range(len(words))] == [b"one", b"two", b"five", b"six"]
    assert words.line.tolist() == [0, 0, 3, 3]
    assert (words.heads.tolist(), words.counts.tolist()) == ([0, 2], [2, 2])
    assert words.rest(0) == b"two#three"


def test_whatever_python_takes_for_a_blank_is_one():
    for number in range(256):
        words = Words.of(b"a%cb\n" % number, comments=False)
        assert len(words) == 1 + bytes([number]).isspace(), number


def test_words_with_marks_of_comments_in_them():
    words = Words.of(TEXT, comments=False)
    assert [words[k] for k in range(len(words))] == [b"one", b"two#three", b"#", b"four", b"five", b"six"]


def test_a_comment_ends_with_its_line_however_many_marks_it_has():
    words = Words.of(b"a # b # c\nd #\n#e\nf")
    assert [words[k] for k in range(len(words))] == [b"a", b"d", b"f"]


def test_no_words():
    for text in (b"", b" \n", b"#"):
        words = Words.of(text)
        assert len(words) == len(words.heads) == len(words.floats(np.zeros(0, bool))) == 0


@pytest.mark.parametrize("text", [b"a\nb\n", b"a\r\nb\r\n", b"a\rb\r", b"\xef\xbb\xbfa\nb\n"])
def test_one_form_of_lines(text):
    assert plain(text) == b"a\nb\n"


def test_a_word_in_any_case_and_no_other():
    words = Words.of(b"Vertex vertex vert VERTEXES v3rtex")
    assert words.are(b"vertex", np.arange(5)).tolist() == [True, True, False, False, False]


def test_only_the_chosen_words():
    words = Words.of(b"ab c#x\n de f")
    assert words.only(np.array([False, True, True, False])) == b"c    de"
    assert words.only(np.zeros(4, bool)) == b""


@pytest.mark.parametrize(
    "word, number", [("1e-3", 0.001), (".5", 0.5), ("1.", 1), ("+1", 1), ("-2E+1", -20), ("0.1", 0.1)]
)
def test_forms_of_numbers(word, number):
    assert floats(word.encode(), 1).tolist() == [number]
    assert floats(f"{word} x".encode(), 2)[0] == number  # the slow way, where some words are none


@pytest.mark.parametrize("word", ["x", "1,5", "0x10", "1_0", "3.1+e2", "1d5", "--1", "1.#QNAN", "\u0663"])
def test_what_is_no_number(word):
    found = floats(f"7 {word} 9".encode(), 3)
    assert found[[0, 2]].tolist() == [7, 9] and np.isnan(found[1])


def test_numbers_are_rounded_once():
    """2^53 + 1 lies half way between two float64 numbers; a hair more decides."""
    assert floats(b"9007199254740993 9007199254740993.0000000000000001", 2).tolist() == [2.0**53, 2.0**53 + 2]


def test_whole_numbers():
    assert wholes(b"+3 -4 9223372036854775807", 3, 0).tolist() == [3, -4, 2**63 - 1]
    assert wholes(b"3 1.5 x -9223372036854775808", 4, -7).tolist() == [3, -7, -7, -(2**63)]


@pytest.mark.parametrize("word", ["99999999999999999999", "-99999999999999999999", "9" * 5000])
def test_whole_numbers_beyond_64_bits_are_far_beyond_every_index(word):
    for text, count in ((word, 1), (f"{word} x", 2)):
        assert abs(float(wholes(text.encode(), count, 0)[0])) == 2.0**63


@pytest.mark.parametrize("word", [b"0" * 30 + b"7", b"-" + b"0" * 30 + b"7", b"00000000000000000003"])
def test_zeros_in_front_of_a_whole_number(word):
    assert wholes(word, 1, 0).tolist() == [int(word)] and wholes(word + b" x", 2, -1).tolist() == [int(word), -1]


def test_many_numbers_are_read_at_once():
    """One by one, as where a word is none, it takes about ten times as long."""

    def seconds(text):
        begin = time.process_time()
        floats(text, 20000)
        return time.process_time() - begin

    at_once, one_by_one = (min(seconds(b"0.125 " * 19999 + last) for _ in range(5)) for last in (b"1", b"x"))
    assert at_once < one_by_one / 2


def test_names_are_utf_8_or_latin_1():
    assert named("K\u00f6pfe".encode()) == named("K\u00f6pfe".encode("latin-1")) == "K\u00f6pfe"
