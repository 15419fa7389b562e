"""Replays a capture by RenderDoc's own Python module: a script for a Python that has it, which needs nothing of ours.

`python replay.py CAPTURE.rdc FOLDER` writes every picture that a run of draws left behind into the folder, and
pictures.json, which says of each what is known of it; or, of a capture that cannot be replayed, why.
"""

import json
import os
import sys
from collections.abc import Iterator
from typing import Any

DEPTH = "depth"
ANEW = ("Clear", "Don't Care")  # how a render pass may begin
ATTACHING = ("glBindFramebuffer", "glFramebufferTexture", "glNamedFramebufferTexture")  # how such calls begin


def main(capture: str, folder: str) -> None:
    """Replay a capture and write what it drew."""
    import renderdoc as rd

    rd.InitialiseReplay(rd.GlobalEnvironment(), [])
    file = rd.OpenCaptureFile()
    opened = file.OpenFile(capture, "", None)
    told: dict[str, Any] = {"error": "" if opened.OK() else opened.code.name, "version": rd.GetVersionString()}
    if opened.OK():
        replayed, controller = file.OpenCapture(rd.ReplayOptions(), None)
        told["error"] = "" if replayed.OK() else replayed.code.name
        if replayed.OK():
            told |= {"driver": file.DriverName(), "pictures": list(Replay(rd, controller, folder).pictures())}
            controller.Shutdown()
    file.Shutdown()
    rd.ShutdownReplay()
    with open(os.path.join(folder, "pictures.json"), "w", encoding="utf-8") as report:
        json.dump(told, report)


class Replay:
    """A capture that is being replayed. rd: the module. controller: of the replay."""

    def __init__(self, rd: Any, controller: Any, folder: str) -> None:
        self.rd, self.controller, self.folder = rd, controller, folder
        self.textures = {texture.resourceId: texture for texture in controller.GetTextures()}
        self.names = {resource.resourceId: resource.name for resource in controller.GetResources()}

    def pictures(self) -> Iterator[dict[str, Any]]:
        """What each run of draws left in its targets."""
        for action, groups in self.last_of_runs():
            self.controller.SetFrameEvent(action.eventId, True)
            state = self.controller.GetPipelineState()
            colors = [(f"{number}", target) for number, target in enumerate(state.GetOutputTargets())]
            for number, target in (*colors, (DEPTH, state.GetDepthTarget())):
                if target.resourceId in self.textures:
                    yield self.picture(action, groups, number, target)

    def last_of_runs(self) -> Iterator[tuple[Any, list[str]]]:
        """The last of all draws one after the other into the same targets, with the debug groups around it.

        What clears the targets, or may, stands between: a clear, or in Vulkan the begin of a render pass. Layers of one
        texture are targets of their own.
        """
        before: tuple[Any, list[str]] | None = None
        for action, groups in self.actions(self.controller.GetRootActions(), []):
            if before and (self.targets(before[0]) != self.targets(action) or self.is_elsewhere(before[0], action)):
                yield before
            before = (action, groups) if action.flags & self.rd.ActionFlags.Drawcall else None
        if before:
            yield before

    def actions(self, actions: Any, groups: list[str]) -> Iterator[tuple[Any, list[str]]]:
        """All draws and clears in order."""
        wanted = self.rd.ActionFlags.Drawcall | self.rd.ActionFlags.Clear
        for action in actions:
            if action.flags & wanted or self.begins_anew(action):
                yield action, groups
            yield from self.actions(action.children, [*groups, self.named(action)])

    def begins_anew(self, action: Any) -> bool:
        """Whether a render pass begins that does not load what its targets hold: "vkCmdBeginRenderPass(C=Clear)"."""
        is_begin = action.flags & self.rd.ActionFlags.BeginPass
        return bool(is_begin) and any(word in self.named(action) for word in ANEW)

    def named(self, action: Any) -> str:
        """What a list of all actions calls it."""
        return str(action.GetName(self.controller.GetStructuredFile()))

    def targets(self, action: Any) -> tuple[Any, ...]:
        """What a draw draws into; a clear is none."""
        is_draw = action.flags & self.rd.ActionFlags.Drawcall
        return (*map(str, action.outputs), str(action.depthOut)) if is_draw else ()

    def is_elsewhere(self, before: Any, action: Any) -> bool:
        """Whether a draw is into other layers or mips than one before it; in OpenGL a call in between must say so."""
        chunks = self.controller.GetStructuredFile().chunks
        calls = [chunks[each.chunkIndex].name for each in action.events]
        return any(call.startswith(ATTACHING) for call in calls) and self.parts(before) != self.parts(action)

    def parts(self, action: Any) -> list[tuple[int, int]]:
        """The mip and the layer of each target of a draw."""
        self.controller.SetFrameEvent(action.eventId, True)
        state = self.controller.GetPipelineState()
        return [(each.firstMip, each.firstSlice) for each in (*state.GetOutputTargets(), state.GetDepthTarget())]

    def picture(self, action: Any, groups: list[str], number: str, target: Any) -> dict[str, Any]:
        """Write one picture; what is known of it."""
        texture = self.textures[target.resourceId]
        known = {
            "event": action.eventId,
            "target": number,
            "draw": self.named(action),
            "groups": groups,
            "api": self.rd.GraphicsAPI(self.controller.GetAPIProperties().pipelineType).name,
            "name": self.names[target.resourceId],
            "format": texture.format.Name(),
            "size": [max(texture.width >> target.firstMip, 1), max(texture.height >> target.firstMip, 1)],
            "samples": texture.msSamp,
        }
        return known if texture.msSamp > 1 else known | self.written(f"{action.eventId:05}_{number}", target)

    def written(self, stem: str, target: Any) -> dict[str, Any]:
        """Write a texture as DDS, or byte by byte where DDS has no such format."""
        save = self.rd.TextureSave()
        save.resourceId, save.mip, save.slice.sliceIndex = target.resourceId, target.firstMip, target.firstSlice
        save.destType, save.alpha = self.rd.FileType.DDS, self.rd.AlphaMapping.Preserve
        path = os.path.join(self.folder, f"{stem}.dds")
        if self.controller.SaveTexture(save, path).OK():
            return {"file": f"{stem}.dds"}
        os.remove(path)
        place = self.rd.Subresource(target.firstMip, target.firstSlice, 0)
        with open(os.path.join(self.folder, f"{stem}.bytes"), "wb") as file:
            file.write(self.controller.GetTextureData(target.resourceId, place))
        return {"file": f"{stem}.bytes"}


if __name__ == "__main__":
    main(*sys.argv[1:])
