"""Scenes: the TOML file and its presets, cameras, lights and meshes. Importing this needs no heavy library."""

from sss_ref.mesh.materials import Material
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.mesh.triangles import Mesh
from sss_ref.mesh.uv_facts import UvFacts, uv_facts
from sss_ref.scene.load import load_scene
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.settings import SceneFile
from sss_ref.scene_file.shipped import mesh_names, mesh_path, scene_names, scene_path
from sss_ref.view.matrices import normal_matrix
from sss_ref.view.views import Light, View

__all__ = [
    "Light",
    "Material",
    "Mesh",
    "Scene",
    "SceneFile",
    "UvFacts",
    "View",
    "load_mesh",
    "load_scene",
    "mesh_names",
    "mesh_path",
    "normal_matrix",
    "scene_names",
    "scene_path",
    "uv_facts",
]
