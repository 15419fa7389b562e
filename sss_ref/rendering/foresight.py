"""The mesh made ready for a pass while the one before it is drawn: one thread does that, the others draw."""

from collections.abc import Iterable
from concurrent.futures import Future

from sss_ref.language.pipeline import Pass
from sss_ref.rendering.draw import Machine, ReadyMesh, made_ready
from sss_ref.scene.scene import Scene


class Foresight:
    """The passes of a rendering in order, of which the next that draws the mesh is always begun.

    Not begun, but made ready in their own turn, are the first, those whose vertices read a buffer, and all where one
    thread does the work.
    """

    def __init__(self, scene: Scene, passes: Iterable[Pass], machine: Machine) -> None:
        self.scene, self.machine = scene, machine
        self.to_begin = [
            each for each in passes if each.draw.vertex_stages and each.draw.reads.keys() <= scene.uniforms.keys()
        ]
        self.begun: dict[str, Future[ReadyMesh]] = {}

    def mesh(self, this_pass: Pass) -> ReadyMesh | None:
        """That of a pass if it was begun, whose turn it is now; the next is begun meanwhile."""
        begun = self.begun.pop(this_pass.name, None)
        self.to_begin = [each for each in self.to_begin if each is not this_pass]
        self.begin()
        return begun.result() if begun else None

    def begin(self) -> None:
        """Let another thread begin the next."""
        if self.machine.pool and self.to_begin and not self.begun:
            after = self.to_begin[0]
            self.begun[after.name] = self.machine.pool.submit(made_ready, self.scene, after, {}, self.machine)
