"""What `sss-ref blame` prints and whose drawing it looks into; who is to blame has tests of its own."""

from types import SimpleNamespace

import pytest

from sss_ref.blame.blaming import NOBODY
from sss_ref.cli import blame_command, main


@pytest.mark.parametrize(("whose", "code"), [(NOBODY, 0), ("the [compiler]", 1)])
@pytest.mark.parametrize("is_dumped", [False, True])
def test_the_reasons_come_first_and_whose_fault_it_is_last(whose, code, is_dumped, tmp_path, monkeypatch, capsys):
    seen = []

    def suspicion(scene, drawing, files, stacks, profile, ours):
        seen.append((drawing, files, stacks, profile, ours))
        return SimpleNamespace(blame=lambda: SimpleNamespace(because=["[red] is", "wrong"], whose=whose))

    monkeypatch.setattr("sss_ref.scene.load.load_scene", lambda name: SimpleNamespace(settings=name))
    monkeypatch.setattr(blame_command, "shaders_of", lambda folder, settings: folder.name)
    monkeypatch.setattr("sss_ref.blame.blaming.Suspicion", suspicion)
    monkeypatch.setattr("sss_ref.blame.stacks.language_of", lambda files: "glsl")
    monkeypatch.setattr("sss_ref.blame.stacks.stacks_here", lambda language: [f"{language} stack"])
    monkeypatch.setattr("sss_ref.gl.draw", lambda scene, files, keep: f"{files} drawn")
    monkeypatch.setattr("sss_ref.gl.device_name", lambda: "a device")
    monkeypatch.setattr("sss_ref.dump.read.read_dump", lambda dump, scene: dump.name)
    drawing = SimpleNamespace(read=lambda dump: f"{dump} read")
    monkeypatch.setattr("sss_ref.validation.accept.dumped.Drawing", drawing)
    if not is_dumped:
        monkeypatch.setattr(
            "sss_ref.validation.accept.dumped.Drawing", lambda buffers, device: f"{buffers} by {device}"
        )
    words = ["--dump", str(tmp_path / "dump"), "--profile", "gl"] if is_dumped else []
    assert main(["blame", "wedge", str(tmp_path / "shaders"), *words]) == code
    assert capsys.readouterr().out == f"[red] is\nwrong\nwhose fault: {whose}\n"
    if is_dumped:
        assert seen == [("dump read", "shaders", ["glsl stack"], "gl", False)]
    else:
        assert seen == [("shaders drawn by a device", "shaders", ["glsl stack"], "vulkan", True)]
