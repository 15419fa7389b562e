"""A session on a machine with a GPU: the shipped scenes drawn by its OpenGL, each buffer judged; six minutes at most.

    python benchmarks/real_gpu.py -o real_gpu.json          # needs the extra gl
    python benchmarks/real_gpu.py --scenes wedge figure5 --size 64 --minutes 1

Prints a table in Markdown for docs/gpu.md, and writes one JSON file with the device, the verdicts and the seconds.
Every scene is a process of its own, so that a driver that crashes or hangs costs that scene alone.
"""

import argparse
import json
import subprocess
import sys
import time
from pathlib import Path

from sss_ref.scene_file.shipped import scene_names

APIS = ("opengl",)
LEAST = 3.0  # seconds: no scene is begun with less
INFO = {"device": "GL_RENDERER", "vendor": "GL_VENDOR", "driver": "GL_VERSION", "subpixel_bits": "GL_SUBPIXEL_BITS"}


def main() -> None:
    """The session, or one scene of it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", nargs="+", choices=scene_names(), default=scene_names(), metavar="SCENE")
    parser.add_argument("--size", type=int, default=256, help="pixels a side, of maps too")
    parser.add_argument("--minutes", type=float, default=6.0, help="6 at most")
    parser.add_argument("--profile", default="vulkan", help="as of sss-ref validate")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    parser.add_argument("-o", "--output", type=Path, default=Path("real_gpu.json"))
    given = parser.parse_args()
    if not (0 < given.minutes <= 6 and 1 <= given.size <= 16384):
        parser.error("expected --minutes from 0 to 6 and --size from 1 to 16384")
    if given.one:
        print(json.dumps(judged(given.one, given.size, given.profile)))
        return
    record = session(given.scenes, given.size, given.profile, time.monotonic() + 60 * given.minutes)
    given.output.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    print(table(record))


def session(scenes: list[str], size: int, profile: str, end: float) -> dict:
    """What the machine is, and the verdicts of as many scenes as there is time for."""
    start, rows, left_out = time.monotonic(), [], []
    for api, scene in ((api, scene) for api in APIS for scene in scenes):
        left = end - time.monotonic()
        if left < LEAST:
            left_out.append(f"{api} {scene}")
            continue
        row = {"api": api, "scene": scene, **in_process(scene, size, profile, left)}
        print(f"{scene}: {row['verdict']}, {row['seconds']:.1f} s", file=sys.stderr, flush=True)
        rows.append(row)
    seconds = round(time.monotonic() - start, 1)
    return {**device(), "size": size, "profile": profile, "seconds": seconds, "scenes": rows, "left_out": left_out}


def device() -> dict:
    """Renderer, vendor, version and subpixel bits as the driver says them; nulls where it has no OpenGL."""
    from sss_ref.errors import ShaderError
    from sss_ref.gl.context import open_context

    try:
        context = open_context()
    except ShaderError:
        return dict.fromkeys(INFO)
    found = {name: context.info.get(key) for name, key in INFO.items()}
    context.release()
    return found


def in_process(scene: str, size: int, profile: str, seconds: float) -> dict:
    """The verdict on a scene from a process that is given so many seconds."""
    words = ["--one", scene, "--size", str(size), "--profile", profile]
    start = time.monotonic()
    try:
        done = subprocess.run([sys.executable, __file__, *words], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return {"verdict": "no time", "summary": "", "explanations": [], "seconds": time.monotonic() - start}
    if done.returncode:
        said = done.stderr.strip().splitlines()[-1:] or [f"exit code {done.returncode}"]
        return {"verdict": "error", "summary": said[0], "explanations": [], "seconds": time.monotonic() - start}
    return {**json.loads(done.stdout.splitlines()[-1]), "seconds": round(time.monotonic() - start, 1)}


def judged(name: str, size: int, profile: str) -> dict:
    """Draw a scene, and hold every buffer and register against the stages."""
    import sss_ref
    from sss_ref.gl import draw
    from sss_ref.language.pipeline import REGISTERS

    small = {f"{t}.{s}": size for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}
    scene = sss_ref.load_scene(name, **small)
    report = sss_ref.validate(scene, draw(scene, keep=("all", REGISTERS)), profile=profile)
    verdict = "pass" if report.passed else "fail"
    return {"verdict": verdict, "summary": report.summary, "explanations": [*report.details, *report.explanations]}


def table(record: dict) -> str:
    """The table for docs/gpu.md."""
    bits = f"{record['subpixel_bits']} subpixel bits reported" if record["subpixel_bits"] else "no OpenGL"
    lines = [
        f"{record['device']}, {record['driver']}, {bits}; {record['size']} x {record['size']}, "
        f"profile {record['profile']}, {record['seconds']} s",
        "",
        "| scene | API | verdict | seconds | |",
        "|---|---|---|---|---|",
    ]
    for row in record["scenes"]:
        said = "" if row["verdict"] == "pass" else "; ".join([row["summary"], *row["explanations"]]).replace("|", "\\|")
        lines.append(f"| {row['scene']} | {row['api']} | {row['verdict']} | {row['seconds']:.1f} | {said} |")
    left = record["left_out"]
    return "\n".join([*lines, *(["", f"Left out for want of time: {', '.join(left)}."] if left else [])])


if __name__ == "__main__":
    main()
