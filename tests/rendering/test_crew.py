import threading
import time

import pytest

from sss_ref.rendering.crew import Crew


@pytest.mark.parametrize("count", [1, 3])
def test_results_come_in_the_order_of_the_tasks(count):
    with Crew(count) as crew:
        assert [*crew.map(lambda a, b: a * b, range(100), range(7, 200))] == [k * (k + 7) for k in range(100)]
        assert [*crew.map(abs, [])] == []


def test_all_threads_take_tasks():
    """Each of two tasks waits for the other."""
    both = threading.Barrier(2, timeout=60)
    with Crew(2) as crew:
        assert sorted(crew.map(lambda _: both.wait(), range(2))) == [0, 1]


def test_the_caller_waits_for_no_thread_that_is_busy():
    """Nothing lets the other thread go before all tasks are done."""
    done = threading.Event()
    with Crew(2) as crew:
        busy = crew.submit(done.wait, 60)
        assert {*crew.map(lambda _: threading.get_ident(), range(5))} == {threading.get_ident()}
        done.set()
        assert busy.result()


def test_a_task_that_fails_ends_the_work():
    begun = []

    def failing(task):
        begun.append(task)
        if task == 0:
            raise IndexError(task)
        time.sleep(0.001)

    with Crew(2) as crew, pytest.raises(IndexError):
        crew.map(failing, range(1000))
    assert len(begun) < 1000
