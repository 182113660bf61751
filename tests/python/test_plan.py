# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Planning, the judge, smoothing and speeds."""

import json
import pickle
import os
import signal
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest
from conftest import REPOSITORY, WALL

import vandplan as vp


def test_a_plan_in_one_call(yard):
    result = vp.plan(yard, max_iterations=3000)
    assert result.status == "solved" and result
    assert result.path.end_pose == pytest.approx(yard.goal, abs=1e-6)
    assert result.cost >= result.path.length
    assert 0 < result.lower_bound <= result.cost
    assert result.gap == pytest.approx(result.cost / result.lower_bound - 1)
    assert result.anytime.shape[1] == 3
    assert result.anytime[-1, 2] == pytest.approx(result.cost)
    assert np.all(np.diff(result.anytime[:, 2]) < 0)
    assert result.iterations <= 3000
    assert result.counters["nodes"] > 0
    assert result.check.valid and result.check.clearance > 0
    assert result.planner == "anytime"
    assert result.options["max_iterations"] == 3000 and result.options["seed"] == 1
    assert result.scenario.name == "yard"
    assert result.reason == ""
    assert "solved" in repr(result)


def test_the_same_seed_and_iterations_repeat(yard):
    first, second = (vp.plan(yard, max_iterations=1000, seed=5) for _ in range(2))
    assert first.path == second.path
    assert first.path != vp.plan(yard, max_iterations=1000, seed=6, style="shortest").path


def test_options_are_those_of_set(yard):
    shortest = vp.plan(yard, max_iterations=2000, style="shortest", margin=0.25)
    assert shortest.cost == pytest.approx(shortest.path.length)
    assert shortest.check.clearance >= 0.25
    assert shortest.options["margin"] == 0.25
    fastest = [{"cost": "time", "style": "shortest"}, {"style": "shortest", "cost": "time"}]
    rules = [vp.plan(yard, max_iterations=0, **options).options for options in fastest]
    assert rules[0] == rules[1]
    assert (rules[0]["cost"], rules[0]["steering"]) == ("time", "reeds-shepp")
    beside = vp.plan(yard, max_iterations=100, reverse_weight=3, style="shortest")
    assert beside.options["reverse_weight"] == 3 and beside.options["gear_change_cost"] == 0
    tree = vp.plan(yard, "rrt-opt-euc", max_iterations=300, goal_bias=0.2)
    assert tree.options["goal_bias"] == 0.2
    numbers = vp.plan(yard, "rrt-opt-euc", max_iterations=9, goal_bias=np.float64(0.3), try_goal=np.bool_(True), margin=None)
    assert (numbers.options["goal_bias"], numbers.options["try_goal"], numbers.options["margin"]) == (0.3, True, 0)
    wheels = vp.plan(yard, max_iterations=500, steering="continuous")
    assert wheels.options["steering"] == "continuous"


def test_one_gear(yard):
    ahead = vp.plan(yard, max_iterations=2000, gears="forward")
    assert ahead and all(length >= 0 for length in ahead.path.segments[:, 1])
    assert ahead.options["gears"] == "forward" and vp.check(yard, ahead)
    assert vp.check(yard, ahead.path, steering="continuous-between-stops", gears="forward")
    behind = vp.check(yard, ahead.path, steering="continuous-between-stops", gears="reverse")
    assert "the allowed gears are: reverse" in behind.reason
    assert pickle.loads(pickle.dumps(ahead)).options["gears"] == "forward"
    with pytest.raises(vp.InputError, match="gears: .*not both, forward or reverse"):
        vp.plan(yard, gears="first")
    with pytest.raises(vp.InputError, match="gears: is no option of prm"):
        vp.plan(yard, "prm", gears="forward")


def test_options_of_the_scenario_hold_unless_others_are_given():
    scenario = vp.Scenario((0, 0, 0), (20, 0, 0), bounds=(-50, 50, -50, 50), options={"margin": 0.4})
    assert vp.plan(scenario, max_iterations=50).options["margin"] == 0.4
    assert vp.plan(scenario, max_iterations=50, margin=0.1).options["margin"] == 0.1


