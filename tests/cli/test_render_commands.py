"""What `sss-ref render` and `warmup` keep and print; rendering has tests of its own."""

import re
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace

import pytest

from sss_ref.cli import main


class Rendered:
    """Runs the command with the rooms below replaced by what tells how it was called."""

    def __init__(self, monkeypatch):
        self.seen, self.until = [], None
        rooms = {
            "scene.load.load_scene": self.load,
            "results.folder.checked_target": lambda folder: folder,
            "results.folder.saving": self.saving,
            "results.saving.shows_all": lambda result: self.shows_all,
            "rendering.fold.machine_of": self.machine_of,
            "rendering.fold.folded": self.folded,
            "rendering.samples.render_samples": self.render_samples,
            "cache.compiled.is_cold": lambda: False,
        }
        for name, stand_in in rooms.items():
            monkeypatch.setattr(f"sss_ref.{name}", stand_in)
        self.shows_all = False

    def __call__(self, *words):
        self.seen.clear()
        return main(["render", "wedge", *words])

    def load(self, name):
        passes = [
            SimpleNamespace(name="camera", values=["uv", "lit", "register"]),
            SimpleNamespace(name="blur", values=["blurred"]),
            SimpleNamespace(name="composite", values=["image"]),
        ]
        method = SimpleNamespace(passes=passes)
        return SimpleNamespace(
            warnings=["a [bold] scene"],
            method=method,
            kept=lambda names: ("kept", names),
            until=lambda name: f"to {name}",
        )

    def result(self, scene):
        hashes = {name: f"{name}".ljust(12, "0") + "f" * 52 for name in ("uv", "lit", "image")}
        timings = {"camera": 0.0126, "composite": 1.5}
        return SimpleNamespace(scene=scene, hashes=hashes, timings=timings, notes=["nothing [is] drawn"])

    @contextmanager
    def saving(self, folder, interpreter, threads):
        self.seen.append((folder, interpreter, threads))
        yield SimpleNamespace(take=None, finish=lambda result: result)

    @contextmanager
    def machine_of(self, interpreter, threads):
        yield (interpreter, threads)

    def folded(self, scene, machine, kept, on_pass, on_buffer):
        self.seen.append((machine, kept))
        return self.result(scene)

    def render_samples(self, scene, samples, interpreter, threads, on_pass):
        self.seen.append((samples, interpreter, threads))
        return self.result(scene)


@pytest.fixture
def rendered(monkeypatch):
    return Rendered(monkeypatch)


KERNEL = ("kernel", None)


@pytest.mark.parametrize(
    ("words", "what"),
    [
        ((), (KERNEL, ("kept", "all"))),
        (("--keep", "all"), (KERNEL, ("kept", "all"))),
        (("--keep", "final"), (KERNEL, ("kept", "final"))),
        (("--until", "lit"), (KERNEL, ("kept", "to lit"))),
        (("--until", "lit", "--keep", "all"), (KERNEL, ("kept", "to lit"))),
        (("--samples", "1", "--threads", "2"), (("kernel", 2), ("kept", "all"))),
        (("--samples", "2"), (2, *KERNEL)),
        (("--samples", "3", "--interpreter", "arrays"), (3, "arrays", None)),
    ],
)
def test_what_is_rendered(words, what, rendered):
    assert rendered(*words, "-o", "out") == 0
    assert rendered.seen[1:] == [what] and rendered.seen[0][0] == Path("out")


def test_each_pass_has_its_time_and_the_first_digits_of_its_buffers(rendered, capsys):
    assert rendered("-o", "out[1]") == 0
    told = capsys.readouterr()
    rows = [re.split(r" *[│┃] ?", line)[1:-1] for line in told.out.splitlines() if line[0] in "│┃"]
    assert rows == [
        ["pass", "  ms", "buffer", "sha256"],
        ["camera", "  13", "uv", "uv0000000000"],
        ["", "", "lit", "lit000000000"],
        ["composite", "1500", "image", "image0000000"],
    ]
    assert told.out.splitlines()[-1] == "out[1]: open overview.png first"
    assert told.err == "warning: a [bold] scene\nwarning: nothing [is] drawn\n"
    rendered.shows_all = True
    assert rendered() == 0
    assert capsys.readouterr().out.splitlines()[-1] == "out: open image.png first"


@pytest.mark.parametrize(
    ("place", "told"),
    [(Path("a[1]"), "a[1]"), (None, "nowhere: no folder can be written to, see SSS_REF_CACHE_DIR")],
)
def test_warming_up_tells_its_time_and_where_kernels_are_kept(place, told, monkeypatch, capsys):
    times = iter((100.0, 102.46))
    monkeypatch.setattr("sss_ref.cli.render_commands.time", SimpleNamespace(perf_counter=lambda: next(times)))
    monkeypatch.setattr("sss_ref.rendering.warming.steps", lambda: iter("ab"))
    monkeypatch.setattr("sss_ref.cache.compiled.cache_folder", lambda: place)
    assert main(["warmup"]) == 0
    assert capsys.readouterr().out == f"kernels ready after 2.5 s, kept in {told}\n"
