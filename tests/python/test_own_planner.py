# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Planners written in Python: run, judged and compared."""

import json
import math
import pickle

import numpy as np
import pytest

import vandplan as vp

pandas = pytest.importorskip("pandas")


def grow(task):
    """A random tree that ends at its first path."""
    random = np.random.default_rng(task.seed)
    x_min, x_max, y_min, y_max = task.scene
    nodes = vp.NearestNodes(task.radius, task.start)
    poses, parents, edges = [task.start], [-1], [None]
    while task.next():
        is_goal = random.random() < task.options.get("goal_share", 0.2)
        sample = task.goal if is_goal else random.uniform((x_min, y_min, -3.14), (x_max, y_max, 3.14))
        nearest, _ = nodes.nearest(sample)
        edge = task.connect(poses[nearest], sample)
        if edge is None:
            continue
        nodes.add(sample)
        poses.append(sample)
        parents.append(nearest)
        edges.append(edge)
        if is_goal:
            way, node = [], len(poses) - 1
            while node > 0:
                way.append(edges[node])
                node = parents[node]
            way.reverse()
            task.found(task.cost(way))
            return vp.Answer(way, counters={"nodes": len(poses)}, tree=(poses, parents))
    return None


def test_a_function_is_a_planner(yard):
    result = vp.plan(yard, grow, max_iterations=3000)
    assert result and result.planner == "grow"
    assert vp.check(yard, result)
    assert result.cost == pytest.approx(result.path.length)
    assert result.counters["nodes"] > 1
    poses, parents = result.tree
    assert len(poses) == len(parents) == result.counters["nodes"] and parents[0] == -1
    assert result.anytime[-1, 2] == pytest.approx(result.cost)
    assert result.path == vp.plan(yard, grow, max_iterations=3000).path


def test_a_task_far_away_answers_in_the_frame_of_the_scenario():
    x, y = 4e6, 7e5
    wall = [(x + 30, y - 5), (x + 34, y - 5), (x + 34, y + 5), (x + 30, y + 5)]
    bounds = (x - 50, x + 50.25, y - 40, y + 40)
    far = vp.Scenario((x, y, 0), (x + 20, y, 0), bounds=bounds, obstacles=[wall])
    in_wall, beside_it = (x + 31, y, 0), (x + 5, y + 2, 0)

    def straight(task):
        assert np.array_equal(task.start, far.start) and np.array_equal(task.goal, far.goal)
        assert task.bounds == bounds and task.scene == (x - 20, x + 50.25, y - 25, y + 25)
        assert not task.is_free(in_wall) and task.is_free(beside_it)
        assert np.array_equal(task.is_free([in_wall, beside_it]), [False, True])
        assert not task.is_free(vp.Path(task.start, [(0, 30)])) and task.is_free(vp.Path(task.start, [(0, 20)]))
        assert task.clearance(in_wall) == 0 and task.clearance(task.start) == pytest.approx(30 - 5.9)
        assert np.array_equal(task.clearance([in_wall, beside_it], 1), [0, 1])
        assert task.connect(task.start, in_wall) is None
        assert np.array_equal(task.steer(task.start, in_wall).start, task.start)
        way = task.connect(task.start, task.goal)
        assert way.end_pose == pytest.approx(task.goal) and task.cost(way) == pytest.approx(20)
        return vp.Answer(way, tree=([task.start, task.goal], [-1, 0]))

    result = vp.plan(far, straight, max_iterations=1)
    assert np.array_equal(result.path.start, far.start) and result.path.end_pose == pytest.approx(far.goal)
    assert np.array_equal(result.tree[0], [far.start, far.goal])


def test_the_judge_refuses_what_hits_a_wall(yard):
    result = vp.plan(yard, lambda task: task.steer(task.start, task.goal), max_iterations=1)
    assert result.status == "rejected" and "obstacles[0]" in result.reason
    assert result.check is not None and result.path is None