@pytest.mark.parametrize(
    ("planner", "options", "message"),
    [
        ("anytime", {"margin": -1}, "margin: -1 is not a number from 0 to 1000"),
        ("anytime", {"marign": 1}, "marign: unknown option, did you mean margin"),
        ("rrt-opt-euc", {"reverse_weight": 3}, "reverse_weight: is no option of rrt-opt-euc"),
        ("anytime", {"time_limit": -1}, "time_limit"),
        ("anytime", {"max_iterations": -1}, "max_iterations"),
        ("swift", {}, 'planner: "swift" is unknown'),
        (7, {}, "planner: expected a name"),
        ("anytime", {"on_interrupt": "ignore"}, "on_interrupt"),
    ],
)
def test_refusals_are_those_of_the_command_line(yard, planner, options, message):
    with pytest.raises(vp.InputError, match=message):
        vp.plan(yard, planner, **options)


def test_no_path_has_a_reason(yard):
    stuck = vp.plan(yard.with_poses(goal=(0, 6, 0)), max_iterations=10)
    assert stuck.status == "goal_in_collision" and not stuck
    assert "obstacles[0]" in stuck.reason
    assert stuck.path is None and stuck.cost is None and stuck.gap is None
    assert stuck.anytime.shape == (0, 3)
    with pytest.raises(vp.InputError, match="goal_in_collision"):
        vp.check(yard, stuck)
    walls = [(-10, -5), (10, -5), (10, -4), (-10, -4)], [(-10, 4), (10, 4), (10, 5), (-10, 5)]
    ends = [(-10, -5), (-9, -5), (-9, 5), (-10, 5)], [(9, -5), (10, -5), (10, 5), (9, 5)]
    caged = vp.Scenario(
        (0, 0, 0), (20, 0, 0), bounds=(-50, 50, -50, 50), obstacles=[*walls, *ends]
    )
    assert vp.plan(caged, max_iterations=10_000).status == "no_path"


def test_the_judge_accepts_and_refuses(yard):
    result = vp.plan(yard, max_iterations=1000)
    assert vp.check(yard, result)
    assert vp.check(yard, result.path, steering="continuous-between-stops")
    straight = vp.check(yard, vp.reeds_shepp(yard.start, yard.goal, 7))
    assert not straight and not straight.valid
    assert straight.reason and straight.at["pose"].shape == (3,)
    far = vp.check(yard, result.path, margin=30)
    assert not far and "margin" in far.reason + " margin"


def test_results_are_saved_and_read_back(yard, tmp_path):
    result = vp.plan(yard, max_iterations=1000)
    result.save(tmp_path / "r.json")
    again = vp.read_result(yard, tmp_path / "r.json")
    assert again.path == result.path and again.status == "solved"
    assert vp.check(yard, again)
    assert json.loads((tmp_path / "r.json").read_text("utf-8"))["planner"] == "anytime"
    result.save(tmp_path / "r.vpr")
    binary = vp.read_result(yard, tmp_path / "r.vpr")
    assert binary.path == result.path and binary.cost == result.cost
    assert vp.check(yard, binary)
    vp.draw(yard, result, tmp_path / "r.svg")
    vp.draw(yard, None, tmp_path / "s.png", width=200)
    assert (tmp_path / "r.svg").read_text("utf-8").startswith("<?xml")
    assert result._repr_png_().startswith(b"\x89PNG")
    with pytest.raises(vp.InputError, match="r.gif"):
        vp.draw(yard, result, tmp_path / "r.gif")


def test_many_plans_are_what_each_alone_is(yard, random_poses):
    starts = random_poses(12)
    many = vp.plan_many(yard, starts, yard.goal, jobs=2, max_iterations=50)
    assert len(many) == 12
    for start, result in zip(starts, many):
        alone = vp.plan(yard.with_poses(start=start), max_iterations=50)
        assert (alone.status, alone.path) == (result.status, result.path)
        assert np.array_equal(result.scenario.start, start)
        assert np.array_equal(result.scenario.goal, yard.goal)
    assert vp.plan_many(yard, np.zeros((0, 3)), yard.goal) == []
    with pytest.raises(vp.InputError, match="fit together"):
        vp.plan_many(yard, starts, starts[:3])
    with pytest.raises(vp.InputError, match="jobs"):
        vp.plan_many(yard, starts, starts, jobs=0)


