"""Valid records, notebooks, witnesses, results, masks, nameless pictures and shaders, before anything is changed."""

import json

import numpy as np
from fuzzed_readers import dumped_scene
from valid_file import Valid, made, picture

HEIGHT, WIDTH = 32, 48  # of saved_scene.SCENE

GLTF_MATERIAL = {
    "name": "skin",
    "extensions": {
        "KHR_materials_scatter": {"multiscatterColor": [0.7, 0.4, 0.3], "scatterAnisotropy": 0.1},
        "KHR_materials_volume": {"attenuationColor": [0.9, 0.5, 0.4], "attenuationDistance": 0.002},
        "KHR_materials_ior": {"ior": 1.4},
    },
}
OPENPBR_MATERIAL = {
    "subsurface_color": [0.7, 0.4, 0.3],
    "subsurface_radius": 1.5,
    "subsurface_radius_scale": [1.0, 0.5, 0.25],
    "subsurface_scatter_anisotropy": 0.2,
    "specular_ior": 1.45,
}
NOTEBOOK = {
    "cells": [
        {"cell_type": "markdown", "metadata": {}, "source": ["# A lesson\n"]},
        {"cell_type": "code", "metadata": {}, "source": ["x = 1\n", "x + 1"], "outputs": [], "execution_count": None},
    ],
    "metadata": {},
    "nbformat": 4,
    "nbformat_minor": 5,
}
SHADER = """#version 430
// phong alone
layout(location = 0) out vec3 out_phong;
layout(location = 1) out vec3 out_albedo;
uniform float shininess;
void main() { out_phong = vec3(shininess); out_albedo = vec3(1.0); }
"""
WGSL_SHADER = """// phong alone
struct Outputs { @location(0) out_phong: vec3f, @location(1) out_albedo: vec3f }
@fragment fn main() -> Outputs { return Outputs(vec3f(1.0), vec3f(0.5)); }
"""


def valid_records():
    """All of them, in an order that never changes."""
    return (*_materials(), *_kept(), *_judged(), *_course(), *_shaders())


def _materials():
    for name, content in (("gltf", GLTF_MATERIAL), ("openpbr", OPENPBR_MATERIAL)):
        yield Valid("material", name, {"a.json": json.dumps(content).encode()})


def _kept():
    """What a walk, a tracing and a batch go on from."""
    from fuzzed_record_readers import SWEEP, tracing, walk

    from sss_ref.batch.batch_folder import BatchRecord
    from sss_ref.batch.item_folder import ItemRecord
    from sss_ref.truth.radiance import nothing_gathered
    from sss_ref.truth.tally import nothing_walked

    yield Valid("tally", "tally", {"a.json": made(lambda path, each: each.save(path), "a", nothing_walked(walk()))})
    sums = nothing_gathered(tracing())
    yield Valid("sums", "sums", {"sums.npz": made(lambda path, each: each.save(path), "sums.npz", sums)})
    batch = BatchRecord(outputs=sorted(SWEEP.outputs), keep=sorted(SWEEP.keep))
    yield Valid("batch", "batch", {"batch.json": batch.model_dump_json(exclude_none=True).encode()})
    settings = dumped_scene().settings.model_dump(mode="json")
    item = ItemRecord(
        package_version="0", rules_version=2, settings=settings, inputs={"positions": "0" * 64}, buffers={}, seconds=1.5
    )
    yield Valid("item", "item", {"item.json": item.model_dump_json().encode()})


def _judged():
    """What judging reads beside a dump: the record of a wrong pixel, masks, results to compare, nameless pictures."""
    yield Valid("witness", "witness", {"a.json": _witness().encode()})
    rng = np.random.default_rng(9)
    chosen = rng.integers(0, 2, (HEIGHT, WIDTH), np.uint8)
    yield Valid("mask", "png", {"a.png": picture(WIDTH, HEIGHT, 1)})
    yield Valid("mask", "npy", {"a.npy": made(np.save, "a.npy", chosen)})
    points = rng.random((6, 8, 3), np.float32)
    buffers = {"lit.npy": made(np.save, "a.npy", points), "triangle.npy": made(np.save, "a.npy", chosen.astype("i4"))}
    yield Valid("results", "npy", {f"{side}/{name}": data for side in "ab" for name, data in buffers.items()})
    pictures = {"x.png": picture(WIDTH, HEIGHT, 3), "y.npy": made(np.save, "a.npy", points)}
    yield Valid("pictures", "png and npy", {**pictures, "z.pfm": b"PF\n8 6\n-1.0\n" + points.tobytes()})


def _witness():
    """The record of a wrong pixel of `phong`."""
    from wrong_pixels import witness_of

    from sss_ref.validation.witness.recording import recorded

    return recorded(witness_of("phong")).model_dump_json(exclude_defaults=True)


def _course():
    yield Valid("notebook", "notebook", {"a.ipynb": json.dumps(NOTEBOOK).encode()})
    yield Valid("course", "record", {".sss_ref_course.json": json.dumps({"START.ipynb": "0" * 64}).encode()})


def _shaders():
    yield Valid("shader", "glsl", {"camera.frag": SHADER.encode()})
    yield Valid("shader", "wgsl", {"camera.frag": WGSL_SHADER.encode()})
