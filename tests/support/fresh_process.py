"""Renders one scene in a process of its own and prints the hashes as JSON; the tests of bits and of the cache run it.

Arguments: the scene as JSON, threads (0: the default), and the names of the buffers to keep ("all").
"""

import json
import os
import subprocess
import sys
from pathlib import Path


def hashes_elsewhere(scene, cache, **settings):
    """Buffer -> hash as a new process with its own cache folder, settings and copy of the package computes them."""
    return hashes_and_words(scene, cache, **settings)[0]


def hashes_and_words(scene, cache, threads=0, keep="all", package=Path(__file__).parents[2], **environment):
    """The same, and what that process said to standard error."""
    own = {"SSS_REF_CACHE_DIR": str(cache), "PYTHONPATH": str(package), "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(
        [sys.executable, __file__, json.dumps(scene), str(threads), json.dumps(keep)],
        env=os.environ | own | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    printed = json.loads(done.stdout)
    assert Path(printed.pop("package")) == Path(package) / "sss_ref"
    return printed, done.stderr


def machine_code(cache):
    """The files of machine code below a cache folder -> when they were written."""
    files = (path for suffix in ("kernel", "code") for path in Path(cache).rglob(f"*.{suffix}"))
    return {path: path.stat().st_mtime_ns for path in files}


def main():
    import sss_ref

    scene, threads, keep = sys.argv[1:]
    result = sss_ref.render(sss_ref.load_scene(json.loads(scene)), threads=int(threads) or None, keep=json.loads(keep))
    print(json.dumps({"package": str(Path(sss_ref.__file__).parent), **result.hashes}))


if __name__ == "__main__":
    main()
