"""What a replay writes of a capture, where a few lines stand in for RenderDoc's module: actions, textures, files."""

import json
import runpy
import sys
from enum import Enum, IntFlag
from types import SimpleNamespace

import pytest

from sss_ref.capture import replay

NOTHING = SimpleNamespace(resourceId="none", firstMip=0, firstSlice=0)
CALLS = ["glDrawArrays", "glBindFramebuffer", "glNamedFramebufferTextureLayerEXT", "vkCmdDraw"]
FILE = SimpleNamespace(name="file", chunks=[SimpleNamespace(name=call) for call in CALLS])


class Flags(IntFlag):
    """Those that are asked for, and another one."""

    Clear = 1
    Drawcall = 2
    BeginPass = 4
    PushMarker = 8


class Api(Enum):
    """By the numbers that a controller gives."""

    OpenGL = 2
    Vulkan = 3


def target(name, mip=0, part=0):
    return SimpleNamespace(resourceId=name, firstMip=mip, firstSlice=part)


class Controller:
    """Replays a list of actions: what it saves tells which mip and slice of which texture was asked for, and when."""

    def __init__(self, roots, textures):
        self.roots, self.textures = roots, textures
        self.event, self.closed = None, False

    def GetTextures(self):
        return [SimpleNamespace(resourceId=name, **facts) for name, facts in self.textures.items()]

    def GetResources(self):
        return [SimpleNamespace(resourceId=name, name=f"named {name}") for name in self.textures]

    def GetRootActions(self):
        return self.roots

    def GetStructuredFile(self):
        return FILE

    def SetFrameEvent(self, event, force):
        assert force is True
        self.event = event

    def GetPipelineState(self):
        action = next(each for each in every(self.roots) if each.eventId == self.event)
        return SimpleNamespace(GetOutputTargets=lambda: action.colors, GetDepthTarget=lambda: action.depth)

    def GetAPIProperties(self):
        return SimpleNamespace(pipelineType=3)

    def SaveTexture(self, save, path):
        assert (save.destType, save.alpha) == ("dds", "preserved")
        with open(path, "w") as file:
            file.write(f"{self.event} {save.resourceId} {save.mip} {save.slice.sliceIndex}")
        return result(self.textures[save.resourceId].get("in_dds", True))

    def GetTextureData(self, name, place):
        return f"{self.event} {name} {place}".encode()

    def Shutdown(self):
        self.closed = True


def every(actions):
    for each in actions:
        yield each
        yield from every(each.children)


def result(good, why="Broken"):
    return SimpleNamespace(OK=lambda: good, code=SimpleNamespace(name=why))


def texture(width=8, height=4, samples=1, **more):
    kind = SimpleNamespace(Name=lambda: "R8G8B8A8_UNORM")
    return {"width": width, "height": height, "msSamp": samples, "format": kind, **more}


def action(event, flags, outputs=(), depth=NOTHING, name=None, children=(), calls=()):
    return SimpleNamespace(
        eventId=event,
        flags=flags,
        outputs=[each.resourceId for each in outputs],
        depthOut=depth.resourceId,
        colors=list(outputs),
        depth=depth,
        children=list(children),
        events=[SimpleNamespace(chunkIndex=CALLS.index(call)) for call in calls],
        GetName=lambda file: name or f"action {event} of {file.name}",
    )


RD = SimpleNamespace(
    ActionFlags=Flags,
    GraphicsAPI=Api,
    FileType=SimpleNamespace(DDS="dds"),
    AlphaMapping=SimpleNamespace(Preserve="preserved"),
    TextureSave=lambda: SimpleNamespace(slice=SimpleNamespace()),
    Subresource=lambda mip, part, sample: f"{mip} {part} {sample}",
)
A, B, DEPTH = target("a"), target("b"), target("z")
TEXTURES = {"a": texture(), "b": texture(), "z": texture()}


def pictures(tmp_path, roots, textures=TEXTURES):
    return list(replay.Replay(RD, Controller(roots, textures), str(tmp_path)).pictures())


def ends(tmp_path, *roots):
    """The events after which pictures are taken."""
    return [each["event"] for each in pictures(tmp_path, roots)]


def test_a_run_of_draws_ends_where_the_targets_change(tmp_path):
    draws = [action(1, Flags.Drawcall, [A]), action(2, Flags.Drawcall, [A]), action(3, Flags.Drawcall, [B])]
    assert ends(tmp_path, *draws) == [2, 3]
    assert ends(tmp_path, draws[0], action(2, Flags.Drawcall, [A], DEPTH)) == [1, 2, 2], "the depth is a target too"
    assert ends(tmp_path) == ends(tmp_path, action(1, Flags.PushMarker)) == []


@pytest.mark.parametrize(
    ("between", "expected"),
    [
        (action(2, Flags.Clear, [A]), [1, 3]),
        (action(2, Flags.BeginPass, name="vkCmdBeginRenderPass(C=Clear)"), [1, 3]),
        (action(2, Flags.BeginPass, name="vkCmdBeginRenderPass(C=Don't Care)"), [1, 3]),
        (action(2, Flags.BeginPass, name="vkCmdBeginRenderPass(C=Load)"), [3]),
        (action(2, Flags.PushMarker, name="Clear"), [3]),
    ],
)
def test_a_run_ends_where_the_targets_are_cleared(tmp_path, between, expected):
    first, last = action(1, Flags.Drawcall, [A]), action(3, Flags.Drawcall, [A])
    assert ends(tmp_path, first, between, last) == expected
    assert ends(tmp_path, first, between) == [1] and ends(tmp_path, between, last) == [3]


