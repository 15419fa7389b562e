import os
import re
import signal
import socket
import subprocess
import sys
import time
from contextlib import contextmanager
from queue import Queue
from types import SimpleNamespace

import pytest
from data_folder import TETRAHEDRON
from small_batches import SMALL

from sss_ref.batch import cluster
from sss_ref.batch.cluster import on_cluster, versions, work_alike
from sss_ref.batch.run import BatchExecution, run
from sss_ref.batch.sweep_file import checked_sweep
from sss_ref.batch.workshop import ItemOutcome
from sss_ref.cli import main
from sss_ref.errors import DumpError, RenderError, SceneError

dask, distributed = pytest.importorskip("dask"), pytest.importorskip("distributed")
SCENE = """
mesh = {path = "tetrahedron.obj"}
camera = {type = "orbit", distance = 5}
lights = [{position = [0, 0, 9]}]
"""
ITEMS = 80


@pytest.fixture
def sweep(tmp_path):
    """Of a scene that workers find as a file, for they do not share this process's data folder."""
    (tmp_path / "scene.toml").write_text(SCENE)
    (tmp_path / "tetrahedron.obj").write_text(TETRAHEDRON)
    turn = {"camera.azimuth": {"first": 0, "last": 300, "count": ITEMS}}
    return checked_sweep({"scene": str(tmp_path / "scene.toml"), "set": SMALL, "vary": turn}, "sweep")


@pytest.fixture(scope="module")
def two_workers():
    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 1}),  # of an item, before the scheduler gives it up
        distributed.LocalCluster(2, threads_per_worker=1, dashboard_address=None, silence_logs=50) as found,
    ):
        yield found


def test_a_cluster_gives_the_same_hashes_though_a_worker_is_killed(sweep, tmp_path, two_workers):
    here = run(sweep, tmp_path / "here", BatchExecution(interpreter="arrays", threads=1))
    seen = []

    def kill_one(outcome):
        seen.append(outcome)
        if len(seen) == ITEMS // 4:
            os.kill(next(iter(two_workers.workers.values())).process.pid, signal.SIGKILL)

    with on_cluster(two_workers.scheduler_address) as executor:
        there = run(sweep, tmp_path / "there", BatchExecution(executor, "arrays", 1), on_outcome=kill_one)
    assert [each.hashes for each in there.outcomes] == [each.hashes for each in here.outcomes]
    assert [each.name for each in there.outcomes] == [each.name for each in here.outcomes]
    assert {each.state for each in there.outcomes} <= {"rendered", "there"}  # there: written right before the kill
    assert len(seen) == ITEMS


def test_a_failing_item_and_one_that_ends_its_worker_leave_the_others_alone(sweep, tmp_path, two_workers, monkeypatch):
    wanted = sweep.model_copy(update={"vary": {"camera.fov_y": [30, 400, 40]}})
    monkeypatch.setattr(cluster, "work_alike", ending_at_2)
    with on_cluster(two_workers.scheduler_address) as executor:
        batch = run(wanted, tmp_path / "out", BatchExecution(executor, "arrays", 1))
    assert batch.outcomes[0].state in ("rendered", "there")  # there: written right before its worker ended
    assert [each.state for each in batch.outcomes[1:]] == ["failed", "failed"]
    assert "camera.fov_y: expected an angle" in batch.outcomes[1].message
    assert "item 2: expected a picture, got a process that was killed" in batch.outcomes[2].message


def ending_at_2(expected, packed, item):
    if item == 2:
        os._exit(1)
    return work_alike(expected, packed, item)


def test_a_worker_with_other_versions_is_told(sweep, two_workers, monkeypatch):
    monkeypatch.setattr(cluster, "RULES_VERSION", 99)
    address = two_workers.scheduler_address
    with pytest.raises(SceneError) as caught, on_cluster(address):
        pytest.fail("connected")
    assert f"--dask {address}: tcp://" in str(caught.value)
    assert re.search(r"expected sss_ref .*, rules 99, .*, got sss_ref .*, rules \d, .*; install", str(caught.value))
    outcome = work_alike("sss_ref 9.9.9", b"", 4)  # of a worker that has joined later
    assert (outcome.item, outcome.state) == (
        4,
        "failed",
    ) and "item 4: expected a worker with sss_ref 9" in outcome.message


def test_a_folder_that_workers_do_not_see_is_told(sweep, tmp_path, two_workers, monkeypatch):
    monkeypatch.setattr(cluster, "BATCH", "batch.json of elsewhere")
    with pytest.raises(DumpError, match=r"expected a folder that worker tcp://.* sees too"):
        cluster._check_folder(FakeClient({"tcp://a:1": cluster._sees(tmp_path)}), tmp_path)


