"""The limits that the rules tell, and where the package has them."""

import re
from importlib import import_module
from pathlib import Path

RULES = Path(__file__).parents[2] / "docs" / "rules.md"
PLACES = {
    "scene_file": [
        ("a picture or map", "quantities.LARGEST_SIZE"),
        ("all buffers and pictures at one time", "quantities.MEMORY_LIMIT"),
        ("`lights`", "settings.MOST_LIGHTS"),
        ("`mesh.normal_strength`", "quantities.STRONGEST"),
        ("`output.exposure`", "quantities.MOST_STOPS"),
        ("`diffusion.taps`", "diffusion.MOST_TAPS"),
        ("`translucency.gaussians`", "scattering.LONGEST_PROFILE"),
    ],
    "errors": [("a scene, mapping, profile or manifest", "text_file.BYTE_LIMIT")],
    "mesh": [
        ("a mesh with all files that it names", "untrusted.BYTE_LIMIT"),
        ("a mesh file in text", "untrusted.TEXT_LIMIT"),
        ("vertices, and faces", "untrusted.ELEMENT_LIMIT"),
        ("a PLY file's header", "ply_header.HEADER_LIMIT"),
        ("a glTF file's nodes", "gltf.hierarchy.NODE_LIMIT"),
        ("a glTF file's elements, at every place where they are drawn", "gltf.accessors.BUDGET"),
        ("a glTF file's primitives, over all nodes and copies", "gltf.gltf_reader.PART_LIMIT"),
        ("an unwrapping", "unwrap.TIME_LIMIT"),
    ],
    "dump": [("a file's name in a mapping", "mapping.LONGEST_NAME")],
    "capture": [("the replay of a capture", "renderdoc_file.SECONDS")],
    "batch": [
        ("a key's values in a sweep", "draws.MOST"),
        ("the lights of a light stage", "light_stage.MOST"),
        ("the frames of a turntable", "turntable.MOST_FRAMES"),
    ],
    "viewer": [
        ("a file dropped on the viewer", "dropped.SIZE_LIMIT"),
        ("files dropped on the viewer", "dropped.MOST_FILES"),
        ("a message to the viewer", "server.LONGEST_MESSAGE"),
    ],
    "course": [("an exercise, when a class is graded", "grading.SECONDS")],
}


def told() -> dict[str, float]:
    """What the table of the rules says, row by row."""
    section = RULES.read_text(encoding="utf-8").partition("## Limits")[2]
    return {name: float(number) for name, number in re.findall(r"^\| (.+?) \| (\d+)", section, re.MULTILINE)}


def of_a_room(room: str) -> tuple[dict[str, float], dict[str, float]]:
    """The limits of a room as the rules have them, and as the package does."""
    rules = told()
    package = {name: _value(f"sss_ref.{room}.{place}") for name, place in PLACES[room]}
    return {name: rules[name] for name in package}, package


def _value(place: str) -> float:
    module, _, name = place.rpartition(".")
    return getattr(import_module(module), name)
