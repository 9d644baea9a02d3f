#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# How long does `moivre solve` take where there is almost nothing to solve? Medians over many runs on two conics.
#
#   startup_test.py [--runs N] [--limit-ms MS] [--above EMPTY] PROGRAM [OPTION...]     options go to solve
#
# --above: a program that does nothing, and links what PROGRAM cannot do without; what it takes, run in turns, is taken off.
# Prints the medians of processor time (user and system, as the kernel charged it) and of wall time, and the shortest wall
# time. Exit: 0, 1 usage, 2 the median of processor time or the shortest wall time is over the limit: some other work on the
# machine lengthens the median of wall time, not these two. Where more processes want to run than there are cores, wall
# time is a measure of the others, and processor time alone is judged. Python's standard library only.
import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

CONICS = "2\n x^2 + y^2 - 5;\n x*y - 2;\n"


def run(command):
    """Processor and wall milliseconds of one process."""
    begin = time.perf_counter()
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    wall = time.perf_counter() - begin
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit {child.returncode}")
    return 1e3 * (usage.ru_utime + usage.ru_stime), 1e3 * wall


def main():
    parser = argparse.ArgumentParser(description="Start-up time of moivre solve.")
    parser.add_argument("--runs", type=int, default=50)
    parser.add_argument("--limit-ms", type=float)
    parser.add_argument("--above")
    parser.add_argument("program")
    options, words = parser.parse_known_args()
    with tempfile.TemporaryDirectory(prefix="moivre-startup-") as folder:
        file = Path(folder) / "conics.phc"
        file.write_text(CONICS, encoding="utf-8")
        command = [options.program, "solve", str(file), "--quiet", *words]
        run(command)
        times, empty = [], [(0, 0)]
        for _ in range(options.runs):
            times.append(run(command))
            if options.above:
                empty.append(run([options.above]))
    empty = empty[1:] or empty
    cpu = statistics.median(t[0] for t in times) - statistics.median(t[0] for t in empty)
    wall = statistics.median(t[1] for t in times) - statistics.median(t[1] for t in empty)
    least = min(t[1] for t in times) - min(t[1] for t in empty)
    print(f"{options.runs} runs: processor time {cpu:.2f} ms, wall time {wall:.2f} ms (median), {least:.2f} ms (least)")
    is_overloaded = os.getloadavg()[0] > os.cpu_count()
    if is_overloaded:
        print("more processes than cores: wall time is not judged")
    judged = cpu if is_overloaded else max(cpu, least)
    return 2 if options.limit_ms and judged > options.limit_ms else 0


if __name__ == "__main__":
    sys.exit(main())
