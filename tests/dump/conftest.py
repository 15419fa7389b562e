"""The fixtures of these tests."""

from saved_scene import result, saved, scene_file  # noqa: F401
