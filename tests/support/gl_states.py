"""OpenGL with a state that the draw of a mesh should not have: what forgotten switches of a driver draw."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from unittest.mock import patch

from sss_ref.gl.canvas import Canvas

State = Callable[[object, object], None]  # of the context and the framebuffer that is drawn into


def scissored(context, target):
    width, height = target.size
    target.scissor = width // 4, height // 4, width // 2, height // 2


def blended(first, second, equation="FUNC_ADD"):
    def state(context, target):
        context.enable(context.BLEND)
        context.blend_func = getattr(context, first), getattr(context, second)
        context.blend_equation = getattr(context, equation)

    return state


def culled(face, front="ccw"):
    def state(context, target):
        context.enable(context.CULL_FACE)
        context.cull_face, context.front_face = face, front

    return state


def compared(func):
    def state(context, target):
        context.depth_func = func

    return state


def masked(*channels):
    def state(context, target):
        target.color_mask = [channels] * len(target.color_attachments)

    return state


def seen_through(change):
    """A viewport, made from the size of the target."""

    def state(context, target):
        target.viewport = change(*target.size)

    return state


def without_depth_test(context, target):
    context.disable(context.DEPTH_TEST)


def cleared_near(context, target):
    """The depths are cleared to half the way, so what is farther is not drawn."""
    was = target.color_mask
    target.color_mask = [(False,) * 4] * len(target.color_attachments)
    context.framebuffer([], target.depth_attachment).clear(depth=0.8)
    target.use()
    target.color_mask = was


def as_lines(context, target):
    context.wireframe = True


STATES: dict[str, State] = {
    "a scissor left on": scissored,
    "front faces culled": culled("front"),
    "clockwise is the front, backs culled": culled("back", "cw"),
    "no depth test": without_depth_test,
    "depth test always": compared("1"),
    "depth test greater": compared(">"),
    "red is masked": masked(False, True, True, True),
    "blue is masked": masked(True, True, False, True),
    "added to what is there": blended("ONE", "ONE"),
    "multiplied with what is there": blended("DST_COLOR", "ZERO"),
    "subtracted from what is there": blended("ONE", "ONE", "FUNC_REVERSE_SUBTRACT"),
    "depths cleared to 0.8": cleared_near,
    "lines instead of faces": as_lines,
    "viewport half as large": seen_through(lambda w, h: (0, 0, w // 2, h // 2)),
    "viewport a pixel too far right": seen_through(lambda w, h: (1, 0, w, h)),
    "viewport two pixels too far up": seen_through(lambda w, h: (0, 2, w, h)),
    "viewport twice as large": seen_through(lambda w, h: (0, 0, 2 * w, 2 * h)),
    "viewport of another shape": seen_through(lambda w, h: (0, 0, w, h // 2)),
}


@contextmanager
def left(state: State) -> Iterator[None]:
    """While this runs, meshes are drawn in such a state."""

    def triangles(canvas, vertices, targets, later_wins):
        colors = [*targets]
        depth = canvas.context.depth_texture(colors[0].size)
        canvas.context.framebuffer([], depth).clear(depth=1.0)
        target = canvas.context.framebuffer(colors, depth)
        target.use()
        canvas.context.enable_only(canvas.context.DEPTH_TEST)
        canvas.context.depth_func = "<=" if later_wins else "<"
        state(canvas.context, target)
        vertices.render(canvas.context.TRIANGLES)

    with patch.object(Canvas, "triangles", triangles):
        yield