def test_it_never_gets_a_trailer_that_its_checks_would_ignore(yard):
    rig = vp.Scenario(yard.start, yard.goal, bounds=yard.bounds, vehicle="tractor-semitrailer")
    with pytest.raises(vp.InputError, match="plans for a vehicle without a trailer"):
        vp.plan(rig, grow, max_iterations=1)


def test_what_it_may_return(yard):
    none = vp.plan(yard, lambda task: None, max_iterations=5)
    assert none.status == "stopped"

    def runs_out(task):
        while task.next():
            pass

    assert vp.plan(yard, runs_out, max_iterations=5).status == "iteration_limit"
    proven = vp.plan(yard, lambda task: vp.Answer(proven=True, reason="walls"), max_iterations=5)
    assert (proven.status, proven.reason) == ("no_path", "walls")
    with pytest.raises(vp.InputError, match="expected a path"):
        vp.plan(yard, lambda task: 7, max_iterations=5)
    with pytest.raises(ZeroDivisionError):
        vp.plan(yard, lambda task: 1 / 0, max_iterations=5)
    with pytest.raises(vp.InputError, match="parents before"):
        vp.plan(yard, lambda task: vp.Answer(tree=([task.start], [0])), max_iterations=5)


def test_what_a_task_answers(yard):
    def look(task):
        assert task.radius == task.vehicle.min_turning_radius == 7
        assert task.bounds == (-50, 50, -50, 50)
        assert task.scene[0] >= -50
        assert task.seed == 3 and task.elapsed >= 0 and task.options == {}
        poses = np.array([[0, 0, 0], [0, 6, 0]])
        assert task.is_free((0, 0, 0)) is True
        assert np.array_equal(task.is_free(poses), [True, False])
        assert task.clearance(poses[1]) == 0 and task.clearance(poses, 0.5)[0] == 0.5
        assert task.is_free(vp.Path((0, 0, 0), [(0, 5)]))
        assert not task.is_free(vp.Path((0, 0, np.pi / 2), [(0, 5)]))
        assert task.connect(task.start, task.goal) is None
        assert task.connect(task.start, (5, 0, 0), cutoff=4) is None
        edge = task.connect(task.start, (5, 0, 0))
        assert task.cost(edge) == task.cost([edge]) == 5
        kept.append(task)

    kept = []
    vp.plan(yard, look, max_iterations=5, seed=3)
    with pytest.raises(vp.InputError, match="its run is over"):
        kept[0].next()


def test_options_of_its_own(yard):
    seen = []
    mine = vp.Planner(
        "mine",
        lambda task: seen.append(task.options),
        summary="looks",
        options={"share": (0.2, 0, 1), "deep": True, "count": 3, "mode": ("a", ["a", "b"])},
    )
    vp.plan(yard, mine, max_iterations=1, share=0.5, mode="b")
    assert seen == [{"share": 0.5, "deep": True, "count": 3, "mode": "b"}]
    assert mine.options["share"]["range"] == "0 to 1"
    with pytest.raises(vp.InputError, match="share"):
        vp.plan(yard, mine, max_iterations=1, share=2)
    with pytest.raises(vp.InputError, match="reverse_weight"):
        vp.plan(yard, mine, max_iterations=1, reverse_weight=2)
    assert [planner.name for planner in vp.planners()][0] == "anytime"
    assert mine.properties["deterministic"]


def test_many_plans_of_a_planner_in_python(yard):
    many = vp.plan_many(yard, [yard.start] * 4, yard.goal, grow, jobs=2, max_iterations=3000)
    assert all(many) and len({result.cost for result in many}) == 1


