# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""How fast is the Python package? Prints the table of docs/python.md.

usage: PYTHONPATH=build/ci/python /usr/bin/python3 bench/python/figures.py [BENCH_PROGRAM]

BENCH_PROGRAM is build/ci/bench/python_call_bench: what the same plans take in C++.
"""

import os
import statistics
import subprocess
import sys
import time

import numpy as np

import vandplan as vp

ROUNDS = 7


def processor_time():
    """Of this process with all of its threads [s]."""
    return time.process_time()


def least(work, rounds=ROUNDS, clock=processor_time):
    """The least time of several rounds [s]: noise only adds."""
    times = []
    for _ in range(rounds):
        begin = clock()
        work()
        times.append(clock() - begin)
    return min(times)


def row(what, figure):
    print(f"| {what} | {figure} |", flush=True)


def lengths():
    random = np.random.default_rng(1)
    low, high = (-50, -50, -np.pi), (50, 50, np.pi)
    starts, goals = random.uniform(low, high, (2, 1_000_000, 3))
    fast = least(lambda: vp.reeds_shepp_length(starts, goals, 7.0))
    exact = least(lambda: vp.reeds_shepp_length(starts, goals, 7.0, exact=True))
    apart = np.max(np.abs(vp.reeds_shepp_length(starts, goals, 7.0) - vp.reeds_shepp_length(starts, goals, 7.0, True)))
    row("`reeds_shepp_length`, 10^6 pairs within 100 m", f"{1 / fast:.0f} million a second, {apart:g} m from the exact ones")
    row("the same with `exact=True`, one pair after the other", f"{1 / exact:.1f} million a second")
    row("`dubins_length`", f"{1 / least(lambda: vp.dubins_length(starts, goals, 7.0), 3):.1f} million a second")
    row("`length_bounds`", f"{1 / least(lambda: vp.length_bounds(starts, goals, 7.0), 3):.1f} million a second")
    some = starts[:20_000], goals[:20_000]
    row("`continuous_length`", f"{2e-2 / least(lambda: vp.continuous_length(*some, 7.0, 0.05), 3):.2f} million a second")
    kept = vp.NearestNodes(7.0, starts[:100_000])
    row("`NearestNodes.nearest` of 100 000", f"{least(lambda: kept.nearest(goals[:100_000])) * 10:.1f} us a sample")
    for name, a, b in (("arrays", starts[0], goals[0]), ("tuples", tuple(starts[0]), tuple(goals[0]))):
        call = vp.reeds_shepp_length

        def calls(a=a, b=b):
            for _ in range(100_000):
                call(a, b, 7.0)

        row(f"one pair of {name}, the call included", f"{least(calls) * 10:.2f} us")


def overhead(program):
    """What `plan` costs beside C++: the same plans that are over in microseconds, interleaved."""
    scenario = vp.Scenario((0, 0, 0), (20, 0, 0), bounds=(-50, 50, -50, 50))
    count = 20_000

    def plans():
        for _ in range(count):
            vp.plan(scenario, "rrt-bsc-euc", max_iterations=1)

    ours, theirs = [], []
    for _ in range(ROUNDS):
        ours.append(least(plans, 1) / count)
        if program:
            theirs.append(float(subprocess.run([program], capture_output=True, text=True, check=True).stdout))
    if theirs:
        difference = statistics.median(a - b for a, b in zip(ours, theirs))
        row("`plan` more than in C++, a run of one iteration", f"{difference * 1e6:.1f} us")
    else:
        row("`plan`, a run of one iteration", f"{statistics.median(ours) * 1e6:.1f} us")


def threads():
    """How 1000 plans on two threads scale: wall clock, interleaved, against idle cores only."""
    yard = vp.Scenario(
        (0, 0, 0), (0, 12, 0), bounds=(-50, 50, -50, 50), obstacles=[[(-20, 5), (15, 5), (15, 7), (-20, 7)]]
    )
    starts = np.random.default_rng(2).uniform((-40, -40, -3), (40, 0, 3), (1000, 3))
    ratios, work = [], []
    for _ in range(ROUNDS):
        wall, used = [], []
        for count in (1, 2):
            begin, begin_used = time.perf_counter(), processor_time()
            vp.plan_many(yard, starts, yard.goal, jobs=count, max_iterations=30)
            wall.append(time.perf_counter() - begin)
            used.append(processor_time() - begin_used)
        ratios.append(wall[0] / wall[1])
        # What two idle cores would make of it: the work is shared but for what one thread does alone.
        work.append(used[1] / used[0])
    row("1000 plans, two threads against one, wall clock", f"{statistics.median(ratios):.2f} times, best {max(ratios):.2f}")
    row("processor time of two threads against one", f"{statistics.median(work):.3f} times")
    # What there is before and after the threads: 1000 pairs that need no search.
    inside = np.tile((0.0, 6.0, 0.0), (1000, 1))
    alone = least(lambda: vp.plan_many(yard, inside, yard.goal, max_iterations=30))
    share = alone / least(lambda: vp.plan_many(yard, starts, yard.goal, max_iterations=30))
    row("of it before and after the threads, at most", f"{100 * share:.1f} %")


def importing():
    script = "import time; a = time.process_time(); import vandplan; print(time.process_time() - a)"
    environment = {**os.environ}
    times = [
        float(subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=environment).stdout)
        for _ in range(15)
    ]
    row("`import vandplan`", f"{statistics.median(times) * 1e3:.0f} ms")


if __name__ == "__main__":
    print("| what | figure |\n| --- | --- |")
    importing()
    lengths()
    overhead(sys.argv[1] if len(sys.argv) > 1 else None)
    threads()