class FakeClient:
    """Answers what it is told to, in the place of workers."""

    def __init__(self, answers):
        self.answers = answers

    def run(self, *_, **__):
        return self.answers


class LostOutcome:
    """A future that is done, whose outcome was in a worker that has ended: another has to begin again."""

    def __init__(self, *answers):
        self.answers = list(answers)

    def exception(self, timeout):
        return None

    def result(self, timeout):
        answer = self.answers.pop(0)
        if isinstance(answer, Exception):
            raise answer
        return answer


def test_an_outcome_that_ended_with_its_worker_is_waited_for_while_there_are_workers():
    client, late = FakeClient({}), distributed.TimeoutError()
    client.scheduler = FakeClient({})
    client.scheduler.address, client.nthreads = "tcp://a:1", lambda: {"tcp://b:2": 1}
    assert cluster._outcome_of(client, LostOutcome(late, "outcome"), 3) == "outcome"
    assert cluster._outcome_of(client, LostOutcome(late, distributed.KilledWorker("task", None, 0)), 3) is None
    client.nthreads = dict
    with pytest.raises(RenderError, match="tcp://a:1: expected a cluster with workers, got none any more; start some"):
        cluster._outcome_of(client, LostOutcome(late, "outcome"), 3)


def test_workers_without_the_package_or_none_at_all_are_told():
    with pytest.raises(SceneError, match="tcp://a:1: expected a cluster with workers, got none; start"):
        cluster._check_workers("tcp://a:1", {})
    with pytest.raises(SceneError, match=r"tcp://b:2: expected sss_ref .*, got one without sss_ref; install the same"):
        cluster._check_workers("tcp://a:1", {"tcp://b:2": ModuleNotFoundError("no sss_ref")})
    cluster._check_workers("tcp://a:1", {"tcp://b:2": versions()})


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "nonsense", "http://127.0.0.1:80", "a silent one"])
def test_an_address_that_does_not_answer_is_told(tmp_path, monkeypatch, capsys, address):
    monkeypatch.setattr(cluster, "ANSWER", 0.5)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sweep.toml").write_text('vary.preset = ["paper"]')
    with socket.socket() as silent:
        silent.bind(("127.0.0.1", 0))
        silent.listen()
        address = f"tcp://127.0.0.1:{silent.getsockname()[1]}" if address == "a silent one" else address
        assert main(["batch", "sweep.toml", "-o", "out", "--dask", address]) == 2
    told = " ".join(capsys.readouterr().err.split())
    assert f"--dask {address}: expected a Dask scheduler, got no answer; write its address as tcp://HOST:8786" in told
    assert os.listdir() == ["sweep.toml"]


def test_a_cluster_and_processes_exclude_each_other(tmp_path, monkeypatch, capsys):
    (tmp_path / "sweep.toml").write_text('vary.preset = ["paper"]')
    assert main(["batch", str(tmp_path / "sweep.toml"), "--dask", "tcp://a:1", "--jobs", "2"]) == 2
    assert "--dask: expected without --jobs, got both" in capsys.readouterr().err


@pytest.fixture
def small_cluster(tmp_path):
    """Address, scheduler and the only worker, in processes that nobody starts again."""
    processes = [begun("dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", folder=tmp_path)]
    try:
        address = scheduler_address(tmp_path)
        processes.append(begun("dask_worker", address, "--no-nanny", "--no-dashboard", folder=tmp_path))
        with distributed.Client(address, set_as_default=False) as client:
            client.wait_for_workers(1, timeout=60)
        yield address, *processes
    finally:
        for process in processes:
            process.kill()
            process.wait()


@pytest.mark.parametrize("place, expected", [(1, "a Dask scheduler"), (2, "a cluster with workers")])
def test_the_end_of_the_scheduler_or_of_all_workers_is_told(
    sweep, tmp_path, monkeypatch, small_cluster, place, expected
):
    monkeypatch.setattr(cluster, "PATIENCE", 2.0)
    with (
        pytest.raises(RenderError, match=f"tcp://.*: expected {expected}, got none any more; start"),
        on_cluster(small_cluster[0]) as executor,
    ):
        run(
            sweep,
            tmp_path / "out",
            BatchExecution(executor, "arrays", 1),
            on_outcome=lambda _: small_cluster[place].kill(),
        )


def begun(module, *words, folder):
    """A part of a cluster, in a process of its own; what it says goes to a file named after it."""
    with (folder / f"{module}.txt").open("w") as told:
        return subprocess.Popen([sys.executable, "-m", f"distributed.cli.{module}", *words], stdout=told, stderr=told)


