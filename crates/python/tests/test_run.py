"""Runs: the same bits as the command line's, Ctrl-C, exceptions, callbacks, memory."""

import ctypes
import functools
import gc
import multiprocessing
import operator
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import tremolite as tr
from conftest import EQUAL, pulse, same_files

SHORT = {"dynamic.duration": "0.2 s"}


def test_the_command_line_writes_the_same_bytes_as_python_with_and_without_a_callback(cavern, command, tmp_path):
    subprocess.run(
        [*command, "run", str(cavern), "--out", str(tmp_path / "command"), "--set", 'dynamic.duration="0.2 s"', "--threads", "1"],
        check=True,
        capture_output=True,
    )
    job = tr.Job(tr.Case(cavern).with_(SHORT))
    seen = []

    def look(now):
        seen.append((now.stage, now.time, float(np.abs(now.displacement).max()), now.stress("*.lining").shape))

    job.run(tmp_path / "plain", threads=2)
    job.run(tmp_path / "looked", threads=2, callback=look, every=7)
    assert same_files(tmp_path / "command", tmp_path / "plain") == []
    assert same_files(tmp_path / "command", tmp_path / "looked") == []
    assert [stage for stage, *_ in seen if stage] == ["initial equilibrium", "excavation", "lining"]
    assert len(seen) > 40 and seen[-1][1] == pytest.approx(0.2, abs=1e-3)
    # The case that is kept is what the command keeps.
    assert (tmp_path / "command" / "case.toml").read_bytes() == (tmp_path / "plain" / "case.toml").read_bytes()


def test_a_dict_and_its_file_give_the_same_bytes(column, tmp_path):
    case = tr.Case.from_dict(column)
    (tmp_path / "case.toml").write_text(case.text)
    a = tr.Job(case, motion=pulse()).run(tmp_path / "dict")
    b = tr.Job(tmp_path / "case.toml", records={"pulse": pulse()}).run(tmp_path / "file")
    assert same_files(a.path, b.path) == [] and a.status == "done"


def test_changes_of_a_run_are_changes_of_the_case(job, tmp_path):
    result = job.run(tmp_path / "a", set={"material.rock.young": "3 GPa"})
    assert result.case.to_dict()["material"]["rock"]["young"] == "3 GPa"
    assert job.case.to_dict()["material"]["rock"]["young"] == "2 GPa"


def test_check_is_the_commands_object_and_runs_nothing(job, tmp_path):
    checked = job.check(threads=1)
    assert checked["elements"] == 10 and checked["time_step"]["used"] == job.dt
    assert list(tmp_path.iterdir()) == []


def test_a_callback_that_says_false_stops_in_good_order_and_resuming_gives_the_same_bytes(job, tmp_path):
    whole = job.run(tmp_path / "whole")
    stopped = job.run(tmp_path / "halves", callback=lambda now: now.time < 0.3, every="0.05 s")
    assert stopped.status == "stopped" and 0.25 < stopped.monitors["top"].time[-1] < 0.36
    resumed = job.run(tmp_path / "halves", resume=True)
    assert resumed.status == "done" and same_files(whole.path, resumed.path, EQUAL[:3]) == []
    assert whole.differences(resumed) == []
    (resumed.path / "energy.csv").write_text("time [s]\n0\n")
    assert whole.differences(resumed.path) == ["energy.csv"]


def test_what_a_callback_raises_comes_through_and_the_folder_stays_usable(job, tmp_path):
    whole = job.run(tmp_path / "whole")

    def fall(now):
        if now.time > 0.3:
            raise ValueError("enough")

    with pytest.raises(ValueError, match="enough"):
        job.run(tmp_path / "a", callback=fall, every=3)
    assert tr.Result(tmp_path / "a").status == "stopped" and (tmp_path / "a" / "report.html").exists()
    assert same_files(whole.path, job.run(tmp_path / "a", resume=True).path, EQUAL[:3]) == []


def test_ctrl_c_leaves_a_checkpoint_and_a_summary(job, tmp_path):
    whole = job.run(tmp_path / "whole")

    def press(now):
        if now.time > 0.3:
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(tr.Stopped) as caught:
        job.run(tmp_path / "a", callback=press, every=5)
    assert isinstance(caught.value, KeyboardInterrupt) and caught.value.out == tmp_path / "a"
    assert tr.Result(tmp_path / "a").status == "stopped"
    assert same_files(whole.path, job.run(tmp_path / "a", resume=True).path, EQUAL[:3]) == []


def pressing():
    """An observer that presses Ctrl-C as the run is prepared, by C alone: Python, os.kill too, would hear it at once."""

    class Pressing(tr.Observer):
        every = property(operator.methodcaller("press"))

        def __init__(self):
            kill = ctypes.CDLL(None).kill
            kill.restype = None
            self.press = functools.partial(kill, os.getpid(), int(signal.SIGINT))

    return Pressing()


