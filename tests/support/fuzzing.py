"""Reads changed files in a process of its own: what comes must be the same, or right, or one line of ours."""

import random
import re
import resource
import shutil
import signal
import tempfile
import traceback
import warnings
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

from changed_files import changed
from changed_values import picked
from fuzzed_readers import SCENE_KINDS
from fuzzed_record_readers import RECORD_KINDS
from harmless_changes import harmless
from valid_files import valid_files

SECONDS = 5  # of processor time for one file
WAIT = 300  # seconds until a reader that waits for ever is given up
MEMORY = 2 * 2**30  # bytes that reading may take
HARD_MEMORY = 16 * 2**30  # bytes at which the process gives up
HARMLESS_SHARE = 0.15
MOST_CHANGES = 3
LONGEST_LINE = 2500  # characters of a message, without the path
A_LINE = re.compile(r".+: expected .+, got .+")
KINDS = SCENE_KINDS | RECORD_KINDS  # kind -> what reads the first file of a valid one


@dataclass(frozen=True)
class Trial:
    """A seed's file: what kind it is, what was done to it, what came ("read", "refused" or "same"), what is wrong."""

    seed: int
    kind: str
    how: str
    came: str
    fault: str | None = None


def trials(seeds, seconds=SECONDS):
    """The trials of some seeds, in order; a reader that ends the process or never returns is a fault.

    seconds: of processor time that each may take.
    """
    context, seeds = get_context("spawn"), list(seeds)
    while seeds:
        ours, theirs = context.Pipe()
        process = context.Process(target=serve, args=(theirs, seconds), daemon=True)
        process.start()
        theirs.close()
        try:
            for _ in range(len(seeds)):
                seed = seeds.pop(0)
                trial = asked(ours, process, seed, seconds)
                yield trial
                if trial.came == "ended":
                    break
        finally:
            ours.close()
            process.join()


def asked(connection, process, seed, seconds):
    """What the process says of a seed; if it says nothing, that."""
    try:
        connection.send(seed)
        if connection.poll(WAIT):
            return connection.recv()
        process.kill()
        why = f"no answer in {WAIT} s"
    except (EOFError, BrokenPipeError):
        process.join()
        name = signal.Signals(-process.exitcode).name if process.exitcode < 0 else f"exit code {process.exitcode}"
        why = f"more than {seconds:g} s of processor time" if name == "SIGPROF" else f"the process ended: {name}"
    _, valid, _, how = changed_files(seed)
    return Trial(seed, valid.kind, f"{valid.name}: {how}", "ended", why)


def serve(connection, seconds):
    """Answer seeds until the other end closes."""
    resource.setrlimit(resource.RLIMIT_AS, (HARD_MEMORY, HARD_MEMORY))
    with tempfile.TemporaryDirectory() as folder:
        for valid in valid_files():  # what is loaded and compiled at first use takes its time
            outcome(valid, valid.files, Path(folder) / "valid")
        while True:
            try:
                seed = connection.recv()
            except EOFError:
                return
            signal.setitimer(signal.ITIMER_PROF, seconds)  # its signal ends a process
            trial = tried(seed, Path(folder))
            signal.setitimer(signal.ITIMER_PROF, 0)
            connection.send(trial)


def changed_files(seed):
    """Whether a seed's change is harmless, the valid files, those with the change, and what it was."""
    rng = random.Random(seed)
    valid = picked(rng, valid_files())
    files, done = dict(valid.files), []
    name = valid.first if rng.random() < 0.6 else picked(rng, list(files))
    same = harmless(rng, name, files[name]) if rng.random() < HARMLESS_SHARE else None
    if same:
        files[name], done = same[0], [same[1]]
    else:
        for _ in range(rng.randint(1, MOST_CHANGES)):
            files[name], how = changed(rng, name, files[name])
            done.append(how)
    return bool(same), valid, files, f"{name}, {', '.join(done)}"


def tried(seed, folder):
    """The trial of a seed."""
    is_harmless, valid, files, how = changed_files(seed)
    before = memory(reset=True)
    came, found, fault = outcome(valid, files, folder / f"{seed}")
    if memory() - before > MEMORY and not fault:
        fault = f"{(memory() - before) / 2**30:.1f} GiB of memory"
    if is_harmless and not fault:
        _, right, _ = outcome(valid, valid.files, folder / f"{seed} as it was")
        fault = None if came == "read" and found == right else f"a harmless change matters: {found}"
        came = "same"
    return Trial(seed, valid.kind, f"{valid.name}: {how}", came, fault)


def outcome(valid, files, folder):
    """ "read" or "refused", what was read or said, and what is wrong with that."""
    for name, data in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    try:
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            warnings.simplefilter("ignore", DeprecationWarning)  # as Python does for those who only use a library
            found, came = KINDS[valid.kind](folder / valid.first), "read"
        fault = "; ".join(infinite(found)) or None
    except Exception as error:
        found, came, fault = str(error).replace(str(folder), ""), "refused", unworded(error, folder)
    finally:
        shutil.rmtree(folder)
    return came, found, fault or ("; ".join(f"warns: {each.message}" for each in said) or None)


def unworded(error, folder):
    """What is wrong with an error; None for lines of ours that can be shown."""
    from sss_ref.errors import SssRefError

    if not isinstance(error, SssRefError):
        return "".join(traceback.format_exception(error))
    lines = str(error).replace(str(folder), ".").split("\n")
    wrong = [line for line in lines if not (A_LINE.fullmatch(line) and line.isprintable() and len(line) < LONGEST_LINE)]
    return f"no line of ours: {wrong[0][:2000]!r}" if wrong else None


def infinite(found):
    """What of a thing that was read is not finite, of dumps apart, where that is the shader's doing."""
    return [f"{name} is not finite" for name, digest, finite in found if not finite]


def memory(reset=False):
    """Bytes that this process had at most since the last reset."""
    if reset:
        Path("/proc/self/clear_refs").write_text("5")
    return int(re.search(r"VmHWM:\s+(\d+)", Path("/proc/self/status").read_text())[1]) * 1024
