"""What `sss-ref neutral` prints of its trials, and whom it lets draw; the trials have tests of their own."""

from types import SimpleNamespace

import pytest

from sss_ref.cli import main, neutral_command


class Trial:
    """Stands in for a trial: what it prints, and whether anything changed."""

    def __init__(self, text, broken):
        self.text, self.broken = text, broken

    def __str__(self):
        return self.text


@pytest.fixture
def drawn_by(monkeypatch):
    """Runs the command with trials that are given; who drew, and which changes were asked for."""
    seen = []

    def run(trials, *words):
        def neutral(scene, artist, only):
            seen.append((scene.settings, artist, only))
            return trials

        monkeypatch.setattr("sss_ref.scene.load.load_scene", lambda name, **_: SimpleNamespace(settings=name))
        monkeypatch.setattr("sss_ref.neutral.trial.neutral", neutral)
        monkeypatch.setattr(neutral_command, "shaders_of", lambda folder, settings: folder)
        monkeypatch.setattr("sss_ref.gl.shader_artist.ShaderArtist", lambda files: ("OpenGL", files))
        return main(["neutral", "wedge", *words])

    run.seen = seen
    return run


@pytest.mark.parametrize(
    ("broken", "code", "last"),
    [
        ((), 0, "neutral: nothing changed"),
        ((False,), 0, "neutral: nothing changed"),
        ((True,), 1, "broken: 1"),
        ((True, False, True), 1, "broken: 2"),
    ],
)
def test_how_many_changed_is_told_last(broken, code, last, drawn_by, capsys):
    trials = [Trial(f"[bold]change {k}", each) for k, each in enumerate(broken)]
    assert drawn_by(trials) == code
    assert capsys.readouterr().out.splitlines() == [*(f"[bold]change {k}" for k in range(len(broken))), last]


def test_opengl_draws_where_it_is_asked_for_and_with_ones_own_shaders(drawn_by, tmp_path):
    assert (
        drawn_by([]) == drawn_by([], "--run-glsl") == drawn_by([], "--shaders", str(tmp_path), "--only", "wider") == 0
    )
    assert drawn_by.seen == [
        ("wedge", None, ()),
        ("wedge", ("OpenGL", None), ()),
        ("wedge", ("OpenGL", tmp_path), ("wider",)),
    ]