def test_ctrl_c_as_a_run_is_prepared_is_not_lost_and_leaves_a_checkpoint(job, tmp_path):
    # It was: the run ended as one that a callback had stopped, and the script went on with its next line.
    whole = job.run(tmp_path / "whole")
    with pytest.raises(tr.Stopped) as caught:
        job.run(tmp_path / "a", observers=[pressing()])
    assert caught.value.out == tmp_path / "a"
    with pytest.raises(tr.Stopped):
        job.start(tmp_path / "b", observers=[pressing()])
    for name in ("a", "b"):
        assert tr.Result(tmp_path / name).status == "stopped"
        assert same_files(whole.path, job.run(tmp_path / name, resume=True).path, EQUAL[:3]) == []


def test_what_an_observer_raises_as_it_begins_leaves_a_folder_to_go_on_with(job, tmp_path):
    class Falling(tr.Observer):
        def begin(self, at):
            raise ValueError("not yet")

    whole = job.run(tmp_path / "whole")
    with pytest.raises(ValueError, match="not yet"):
        job.run(tmp_path / "a", observers=[Falling()])
    with pytest.raises(ValueError, match="not yet"), job.start(tmp_path / "b", observers=[Falling()]) as simulation:
        simulation.step(1)
    for name in ("a", "b"):
        assert same_files(whole.path, job.run(tmp_path / name, resume=True).path, EQUAL[:3]) == []


def test_ctrl_c_from_outside_stops_a_long_run_soon(column, tmp_path):
    script = (
        "import sys, warnings; warnings.simplefilter('ignore'); sys.path.insert(0, sys.argv[2])\n"
        "import tremolite as tr; from conftest import COLUMN, pulse\n"
        "case = tr.Case.from_dict(COLUMN).with_({'dynamic.safety': 0.0002})\n"
        "job = tr.Job(case, motion=pulse()); print('on', flush=True)\n"
        "try: job.run(sys.argv[1])\n"
        "except tr.Stopped as e: print(tr.Result(e.out).status)\n"
    )
    child = subprocess.Popen(
        [sys.executable, "-c", script, str(tmp_path / "a"), os.path.dirname(__file__)], stdout=subprocess.PIPE, text=True
    )
    assert child.stdout.readline() == "on\n"
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    assert child.communicate(timeout=20)[0].strip() == "stopped" and child.returncode == 0


def test_what_a_callback_remembers_is_in_the_checkpoint(job, tmp_path):
    def most(upto):
        def see(now):
            largest = now.memory.setdefault("most", np.zeros(1))
            np.maximum(largest, np.abs(now.displacement).max(), out=largest)
            seen.append(float(largest[0]))
            return now.time < upto

        return see

    seen = []
    job.run(tmp_path / "whole", callback=most(9.0), every=3)
    whole, seen = seen[-1], []
    job.run(tmp_path / "a", callback=most(0.5), every=3)
    job.run(tmp_path / "a", callback=most(9.0), every=3, resume=True)
    assert seen[-1] == whole > 0.0


def test_an_array_outlives_its_run_and_stays_as_it_was(job, tmp_path):
    kept = []
    job.run(tmp_path / "a", callback=lambda now: kept.append((now.time, now.displacement)) or True, every="0.1 s")
    copies = [array.copy() for _, array in kept]
    del job
    gc.collect()
    assert len(kept) >= 10 and all((array == copy).all() for (_, array), copy in zip(kept, copies, strict=True))
    assert any((a != b).any() for a, b in zip(copies[3:], copies[4:], strict=False))
    with pytest.raises(ValueError, match="read-only"):
        kept[0][1][0, 0] = 1.0


def test_memory_does_not_grow_over_a_thousand_looks(column, tmp_path):
    # 400 elements: an array of a look holds 19 KiB of stress, and all that is looked at here some 60.
    column["mesh"]["box"]["z"]["elements"] = 400
    job = tr.Job(tr.Case.from_dict(column), motion=pulse())

    def resident():
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")

    if not os.path.exists("/proc/self/statm"):
        pytest.skip("this system does not tell resident memory")
    with job.start(tmp_path / "a") as simulation:
        simulation.step(50)

        def looks(count, held):
            for _ in range(count):
                look = simulation.look()
                held.append((look, look.displacement, look.stress(), look.mean_stress()))

        looks(100, held=[])
        gc.collect()
        before = resident()
        for _ in range(1000):
            looks(1, held=[])
        grown = resident() - before
        held = []
        looks(1000, held)
        kept = resident() - before
        # What is held shows what would be seen: each look that leaked would weigh like these.
        assert kept > 1000 * 40_000 and grown < 0.02 * kept


