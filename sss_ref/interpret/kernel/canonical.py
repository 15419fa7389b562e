"""One module for all lights: a pass whose names all carry the same number is compiled without it.

With several lights, what belongs to a light has its number behind its name (light_distance_2); a shadow map of light 2
and of the only light differ in nothing else. Written with the same names they are the same source, compiled once.
"""

from collections.abc import Callable
from dataclasses import replace

from sss_ref.interpret.work import Work
from sss_ref.language.names import Name
from sss_ref.language.pipeline import Pass


def canonical_work(work: Work) -> Work:
    """The same work, and the same arrays, under the canonical names of its pass."""
    rename = canonical_names(work.this_pass)
    reads = work.this_pass.reads
    return replace(
        work,
        this_pass=renamed(work.this_pass, rename),
        uniforms={rename(name): work.uniforms[name] for name in reads if name not in work.buffers},
        buffers={rename(name): work.buffers[name] for name in reads if name in work.buffers},
        outputs={rename(name): buffer for name, buffer in work.outputs.items()},
        backgrounds={rename(name): value for name, value in work.backgrounds.items()},
    )


def canonical_names(this_pass: Pass) -> Callable[[str], str]:
    """The renaming that drops the number of a pass's names if all have the same one and none is taken without it."""
    names = {text: Name.of(text) for text in (this_pass.name, *this_pass.reads, *this_pass.values)}
    numbers = {name.light for name in names.values()} - {0}
    if len(numbers) != 1 or any(name.light and str(name.of_light(0)) in names for name in names.values()):
        return lambda text: text
    (shared,) = numbers
    return lambda text: str(Name.of(text).of_light(0)) if Name.of(text).light == shared else text


def renamed(this_pass: Pass, rename: Callable[[str], str]) -> Pass:
    """The pass with every name that its source mentions replaced."""
    return replace(this_pass.renamed(rename), name=rename(this_pass.name))
