"""Draws a WGSL bundle with nothing but its files, by wgpu: what somebody would write who ports it to WebGPU."""

import json
import struct

import numpy as np
import wgpu

CHANNELS = {
    "r32float": (1, "f4"),
    "rg32float": (2, "f4"),
    "rgba32float": (4, "f4"),
    "r32sint": (1, "i4"),
    "r8uint": (1, "u1"),
}
SAMPLES = {"f4": "unfilterable-float", "i4": "sint", "u1": "uint"}
USAGE = wgpu.TextureUsage.TEXTURE_BINDING | wgpu.TextureUsage.COPY_DST | wgpu.TextureUsage.COPY_SRC
SEEN = wgpu.ShaderStage.VERTEX | wgpu.ShaderStage.FRAGMENT


class WebGpuPlayer:
    def __init__(self, device, folder):
        self.device, self.folder = device, folder
        self.passes = json.loads((folder / "passes.json").read_text())
        self.uniforms = json.loads((folder / "uniforms.json").read_text())
        self.textures, self.formats = {}, {}
        for name, one in self.uniforms.items():
            if "file" in one:
                self.upload(name, np.load(folder / one["file"]), "of vec" in one["type"])

    def upload(self, name, data, vectors):
        if data.ndim < (3 if vectors else 2) or (vectors and data.ndim == 2):  # an array, not a picture
            width = self.passes["array_width"]
            padded = np.zeros((-(-len(data) // width) * width, *data.shape[1:]), data.dtype)
            padded[: len(data)] = data
            data = padded.reshape(-1, width, *data.shape[1:])
        data = data if data.ndim == 3 else data[..., None]
        if data.shape[2] == 3:
            data = np.concatenate([data, data[..., :1]], axis=-1)
        height, width, channels = data.shape
        kind = {"f": "f4", "i": "i4"}[data.dtype.kind]
        (self.formats[name],) = [key for key, value in CHANNELS.items() if value == (channels, kind)]
        texture = self.device.create_texture(size=(width, height, 1), format=self.formats[name], usage=USAGE)
        layout = {"bytes_per_row": width * channels * 4, "rows_per_image": height}
        self.device.queue.write_texture({"texture": texture}, np.ascontiguousarray(data), layout, (width, height, 1))
        self.textures[name] = texture

    def play(self):
        drawn = {}
        for one in self.passes["passes"]:
            if not one["only_on_demand"]:
                written = {own: self.textures[name] for name, own in one["feedback"].items()}
                for _ in range(one["rounds"]):
                    there = self.textures | {name: written[own] for name, own in one["feedback"].items()}
                    written = {}
                    for draw in one["draws"]:
                        written |= self.draw(one, draw, there)
                self.textures |= written
                drawn |= {name: self.read(name, texture) for name, texture in written.items()}
        return drawn

    def draw(self, one, draw, there):
        size = one["width"], one["height"]
        targets = {target["buffer"]: self.target(size, target) for target in draw["targets"]}
        mesh = one["draw"]["kind"] == "mesh"
        both = [given for given in (one["resources"], draw["resources"]) if given["constants"] or given["textures"]]
        entries = {given["group"]: self.entries(given, there) for given in both}
        layouts = [
            self.device.create_bind_group_layout(entries=[layout for layout, _ in entries.get(group, [])])
            for group in range(2)
        ]
        pipeline = self.device.create_render_pipeline(
            layout=self.device.create_pipeline_layout(bind_group_layouts=layouts),
            vertex={"module": self.module(one["vertex_shader"]), "buffers": self.buffers(one) if mesh else []},
            primitive={"topology": "triangle-list" if mesh else "triangle-strip"},
            depth_stencil=self.depth_test(one) if mesh else None,
            fragment={
                "module": self.module(draw["fragment_shader"]),
                "targets": [{"format": target["format"]} for target in draw["targets"]],
            },
        )
        encoder = self.device.create_command_encoder()
        attachments = [
            {"view": targets[target["buffer"]].create_view(), "load_op": "clear", "store_op": "store"}
            | {"clear_value": (target["clear"] * 4)[:4]}
            for target in draw["targets"]
        ]
        depth = {"depth_stencil_attachment": self.depth(size)} if mesh else {}
        drawing = encoder.begin_render_pass(color_attachments=attachments, **depth)
        drawing.set_pipeline(pipeline)
        for group, given in entries.items():
            bound = self.device.create_bind_group(layout=layouts[group], entries=[entry for _, entry in given])
            drawing.set_bind_group(group, bound)
        for slot, name in enumerate(one["attributes"] if mesh else []):
            drawing.set_vertex_buffer(slot, self.corners(name))
        drawing.draw(3 * len(self.triangles) if mesh else 4)
        drawing.end()
        self.device.queue.submit([encoder.finish()])
        return targets

    def module(self, file):
        return self.device.create_shader_module(code=(self.folder / file).read_text())

    @property
    def triangles(self):
        return np.load(self.folder / "mesh" / "triangles.npy")

    def corners(self, name):
        data = np.load(self.folder / "mesh" / f"{name}.npy")[self.triangles.ravel()]
        return self.device.create_buffer_with_data(data=data, usage=wgpu.BufferUsage.VERTEX)

    def buffers(self, one):
        counts = [np.load(self.folder / "mesh" / f"{name}.npy").shape[1] for name in one["attributes"]]
        return [
            {
                "array_stride": 4 * count,
                "step_mode": "vertex",
                "attributes": [{"format": f"float32x{count}", "offset": 0, "shader_location": location}],
            }
            for location, count in enumerate(counts)
        ]

    def depth_test(self, one):
        compare = {"less": "less", "less or equal": "less-equal"}[one["draw"]["depth_test"]]
        return {"format": "depth32float", "depth_write_enabled": True, "depth_compare": compare}

    def depth(self, size):
        usage = wgpu.TextureUsage.RENDER_ATTACHMENT
        view = self.device.create_texture(size=(*size, 1), format="depth32float", usage=usage).create_view()
        return {"view": view, "depth_load_op": "clear", "depth_store_op": "discard", "depth_clear_value": 1.0}

    def target(self, size, target):
        self.formats[target["buffer"]] = target["format"]
        usage = USAGE | wgpu.TextureUsage.RENDER_ATTACHMENT
        return self.device.create_texture(size=(*size, 1), format=target["format"], usage=usage)

    def entries(self, given, there):
        found = []
        if given["constants"]:
            buffer = {"buffer": self.constants(given["constants"])}
            layout = {"binding": given["constants"]["binding"], "visibility": SEEN, "buffer": {"type": "uniform"}}
            found.append((layout, {"binding": given["constants"]["binding"], "resource": buffer}))
        for name, binding in given["textures"].items():
            sampled = {"sample_type": SAMPLES[CHANNELS[self.formats[name]][1]]}
            layout = {"binding": binding, "visibility": SEEN, "texture": sampled}
            found.append((layout, {"binding": binding, "resource": there[name].create_view()}))
        return found

    def constants(self, constants):
        data = bytearray(constants["bytes"])
        for name, offset in constants["offsets"].items():
            value = np.array(self.uniforms[name]["value"])
            lines = value.T if value.ndim == 2 else [np.atleast_1d(value)]
            letter = "i" if self.uniforms[name]["type"] == "int" else "f"
            for number, line in enumerate(lines):
                struct.pack_into(f"<{len(line)}{letter}", data, offset + 16 * number, *line.tolist())
        return self.device.create_buffer_with_data(data=data, usage=wgpu.BufferUsage.UNIFORM)

    def read(self, name, texture):
        channels, kind = CHANNELS[self.formats[name]]
        width, height, _ = texture.size
        row = width * channels * np.dtype(kind).itemsize
        wide = -(-row // 256) * 256
        layout = {"bytes_per_row": wide, "rows_per_image": height}
        data = np.frombuffer(self.device.queue.read_texture({"texture": texture}, layout, texture.size), np.uint8)
        return data.reshape(height, wide)[:, :row].copy().view(kind).reshape(height, width, channels)