def test_it_is_compared_with_ours(yard, tmp_path):
    mine = vp.Planner("mine", grow, options={"goal_share": (0.2, 0, 1)})
    cells = np.zeros((60, 80), dtype=bool)
    cells[25:35, 20:60] = True
    park = vp.Scenario((5, 5, 0), (5, 25, 0), map=cells, resolution=0.5, name="park")
    told = []
    comparison = vp.compare(
        [yard, park],
        [mine, "rrt-opt-euc"],
        tmp_path / "out",
        repeats=2,
        max_iterations=2000,
        progress=lambda done, total: told.append((done, total)),
    )
    assert comparison.missing == 0
    assert told[-1] == (8, 8)
    assert "mine" in comparison.headline and "mine" in json.dumps(comparison.figures)
    runs = comparison.runs()
    assert isinstance(runs, pandas.DataFrame) and len(runs) == 8
    assert set(runs.planner) == {"mine", "rrt-opt-euc"} and set(runs.scenario) == {"yard", "park"}
    assert (runs.status == "solved").all()
    assert np.allclose(runs.cost, runs.length)
    assert (runs.first_cost >= runs.cost - 1e-9).all()
    assert vp.read_store(comparison.store).equals(runs)
    again = vp.compare([yard, park], [mine, "rrt-opt-euc"], tmp_path / "out", repeats=2, max_iterations=2000)
    assert again.runs().equals(runs)  # kept


def test_what_is_no_store_is_refused(tmp_path):
    with pytest.raises(vp.InputError, match="no such file"):
        vp.read_store(tmp_path / "none.sqlite")
    (tmp_path / "x.sqlite").write_text("nothing of the kind, but long enough to be looked at" * 40)
    with pytest.raises(vp.InputError, match="is not a result store") as refused:
        vp.read_store(tmp_path / "x.sqlite")
    assert refused.value.where == str(tmp_path / "x.sqlite")


def test_what_is_no_campaign_is_refused(yard, tmp_path):
    with pytest.raises(vp.InputError, match="regions"):
        vp.compare([yard], ["anytime"], tmp_path, regions=["moon"])
    with pytest.raises(vp.InputError, match="nobody"):
        vp.compare([yard], ["nobody"], tmp_path)


def test_an_answer_that_is_no_path_is_refused(yard):
    endless = []
    endless.append(endless)
    for answer in ("path", b"path", 3, object(), (1, 2), endless):
        with pytest.raises(vp.InputError, match="expected a path, a list of paths, None or an Answer"):
            vp.plan(yard, vp.Planner("odd", lambda task, answer=answer: answer))
    with pytest.raises(vp.InputError, match="start"):
        vp.Path((math.nan, 0, 0), [(0, 1, 0)])


def test_in_one_gear_the_pieces_of_a_task_are():
    ground = vp.Scenario((0, 0, 0), (0, 9, 0), bounds=(-90, 90, -90, 90))
    direct = vp.Planner("direct", lambda task: task.connect(task.start, task.goal), capabilities=["gears"])
    for gears, sign in (("forward", 1), ("reverse", -1)):
        result = vp.plan(ground, direct, max_iterations=1, gears=gears)
        assert result and all(sign * length >= 0 for length in result.path.segments[:, 1])
    again = pickle.loads(pickle.dumps(vp.Planner("named", named_direct, capabilities=["gears"])))
    assert again.properties["capabilities"] == ["gears"] and again.properties["honours_gears"]
    assert not again.properties["honours_prices"]
    with pytest.raises(vp.InputError, match="gears: is no option of deaf"):
        vp.plan(ground, vp.Planner("deaf", named_direct), max_iterations=1, gears="forward")
    back = vp.Planner("back", lambda task: vp.dubins(task.start, task.goal, 7), honours_gears=True)
    assert back.properties["capabilities"] == ["gears"]  # in the words of version 0.2.0
    with pytest.raises(vp.InputError, match="did you mean gears"):
        vp.Planner("back", lambda task: None, capabilities=["gear"])
    wrong = vp.plan(ground, back, max_iterations=1, gears="reverse")
    assert wrong.status == "rejected" and "the allowed gears are: reverse" in wrong.reason


def named_direct(task):
    return task.connect(task.start, task.goal)
