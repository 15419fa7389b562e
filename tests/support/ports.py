"""Ports of ours with one mistake each: a scene drawn pass by pass, with one thing changed on the way."""

from dataclasses import dataclass, replace
from functools import wraps

import numpy as np
from devices import Device, as_it_is

from sss_ref.rendering.fold import shaded


class Count(int):
    """A uniform that is a whole number."""


@dataclass(frozen=True)
class Mistake:
    """One thing that a port does otherwise, in the pass `where` ("" is every pass).

    uniforms: name -> the one in its place, or a function of the right value. reads: name -> the buffer that is read in
    its place. stages: name -> a function in the place of its Python. pieces: as `changed` of a Device. draws: a
    function of the pass. writes: buffer -> function of the right one.
    """

    where: str = ""
    uniforms: dict = ()
    reads: dict = ()
    stages: dict = ()
    pieces: object = as_it_is
    draws: object = None
    writes: dict = ()


class Port(Device):
    """Draws a scene with a mistake."""

    def __init__(self, scene, mistake):
        super().__init__(scene, as_it_is)
        self.right, self.mistake = scene, mistake

    def buffers_of_all(self):
        """Every buffer of the method, as this port draws it."""
        wanted, buffers = set(self.right.method.outputs), {}
        for one in self.right.method.only(wanted).passes:
            mistaken = self.mistake.where in ("", one.name)
            self.scene, self.changed = self.right, as_it_is
            read = dict(buffers)
            if mistaken:
                one, read = self.entered(one, read)
            sketch = self.draw(one, read)
            new = sketch.written | shaded(self.scene, one, sketch, read, wanted, self.machine)
            for name, change in dict(self.mistake.writes if mistaken else ()).items():
                if name in new:
                    new[name] = np.ascontiguousarray(change(new[name]), new[name].dtype)
            buffers |= new
        return {name: buffers[name] for name in self.right.method.outputs}

    def entered(self, one, read):
        """A pass as the mistake has it, and what it reads."""
        change, uniforms = self.mistake, self.right.uniforms
        values = {
            name: rounded(uniforms[new] if isinstance(new, str) else new(uniforms[name]))
            for name, new in dict(change.uniforms).items()
        }
        self.scene = replace(self.right, own_uniforms={**self.right.own_uniforms, **values})
        self.changed = change.pieces
        read |= {name: read[other] for name, other in dict(change.reads).items() if other in read}
        stages = tuple(mistaken(each, dict(change.stages)) for each in one.stages)
        one = replace(one, stages=stages)
        return (change.draws(one) if change.draws else one), read


def mistaken(stage, functions):
    """A stage that runs another function, if there is one of its name."""
    if stage.name not in functions:
        return stage
    function = functions[stage.name]
    return replace(stage, python=wraps(stage.python)(lambda *inputs: function(*inputs)))  # which keeps its own name


def rounded(value):
    """A uniform: a count as it is, else float32."""
    return value if isinstance(value, Count) else np.asarray(value, np.float32)[()]
