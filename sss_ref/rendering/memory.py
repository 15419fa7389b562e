"""The memory that a rendering takes, known before any work.

Counted is what is there at one time: while a pass runs, the buffers that it or a later one reads, those that are kept,
those that it writes, and what its rasterizer writes; and the decoded pictures over the mesh.
"""

from collections import Counter
from collections.abc import Iterator

from sss_ref.errors import SceneError
from sss_ref.errors.wording import gibibytes, told
from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.language.pipeline import Method, Pass
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.quantities import MEMORY_LIMIT

PIECE_BYTES = DEPTH_BYTES = 4  # a pixel of a draw of the mesh


def check_memory(scene: Scene, kept: set[str], more_bytes: int = 0) -> None:
    """Raise SceneError, for the table that takes most, if a rendering would need more than MEMORY_LIMIT at one time.

    kept: the buffers that it gives. more_bytes: what its caller needs besides for each pixel of the image.
    """
    pictures = sum(array.nbytes for array in (*scene.albedo.values(), *scene.maps.values()))
    needs = [scene_bytes(scene, each + Counter(camera=more_bytes)) for each in bytes_at_once(scene.method, kept)]
    needed = max(needs, key=Counter.total, default=Counter[str]())
    total = needed.total() + pictures
    if total > MEMORY_LIMIT:
        (table, largest), *_ = needed.most_common(1)
        fewer = " or use fewer lights" if len(scene.lights) > 1 else ""
        final = "" if kept <= {"image", "coverage"} else ', or keep the "final" image alone'
        expected = f"at most {gibibytes(MEMORY_LIMIT)} of buffers and pictures at one time"
        came = f"{gibibytes(total)}, {gibibytes(largest)} of them here"
        remedy = f"make width and height smaller{fewer}{final}"
        raise SceneError(told(f"{scene.source}: {table}", expected, came, remedy))


def scene_bytes(scene: Scene, counted: Counter[str]) -> Counter[str]:
    """Scene table -> bytes, of bytes for each of its pixels."""
    sizes = {each.target: scene.size(each) for each in scene.method.passes}
    return Counter({table: each * sizes[table][0] * sizes[table][1] for table, each in counted.items()})


def bytes_at_once(method: Method, kept: set[str]) -> Iterator[Counter[str]]:
    """Of each pass that must run: scene table -> bytes for each of its pixels, of all that is there while it runs."""
    there: dict[str, tuple[str, int]] = {}
    for this_pass, read_later in method.only(kept).in_order():
        needed = kept | read_later
        written = {
            name: (this_pass.target, CHANNELS[kind] * dtype_of(kind).itemsize)
            for name, kind in this_pass.values.items()
            if name in needed
        }
        counted = Counter[str]({this_pass.target: beside_outputs(this_pass, needed)})
        for table, size in (*there.values(), *written.values()):
            counted[table] += size
        yield counted
        there = {name: buffer for name, buffer in (there | written).items() if name in needed}


def beside_outputs(this_pass: Pass, needed: set[str]) -> int:
    """Bytes for each pixel of what a pass writes and does not hand on.

    needed: what it hands on. Of rounds the second has no more than the first, unless what the first one reads stays.
    """
    if this_pass.rounds > 1:
        stays = [this_pass.fed_back[own] for name, own in this_pass.feedback.items() if name in needed]
        return sum(CHANNELS[kind] * dtype_of(kind).itemsize for kind in stays)
    if not this_pass.draw.vertex_stages:
        return 0
    return PIECE_BYTES + (0 if this_pass.draw.depth in needed else DEPTH_BYTES)
