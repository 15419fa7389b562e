"""Draws a bundle with nothing but its files: what somebody would write who ports the scene to another renderer."""

import json

import numpy as np

DTYPES = {"R32F": (1, "f4"), "RG32F": (2, "f4"), "RGB32F": (4, "f4"), "R32I": (1, "i4"), "R8UI": (1, "u1")}
CHANNELS = {"R32F": 1, "RG32F": 2, "RGB32F": 3, "R32I": 1, "R8UI": 1}


class Player:
    def __init__(self, context, folder):
        self.context, self.folder = context, folder
        self.passes = json.loads((folder / "passes.json").read_text())
        self.uniforms = json.loads((folder / "uniforms.json").read_text())
        self.mesh = {path.stem: np.load(path) for path in (folder / "mesh").glob("*.npy")}
        self.textures = {
            name: self.picture(np.load(folder / one["file"])) for name, one in self.uniforms.items() if "file" in one
        }

    def picture(self, data):
        if data.ndim < 3:  # a long array
            width = self.passes["array_width"]
            rows = -(-len(data) // width)
            padded = np.zeros((rows * width, *data.shape[1:]), data.dtype)
            padded[: len(data)] = data
            data = padded.reshape(rows, width, *data.shape[1:])
        channels = 1 if data.ndim == 2 else data.shape[2]
        return self.texture((data.shape[1], data.shape[0]), channels, {"f": "f4", "i": "i4"}[data.dtype.kind], data)

    def texture(self, size, channels, dtype, data):
        made = self.context.texture(size, channels, np.ascontiguousarray(data).tobytes(), alignment=1, dtype=dtype)
        made.filter = (self.context.NEAREST, self.context.NEAREST)
        return made

    def play(self):
        for one in self.passes["passes"]:
            if not one["only_on_demand"]:
                self.run(one)
        return {
            target["buffer"]: self.read(target)
            for one in self.passes["passes"]
            for draw in one["draws"]
            for target in draw["targets"]
            if target["buffer"] in self.textures
        }

    def run(self, one):
        outputs = {own: self.textures[name] for name, own in one["feedback"].items()}
        for _ in range(one["rounds"]):
            there = self.textures | {name: outputs[own] for name, own in one["feedback"].items()}
            outputs = {}
            for draw in one["draws"]:
                outputs |= self.draw(one, draw, there)
        self.textures |= outputs

    def draw(self, one, draw, there):
        size = one["width"], one["height"]
        targets = {target["buffer"]: self.target(size, target) for target in draw["targets"]}
        program = self.context.program(
            vertex_shader=(self.folder / one["vertex_shader"]).read_text(),
            fragment_shader=(self.folder / draw["fragment_shader"]).read_text(),
        )
        self.bind(program, there)
        if one["draw"]["kind"] == "mesh":
            depth = self.context.depth_texture(size)
            self.context.framebuffer([], depth).clear(depth=1.0)
            self.context.framebuffer([*targets.values()], depth).use()
            self.context.enable_only(self.context.DEPTH_TEST)
            self.context.depth_func = {"less": "<", "less or equal": "<="}[one["draw"]["depth_test"]]
            content = [
                (self.context.buffer(self.mesh[name].tobytes()), f"{self.mesh[name].shape[1]}f", name)
                for name in ("position", "normal", "uv", "tangent")
                if name in program
            ]
            indices = self.context.buffer(self.mesh["triangles"].tobytes())
            self.context.vertex_array(program, content, indices, 4).render(self.context.TRIANGLES)
        else:
            self.context.framebuffer([*targets.values()]).use()
            self.context.enable_only(self.context.NOTHING)
            self.context.vertex_array(program, []).render(self.context.TRIANGLE_STRIP, vertices=4)
        return targets

    def target(self, size, target):
        channels, dtype = DTYPES[target["format"]]
        data = np.zeros((size[1], size[0], channels), dtype)
        data[..., : len(target["clear"])] = target["clear"]
        return self.texture(size, channels, dtype, data)

    def bind(self, program, there):
        unit = 0
        for name in program:
            member = program[name]
            if type(member).__name__ != "Uniform":
                continue
            if name in there:
                there[name].use(unit)
                member.value = unit
                unit += 1
            else:
                given = self.uniforms[name]
                value = np.array(given["value"], np.int32 if given["type"] == "int" else np.float32)
                member.write(np.ascontiguousarray(value.T if given["type"].startswith("mat") else value).tobytes())

    def read(self, target):
        texture, (stored, dtype) = self.textures[target["buffer"]], DTYPES[target["format"]]
        data = np.frombuffer(texture.read(alignment=1), dtype).reshape(texture.height, texture.width, stored)
        count = CHANNELS[target["format"]]
        return data[..., 0] if count == 1 else data[..., :count]
