#!/bin/sh
# The golden hashes, by compiled kernels, on an emulated aarch64 processor.
#
#     tests/platforms/aarch64.sh FOLDER [pytest's arguments]
#     tests/platforms/aarch64.sh /tmp/arm tests/test_golden.py        # some ten minutes
#
# FOLDER receives Debian's Python for that processor, the wheels, and the compiled kernels; run again, it takes what is
# there. Needs Debian's mmdebstrap and qemu-user-static, pip, and network. The last result: aarch64.txt beside this file.
set -eu

checkout=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "${1:?a folder that may be filled}"
folder=$(cd "$1" && pwd)
shift

if [ ! -e "$folder/system/usr/bin/python3.11" ]; then
    mmdebstrap --variant=extract --architectures=arm64 --include=python3.11,libstdc++6 bookworm "$folder/system"
fi

# pip takes wheels of the other processor only where the manylinux tags are spelled out, and no package from a folder.
if [ ! -d "$folder/packages" ]; then
    wanted=$(python3 - "$checkout/pyproject.toml" <<'LIST'
import sys, tomllib
project = tomllib.load(open(sys.argv[1], "rb"))["project"]
print(*project["dependencies"], *(f"pytest{rest}" for rest in ("", "-xdist")), "hypothesis")
LIST
    )
    # shellcheck disable=SC2086  # one word for each package
    python3 -m pip install -q --python-version 3.11 --only-binary=:all: --target "$folder/packages" \
        --platform manylinux_2_28_aarch64 --platform manylinux_2_27_aarch64 --platform manylinux_2_17_aarch64 \
        --platform manylinux2014_aarch64 $wanted
fi

cd "$checkout"
export PYTHONPATH="$folder/packages:$checkout" SSS_REF_CACHE_DIR="$folder/cache" PYTHONDONTWRITEBYTECODE=1
python() { qemu-aarch64-static -L "$folder/system" "$folder/system/usr/bin/python3.11" "$@"; }
python - <<'SAY'
import platform
from importlib.metadata import version
packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "numba", "llvmlite"))
print(f"{platform.machine()}, Python {platform.python_version()}, {packages}")
SAY
[ $# -gt 0 ] || set -- tests/test_golden.py
python -m pytest -q -n 0 -p no:cacheprovider "$@"
