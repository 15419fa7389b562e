"""Closed bodies as OBJ files, and scenes that look at them."""

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
NORMALS = [(0, 0, -1), (0, 0, 1), (0, -1, 0), (0, 1, 0), (-1, 0, 0), (1, 0, 0)]  # of FACES
FACES = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]  # outwards


def write_box(path, low, high):
    """A box from a corner to the opposite one."""
    return write_boxes(path, (low, high))


def write_boxes(path, *boxes):
    """Boxes that do not touch, each from a corner to the opposite one."""
    lines = [f"vn {' '.join(map(str, normal))}" for normal in NORMALS]
    for number, ends in enumerate(boxes):
        lines += [f"v {' '.join(str(ends[at[axis]][axis]) for axis in range(3))}" for at in CORNERS]
        for normal, face in enumerate(FACES, start=1):
            lines.append("f " + " ".join(f"{corner + 8 * number}//{normal}" for corner in face))
    path.write_text("\n".join(lines) + "\n")
    return path


def shaded_plate(path):
    """A scene of a plate 1 mm above another, lit at 45 degrees: its edge, x = 5 and z = 11, shades up to x = 16."""
    plates = write_boxes(path, ((-40, -40, -10), (40, 40, 0)), ((-40, -40, 1), (5, 40, 11)))
    return looking_down(plates, [parallel_light((-(0.5**0.5), 0.0, 0.5**0.5))], view_height=40.0)


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