@pytest.mark.parametrize(
    ("second", "calls", "expected"),
    [
        (target("a", part=1), CALLS[:2], [1, 2]),
        (target("a", mip=1), [CALLS[2]], [1, 2]),
        (target("a"), CALLS[:3], [2]),
        (target("a", part=1), [CALLS[3]], [2]),
    ],
)
def test_a_run_ends_where_another_layer_is_attached(tmp_path, second, calls, expected):
    """In Vulkan a render pass begins for it."""
    draws = action(1, Flags.Drawcall, [A]), action(2, Flags.Drawcall, [second], calls=calls)
    assert ends(tmp_path, *draws) == expected
    draws = action(1, Flags.Drawcall, depth=A), action(2, Flags.Drawcall, depth=second, calls=calls)
    assert ends(tmp_path, *draws) == expected


def test_draws_have_the_groups_around_them(tmp_path):
    inner = action(3, Flags.PushMarker, name="camera", children=[action(4, Flags.Drawcall, [B])])
    draws = [action(2, Flags.Drawcall | Flags.PushMarker, [A]), inner]
    found = pictures(tmp_path, [action(1, Flags.PushMarker, name="frame", children=draws)])
    assert [(each["event"], each["groups"]) for each in found] == [(2, ["frame"]), (4, ["frame", "camera"])]


def test_what_is_known_of_a_picture(tmp_path):
    """Of a mip the size is halved so often, and at least 1; nothing is told of a target that is no texture."""
    draw = action(7, Flags.Drawcall, [NOTHING, target("a", 2, 5)], target("z", 1))
    color, depth = pictures(tmp_path, [draw], {"a": texture(12, 3), "z": texture(1, 12)})
    assert color == {
        "event": 7,
        "target": "1",
        "draw": "action 7 of file",
        "groups": [],
        "api": "Vulkan",
        "name": "named a",
        "format": "R8G8B8A8_UNORM",
        "size": [3, 1],
        "samples": 1,
        "file": "00007_1.dds",
    }
    assert (tmp_path / "00007_1.dds").read_text() == "7 a 2 5"
    assert (depth["target"], depth["size"], depth["file"]) == ("depth", [1, 6], "00007_depth.dds")


def test_of_several_samples_nothing_is_written(tmp_path):
    textures = {"a": texture(samples=2), "b": texture(samples=1)}
    first, second = pictures(tmp_path, [action(1, Flags.Drawcall, [A, B])], textures)
    assert first["samples"] == 2 and "file" not in first and second["file"] == "00001_1.dds"
    assert [path.name for path in tmp_path.iterdir()] == ["00001_1.dds"]


def test_what_no_dds_file_has_is_written_byte_by_byte(tmp_path):
    (found,) = pictures(tmp_path, [action(1, Flags.Drawcall, [target("a", 3, 4)])], {"a": texture(in_dds=False)})
    assert found["file"] == "00001_0.bytes" and [path.name for path in tmp_path.iterdir()] == ["00001_0.bytes"]
    assert (tmp_path / "00001_0.bytes").read_text() == "1 a 3 4 0"


@pytest.mark.parametrize(
    ("opens", "replays", "expected"),
    [
        (False, True, {"error": "NoFile", "version": "v1"}),
        (True, False, {"error": "NoReplay", "version": "v1"}),
        (True, True, {"error": "", "version": "v1", "driver": "Vulkan"}),
    ],
)
def test_a_report_says_what_was_replayed_or_why_not(tmp_path, monkeypatch, opens, replays, expected):
    """Whatever was opened is closed."""
    controller = Controller([action(1, Flags.Drawcall, [A])], TEXTURES)
    closed = []
    file = SimpleNamespace(
        OpenFile=lambda path, kind, progress: result(opens and path == "frame.rdc", "NoFile"),
        OpenCapture=lambda options, progress: (result(replays, "NoReplay"), controller),
        DriverName=lambda: "Vulkan",
        Shutdown=lambda: closed.append("file"),
    )
    module = SimpleNamespace(
        **vars(RD),
        InitialiseReplay=lambda environment, arguments: None,
        GlobalEnvironment=lambda: None,
        OpenCaptureFile=lambda: file,
        GetVersionString=lambda: "v1",
        ReplayOptions=lambda: None,
        ShutdownReplay=lambda: closed.append("replay"),
    )
    monkeypatch.setitem(sys.modules, "renderdoc", module)
    monkeypatch.setattr(sys, "argv", ["replay.py", "frame.rdc", str(tmp_path)])
    runpy.run_path(replay.__file__, run_name="__main__")
    report = json.loads((tmp_path / "pictures.json").read_text(encoding="utf-8"))
    drawn = report.pop("pictures", [])
    assert report == expected and len(drawn) == controller.closed == (opens and replays)
    assert closed == ["file", "replay"]