def test_other_threads_go_on_while_it_computes(job, tmp_path):
    ticks, over = [], threading.Event()

    def tick():
        while not over.wait(0.001):
            ticks.append(time.perf_counter())

    def gaps(work):
        """The longest time (s) between two ticks while some work goes on, and how long that took."""
        ticks.clear()
        begin = time.perf_counter()
        work()
        took = time.perf_counter() - begin
        return max(np.diff([begin, *[t for t in list(ticks) if t > begin], begin + took])), took

    long = tr.Job(job.case.with_({"dynamic.duration": "20 s", "output.snapshots": "10 s"}), motion=pulse())
    thread = threading.Thread(target=tick)
    thread.start()
    try:
        gap, took = gaps(lambda: long.run(tmp_path / "a", threads=1))
    finally:
        over.set()
        thread.join()
    # One long step at most: an interpreter that is held while it computes would let nobody tick until the end.
    assert took > 0.2 and gap < 0.5 * took


def test_a_run_that_breaks_off_is_warned_of_and_has_its_results(job, tmp_path):
    # A force beyond all sense leaves no numbers, so the guard stops the run.
    loaded = job.with_fields(loads=[([0], (0.0, 0.0, 1e300), [0.0], [1.0])])
    with pytest.warns(tr.RunWarning, match="unstable"):
        result = loaded.run(tmp_path / "a")
    assert result.status == "failed" and "reached its end" not in result.verdict


def test_progress_is_told(job, tmp_path):
    told = []
    # Half a million steps: longer than the 0.2 s between two words, on a fast machine too.
    case = job.case.with_({"dynamic.safety": 0.001})
    tr.Job(case, motion=pulse()).run(tmp_path / "a", progress=told.append)
    assert told and set(told[0]) >= {"share", "time", "stage"} and all(0 <= now["share"] <= 1 for now in told)


def test_a_run_can_begin_with_what_another_had_come_to(cavern, tmp_path):
    job = tr.Job(tr.Case(cavern).with_({"dynamic.duration": "0.02 s"}))
    first = job.run(tmp_path / "first")
    other = tr.Job(cavern).run(
        tmp_path / "other", from_=first.path, set={"dynamic.duration": "0.02 s"}, callback=lambda now: now.stage is None
    )
    assert same_files(first.path, other.path, ["monitors.csv", "energy.csv"]) == []
    with pytest.raises(tr.Error, match="where the results would go"):
        job.run(first.path, from_=first.path, overwrite=True)
    with pytest.raises(tr.Error, match="leave overwrite and from_ out"):
        job.run(tmp_path / "more", from_=first.path, resume=True)


def test_ctrl_c_before_the_earthquake_is_gone_on_with_where_it_came(cavern, tmp_path):
    job = tr.Job(tr.Case(cavern).with_({"dynamic.duration": "0.01 s"}))
    whole = job.run(tmp_path / "whole")

    def press(now):
        if now.stage == "initial equilibrium":
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(tr.Stopped):
        job.run(tmp_path / "a", callback=press)
    assert tr.Result(tmp_path / "a").status == "stopped"
    assert same_files(whole.path, job.run(tmp_path / "a", resume=True).path) == []


def test_a_folder_with_results_is_not_overwritten_unasked(job, tmp_path):
    job.run(tmp_path / "a")
    with pytest.raises(tr.Error, match="overwrite=True"):
        job.run(tmp_path / "a")
    job.run(tmp_path / "a", overwrite=True)
    with pytest.raises(tr.Error, match="complete"):
        job.run(tmp_path / "a", resume=True)
    with pytest.raises(tr.Error, match="every"):
        job.run(tmp_path / "b", callback=print, every="0.1 m")
    with pytest.raises(tr.Error, match="every = -1"):
        job.run(tmp_path / "b", callback=print, every=-1)
    with pytest.raises(tr.Error, match="threads"):
        job.run(tmp_path / "b", threads=0)


def _in_child(queue, job, out):
    try:
        job.run(out)
    except tr.Error as error:
        queue.put(str(error))


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_child_refuses(job, tmp_path):
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=_in_child, args=(queue, job, tmp_path / "a"))
    child.start()
    assert "spawn" in queue.get(timeout=20)
    child.join()


def test_importing_starts_no_thread_and_takes_no_signal():
    script = (
        "import os, signal, numpy\n"
        "threads = len(os.listdir('/proc/self/task')); before = signal.getsignal(signal.SIGINT)\n"
        "import tremolite\n"
        "print(len(os.listdir('/proc/self/task')) - threads, signal.getsignal(signal.SIGINT) is before)\n"
    )
    if not os.path.exists("/proc/self/task"):
        pytest.skip("this system does not list threads")
    assert subprocess.run([sys.executable, "-c", script], capture_output=True, text=True).stdout == "0 True\n"


def test_a_finish_that_could_not_write_can_be_tried_again(job, tmp_path):
    whole = job.run(tmp_path / "whole")
    with job.start(tmp_path / "a") as simulation:
        while simulation.step(1000):
            pass
        # What stands where the summary goes is as a full disk.
        blocked = tmp_path / "a" / "summary.json"
        blocked.mkdir()
        with pytest.raises(tr.RunError, match="summary.json"):
            simulation.finish()
        with pytest.raises(tr.Error, match="finish"):
            simulation.step(1)
        blocked.rmdir()
        result = simulation.finish()
    assert result.status == "done" and same_files(whole.path, result.path, EQUAL[:3]) == []
