"""Closed bodies as OBJ files, and scenes that look at them."""

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
FACES = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]  # outwards


def write_box(path, low, high):
    """A box from a corner to the opposite one."""
    lines = [f"v {' '.join(str(high[axis] if at[axis] else low[axis]) for axis in range(3))}" for at in CORNERS]
    path.write_text("\n".join([*lines, *(f"f {' '.join(map(str, face))}" for face in FACES)]) + "\n")
    return path


def looking_down(path, lights, size=4, view_height=1.0, **keys):
    """A scene with an orthographic camera that looks at the world's middle from +Z."""
    camera = {
        "type": "orthographic",
        "eye": [0.0, 0.0, 50.0],
        "view_height": view_height,
        "width": size,
        "height": size,
    }
    return {"mesh": {"path": str(path)}, "mm_per_unit": 1.0, "camera": camera, "lights": lights, **keys}


def parallel_light(direction, intensity=1.0):
    """Parallel light that comes from a direction (x, y, z)."""
    return {"type": "directional", "position": [500.0 * part for part in direction], "intensity": intensity}