def scheduler_address(folder):
    end = time.monotonic() + 60
    while time.monotonic() < end:
        lines = (folder / "dask_scheduler.txt").read_text().splitlines()
        found = [line.split()[-1] for line in lines if "Scheduler at:" in line]
        if found:
            return found[0]
        time.sleep(0.1)
    pytest.fail("the scheduler did not begin")


class Begun:
    """Stands in for a future of an item."""

    def __init__(self, found, item):
        self.found, self.item = found, item

    def exception(self, timeout):
        return None

    def result(self, timeout):
        return self.found.outcome(self.item)


class Cluster:
    """Stands in for a cluster and its client: items are finished one at a time, the first that was begun first.

    threads: of its workers. killed: item -> how often its workers end with it.
    """

    def __init__(self, threads, killed=()):
        self.threads, self.killed = threads, dict(killed)
        self.flying, self.begun, self.made, self.waited, self.closed, self.most = [], [], [], [], [], 0

    def client(self, address, timeout, set_as_default):
        self.made.append((address, timeout, set_as_default))
        return self

    def wait_for_workers(self, count, timeout):
        self.waited.append((count, timeout))

    def run(self, function, *given, on_error="raise"):
        return {"tcp://worker": function(*given)}

    def nthreads(self):
        return self.threads

    def submit(self, work, expected, packed, item, pure):
        assert not pure and expected == versions()
        begun = Begun(self, item)
        self.begun.append(item)
        self.flying.append(begun)
        self.most = max(self.most, len(self.flying))
        return begun

    def outcome(self, item):
        if self.killed.get(item, 0):
            self.killed[item] -= 1
            raise distributed.KilledWorker("task", "worker", 3)
        return ItemOutcome(item, "rendered")

    def wait(self, futures, return_when, timeout):
        self.waited.append(timeout)
        assert return_when == "FIRST_COMPLETED" and futures == self.flying
        return SimpleNamespace(done=[self.flying.pop(0)])

    @contextmanager
    def as_current(self):
        yield

    def close(self, timeout):
        self.closed.append(timeout)


@pytest.fixture
def stood_in(tmp_path, monkeypatch):
    """Renders ten items by a cluster that is made up; the outcomes in their order."""

    class Noted(Queue):
        """Notes how long an answer is waited for."""

        def get(self, block=True, timeout=None):
            outcomes.patience.append(timeout)
            return super().get(block, timeout)

    def outcomes(found, count=10):
        outcomes.patience = []
        monkeypatch.setattr(cluster, "Queue", Noted)
        monkeypatch.setattr(distributed, "Client", found.client)
        monkeypatch.setattr(distributed, "wait", found.wait)
        job = SimpleNamespace(folder=tmp_path, packed=lambda: b"job")
        (tmp_path / "batch.json").touch()
        with on_cluster("tcp://x:1") as executor:
            return list(executor(job, range(count)))

    return outcomes


@pytest.mark.parametrize(("threads", "most"), [({"a": 1}, 2), ({"a": 1, "b": 2}, 6), ({}, 2), ({"a": 20}, 10)])
def test_two_items_a_thread_are_in_flight(threads, most, stood_in):
    found = Cluster(threads)
    assert [each.item for each in stood_in(found)] == list(range(10))
    assert found.begun == list(range(10)) and found.most == most
    assert found.made == [("tcp://x:1", 10.0, False)] and found.closed == [10.0]
    assert found.waited == [(1, 10.0), *[60.0] * 10] and stood_in.patience == [20.0]


def test_a_worker_with_other_versions_renders_nothing(monkeypatch):
    monkeypatch.setattr(cluster, "work", lambda packed, item: ("rendered", packed, item))
    assert work_alike(versions(), b"job", 3) == ("rendered", b"job", 3)
    outcome = work_alike("sss_ref 0", b"job", 3)
    assert (outcome.item, outcome.state) == (3, "failed")
    assert outcome.message.startswith("item 3: expected a worker with sss_ref 0, got sss_ref ")


def test_an_item_that_was_lost_is_begun_again_while_no_other_is_in_flight(stood_in):
    """Once more; after that it is told as failed."""
    found = Cluster({"a": 2}, {3: 1, 7: 2})
    outcomes = stood_in(found)
    assert [each.item for each in outcomes] == [0, 1, 2, 4, 5, 6, 8, 9, 3, 7]
    assert [each.item for each in outcomes if each.state == "failed"] == [7]
    assert found.begun == [*range(10), 3, 7]


def test_no_item_is_none_begun(stood_in):
    found = Cluster({"a": 1})
    assert stood_in(found, 0) == [] and found.begun == []
