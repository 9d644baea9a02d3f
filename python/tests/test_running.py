# SPDX-License-Identifier: MIT
# Does Python stay in charge while the library works: Ctrl-C, progress, other threads?
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import moivre

LONG = """
import signal, sys, threading, time, os
import moivre
def katsura(n):
    u = lambda k: f"u{abs(k)}" if abs(k) <= n else "0"
    lines = [" + ".join([f"{u(k)}" for k in range(-n, n + 1)]) + " - 1"]
    for m in range(n):
        lines.append(" + ".join(f"{u(k)}*{u(m - k)}" for k in range(-n, n + 1)
                                if abs(k) <= n and abs(m - k) <= n) + f" - {u(m)}")
    return lines
begin = [0.0]
def press():
    begin[0] = time.process_time()
    os.kill(os.getpid(), signal.SIGINT)
def press_after(seconds):
    while time.process_time() < seconds:
        time.sleep(0.01)
    press()
"""

# Seconds, all of them in processor time, of which a busy machine takes none.
AT_ONCE = 0.3 * os.cpu_count()


def run(code):
    return subprocess.run([sys.executable, "-c", LONG + code], capture_output=True, text=True, check=False, timeout=120)


@pytest.mark.parametrize("tracker", ["cvode", "lanes"])
def test_ctrl_c_returns_what_is_finished_at_once(tracker):
    done = run(f"""
threading.Thread(target=press_after, args=[1.0], daemon=True).start()
r = moivre.solve(katsura(18), tracker={tracker!r})
print(time.process_time() - begin[0], r.complete, len(r), r.paths["tracked"])
print(r.message)
""")
    assert done.returncode == 0, done.stderr
    seconds, complete, roots, _ = done.stdout.splitlines()[0].split()
    assert complete == "False" and "interrupted" in done.stdout
    assert float(seconds) < AT_ONCE


@pytest.mark.parametrize("tracker", ["cvode", "lanes"])
def test_ctrl_c_in_a_long_list_of_poses_returns_at_once(tracker):
    puma = os.path.join(os.path.dirname(__file__), "../../problems/robots/puma560.urdf")
    done = run(f"""
arm = moivre.Arm({puma!r})
poses = arm.fk([[0.3 + 1e-5 * k, -0.5, 0.3, 0.4, 0.5, 0.6] for k in range(100_000)])
some = threading.Event()
threading.Thread(target=lambda: some.wait() and press(), daemon=True).start()
q = arm.ik(poses, tracker={tracker!r}, progress=lambda done, count: done > 0 and some.set())
print(time.process_time() - begin[0], q.complete, q.counts[0], q.counts[-1])
""")
    assert done.returncode == 0, done.stderr
    seconds, complete, first, last = done.stdout.split()
    assert complete == "False" and first == "8" and last == "0"
    assert float(seconds) < AT_ONCE


def test_ctrl_c_pressed_twice_raises_keyboard_interrupt():
    done = run("""
def until_interrupted():
    press_after(1.0)
    while not is_interrupted.wait(0.01):
        press()
is_interrupted = threading.Event()
threading.Thread(target=until_interrupted, daemon=True).start()
try:
    while True:
        moivre.solve(katsura(18))
except KeyboardInterrupt:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    is_interrupted.set()
    print("interrupted")
""")
    assert "interrupted" in done.stdout, done.stderr


def test_progress_counts_paths():
    seen = []
    r = moivre.solve(["x^5 + y^4 - 1", "x^3*y - 2"], progress=lambda done, total: seen.append((done, total)))
    assert r.complete and seen and all(done <= total for done, total in seen if total)


def test_progress_may_be_a_bar():
    class Bar:
        total = None
        n = 0

        def update(self, n):
            self.n += n

    bar = Bar()
    moivre.solve(["x^5 + y^4 - 1", "x^3*y - 2"], progress=bar)
    assert bar.total and bar.n > 0


def test_an_exception_of_the_progress_function_is_passed_on():
    def fail(done, total):
        raise RuntimeError("no more")

    with pytest.raises(RuntimeError, match="no more"):
        moivre.solve(["x^5 + y^4 - 1", "x^3*y - 2"], progress=fail)


def test_what_is_no_progress_is_refused():
    with pytest.raises(ValueError, match="progress"):
        moivre.solve("x - 1", progress=3)


def test_other_threads_run_meanwhile(problems):
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.002)

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.perf_counter()
    moivre.solve(problems / "polynomials" / "katsura-8.phc" if (problems / "polynomials" / "katsura-8.phc").exists()
                 else problems / "polynomials" / "cassou.phc", threads=1)
    end = time.perf_counter()
    stop.set()
    thread.join()
    assert sum(begin < t < end for t in ticks) >= 10


def test_two_threads_solve_at_once():
    results = [None, None]

    def work(k):
        results[k] = moivre.solve(["x^3 + y^2 - 2", "x*y - 1"], threads=1)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert np.array_equal(results[0].points, results[1].points)


def test_import_needs_numpy_and_little_else():
    code = "import sys, moivre; print([m for m in ('sympy', 'pandas', 'matplotlib', 'tqdm', 'mpmath', 'urllib.request', 'xml.sax') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"


def test_the_version_is_that_of_the_library():
    assert moivre.__version__.count(".") == 2
    assert signal.getsignal(signal.SIGINT) is not None
