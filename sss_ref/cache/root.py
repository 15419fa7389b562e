"""Where the package keeps what takes long to make: the user's cache, in which each kind of thing has a folder."""

import os
from pathlib import Path

import platformdirs


def cache_below(name: str) -> Path | None:
    """The folder of that name, made if need be (None: nowhere to write); SSS_REF_CACHE_DIR says where it is."""
    root = os.environ.get("SSS_REF_CACHE_DIR") or platformdirs.user_cache_dir("sss_ref", appauthor=False)
    folder = Path(root) / name
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return None
    return folder if os.access(folder, os.W_OK) else None