def test_a_plan_begins_with_a_path_that_was_good(yard):
    known = vp.plan(yard, max_iterations=500)
    again = vp.plan(yard, vp.warm_started(known), max_iterations=0)
    assert again and again.cost <= known.cost * (1 + 1e-9)
    assert vp.plan(yard, vp.warm_started(known.path), max_iterations=0).path == again.path


def test_a_source_proposes_paths(yard):
    known = vp.plan(yard, max_iterations=5000)
    heard = []

    def source(task):
        assert np.allclose(task.start, yard.start)
        heard.append((yield None))
        heard.append((yield known))
        while True:
            heard.append((yield None))

    planner = vp.with_sources({"known": source})
    result = vp.plan(yard, planner, max_iterations=300)
    assert result and result.cost <= known.cost * (1 + 1e-3)
    assert heard[0] is None and any(isinstance(path, vp.Path) for path in heard)
    assert vp.plan(yard, planner, max_iterations=300, threads=4).path == result.path
    with pytest.raises(TypeError, match="pickled"):
        pickle.dumps(planner)


def test_a_source_that_fails_ends_the_run(yard):
    def fails(task):
        yield None
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        vp.plan(yard, vp.with_sources({"fails": fails}), max_iterations=300)
    with pytest.raises(TypeError, match="yield"):
        vp.plan(yard, vp.with_sources({"no generator": lambda task: 3}), max_iterations=300)
    with pytest.raises(vp.InputError, match="share"):
        vp.with_sources({"idle": fails}, share=0)


def test_a_path_is_smoothed(yard):
    arcs = vp.plan(yard, max_iterations=500, style="shortest")
    smooth = vp.smooth(yard, arcs, max_iterations=200)
    assert smooth and smooth.options["steering"] == "continuous-between-stops"
    assert vp.check(yard, smooth)
    with pytest.raises(vp.InputError, match="method"):
        vp.smooth(yard, arcs, method="iron")


def test_smoothing_goes_by_the_options_of_the_result(yard, tmp_path):
    driven = vp.plan(yard, max_iterations=1500, margin=0.2, reverse_weight=3, min_stroke=0.5)
    driven.save(tmp_path / "r.json")
    read = vp.read_result(yard, tmp_path / "r.json")
    for given in (driven, read, pickle.loads(pickle.dumps(read)), pickle.loads(pickle.dumps(driven))):
        smooth = vp.smooth(yard, given, max_iterations=100)
        assert smooth.cost <= driven.cost * (1 + 1e-9)
        assert smooth.options["margin"] == 0.2 and smooth.options["reverse_weight"] == 3
        assert smooth.options["min_stroke"] == 0.5 and smooth.options["seed"] == 1
    assert vp.smooth(yard, driven, max_iterations=100, margin=0.1).options["margin"] == 0.1
    short = vp.smooth(yard, driven, max_iterations=100, style="shortest")
    assert short.options["reverse_weight"] == 1
    bare = vp.smooth(yard, driven.path, max_iterations=100)
    assert bare.options["margin"] == 0 and bare.options["reverse_weight"] == 2
    kept = vp.smooth(yard, smooth, max_iterations=0)
    assert kept.path == smooth.path and kept.cost == smooth.cost


def test_speeds_along_a_path(yard):
    result = vp.plan(yard, max_iterations=500)
    profile = vp.speed_profile(yard, result)
    assert profile.duration > result.path.length / 2.5
    motions = profile.sampled(0.1)
    assert motions["t"][0] == 0 and motions["t"][-1] == pytest.approx(profile.duration)
    assert np.abs(motions["v"]).max() <= 2.5 + 1e-9
    at = profile.motion_at([0.0, profile.duration])
    assert at["s"] == pytest.approx([0, result.path.length])
    slow = vp.speed_profile({"max_speed": (1, 1)}, result.path)
    assert slow.duration > profile.duration
    with pytest.warns(DeprecationWarning), pytest.raises(vp.InputError, match="vehicle: is missing"):
        vp.speed_profile(result.path)


