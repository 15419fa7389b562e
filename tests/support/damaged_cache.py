"""A process of its own in which files of machine code are damaged and used: argv has the seeds.

For each seed a line is printed: the damage, what the kernel gave, and whether its file is there as it was. What the
package says goes to standard error.
"""

import os
import random
import sys
from pathlib import Path

import numpy as np

from sss_ref.cache.compiled import cache_folder, compiled
from sss_ref.cache.kernel_files import SUFFIX


def tripled(x):
    """A kernel."""
    return np.float32(3) * x


def doubled(x):
    """Another one, of the same types."""
    return np.float32(2) * x


def cut_off(path, generator):
    path.write_bytes(path.read_bytes()[: generator.randrange(path.stat().st_size)])


def flipped(path, generator):
    content = bytearray(path.read_bytes())
    for _ in range(generator.choice((1, 1, 8, 1000))):
        content[generator.randrange(len(content))] ^= 1 << generator.randrange(8)
    path.write_bytes(content)


def padded(path, generator):
    path.write_bytes(path.read_bytes() + generator.randbytes(generator.randrange(1, 99)))


def overwritten(path, generator):
    path.write_bytes(generator.randbytes(path.stat().st_size))


def exchanged(path, generator):
    other = next(each for each in path.parent.glob(f"doubled-*{SUFFIX}"))
    path.write_bytes(other.read_bytes())


def emptied(path, generator):
    path.write_bytes(b"")


def folder_instead(path, generator):
    path.unlink()
    path.mkdir()
    (path / "file").write_bytes(b"")


def pipe_instead(path, generator):
    path.unlink()
    os.mkfifo(path)


def link_to_nothing(path, generator):
    path.unlink()
    path.symlink_to("nowhere")


def unreadable(path, generator):
    """By anybody, root too: the file links to itself."""
    path.unlink()
    path.symlink_to(path.name)


DAMAGES = (
    cut_off, flipped, padded, overwritten, exchanged, emptied,
    folder_instead, pipe_instead, link_to_nothing, unreadable,
)  # fmt: skip


def main():
    """Damage the file of a kernel and run the kernel anew, once a seed."""
    for kernel in (tripled, doubled):
        compiled(kernel)(np.float32(7))
    path = next(Path(cache_folder()).glob(f"tripled-*{SUFFIX}"))
    for seed in map(int, sys.argv[1:]):
        damage = DAMAGES[seed % len(DAMAGES)]
        damage(path, random.Random(seed))
        given = compiled(tripled)(np.float32(7))
        again = compiled(tripled)
        again(np.float32(7))
        print(damage.__name__, given, sum(again.stats.cache_hits.values()), path.is_file() and not path.is_symlink())


if __name__ == "__main__":
    main()