# Nothing but planning takes processor time there: once some was taken, the run has begun.
INTERRUPTED = """
import os, signal, sys, threading, time
import vandplan as vp

yard = vp.Scenario((0, 0, 0), (0, 12, 0), bounds=(-50, 50, -50, 50), obstacles=[%r])
how = sys.argv[1]

def interrupt():
    begin = time.process_time()
    while time.process_time() < begin + 0.2:
        time.sleep(0.01)
    os.kill(os.getpid(), signal.SIGINT)

threading.Thread(target=interrupt).start()
try:
    if how == "many":
        vp.plan_many(yard, [yard.start] * 50, yard.goal, time_limit=600)
    elif how == "own":
        def forever(task):
            while True:
                task.is_free(task.start)
        vp.plan(yard, forever, time_limit=600)
    else:
        result = vp.plan(yard, time_limit=600, on_interrupt=how)
        print("returned", bool(result), result.path is not None)
except KeyboardInterrupt:
    print("interrupted")
print(signal.getsignal(signal.SIGINT) is signal.default_int_handler)
again = vp.plan(yard, max_iterations=200)
print(again.status)
"""


@pytest.mark.parametrize(
    ("how", "said"),
    [("raise", "interrupted"), ("return", "returned True True"), ("many", "interrupted"), ("own", "interrupted")],
)
def test_ctrl_c_ends_a_run(how, said):
    script = INTERRUPTED % (WALL,)
    run = subprocess.run(
        [sys.executable, "-c", script, how], capture_output=True, text=True, timeout=300, check=True
    )
    assert run.stdout.split("\n")[:3] == [said, "True", "solved"], run.stderr


def test_other_threads_plan_meanwhile(yard):
    results = []
    threads = [
        threading.Thread(target=lambda seed=seed: results.append(vp.plan(yard, max_iterations=300, seed=seed)))
        for seed in (1, 2)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(results) and len(results) == 2


def test_importing_does_not_import_what_is_not_needed():
    script = "import sys, vandplan; print([m for m in ('numpy', 'pandas', 'matplotlib', 'typing') if m in sys.modules])"
    run = subprocess.run(
        [sys.executable, "-S", "-c", script],
        capture_output=True, text=True, check=True,
        env={**os.environ, "PYTHONPATH": os.path.dirname(os.path.dirname(vp.__file__))},
    )
    assert run.stdout.strip() == "[]"


def test_everything_has_a_docstring():
    for name in vp.__all__:
        thing = getattr(vp, name)
        assert name == "__version__" or textwrap.dedent(thing.__doc__ or "").strip(), name
        if isinstance(thing, type):
            for member, value in vars(thing).items():
                if not member.startswith("_") and not isinstance(value, (str, int)):
                    assert value.__doc__, f"{name}.{member}"


def test_a_vehicle_may_pull_a_trailer():
    scenario = vp.read_scenario(REPOSITORY / "scenarios/trailer/dock.yaml")
    result = vp.plan(scenario, max_iterations=20000, seed=3)
    assert result.status == "solved"
    smooth = vp.plan(scenario, max_iterations=2000, steering="continuous")
    assert vp.check(scenario, smooth) and smooth.options["steering"] == "continuous"
    with pytest.raises(vp.InputError, match="steering: is continuous"):
        vp.plan(scenario, "rrt-bsc-euc", max_iterations=10, steering="continuous")


def test_what_is_in_the_way_is_a_field(yard, tmp_path):
    wall = [(-3, -3), (3, -3), (3, 3), (-3, 3)]
    blocked = vp.Scenario(start=(0, 0, 0), goal=(20, 0, 0), bounds=(-50, 50, -50, 50), obstacles=[wall])
    result = vp.plan(blocked, max_iterations=10)
    assert result.status == "start_in_collision" and result.hit == {"what": "obstacles", "index": 0}
    assert pickle.loads(pickle.dumps(result)).hit == result.hit
    result.save(tmp_path / "r.json")
    assert vp.read_result(blocked, tmp_path / "r.json").hit == result.hit
    vp.draw(blocked, result, tmp_path / "r.svg")
    assert "85%" in (tmp_path / "r.svg").read_text("utf-8")
    assert vp.check(blocked, vp.Path((0, 0, 0), [(0, 20, 0)])).hit == {"what": "obstacles", "index": 0}
    cells = np.zeros((20, 20), dtype=bool)
    cells[10, 17] = True
    there = vp.Scenario(start=(4, 10.5, 0), goal=(14, 10.5, 0), map=cells, resolution=1.0, vehicle="tpcap-car")
    hit = vp.plan(there, max_iterations=10).hit
    assert hit["what"] == "map" and hit["cell"] == (17.5, 10.5)
    assert vp.plan(yard, max_iterations=500).hit is None
