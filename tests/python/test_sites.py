# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Tables of a site in Python."""

import concurrent.futures
import pickle

import numpy as np
import pytest

import vandplan as vp

COARSE = {"headings": 24, "cell": 0.25}


@pytest.fixture
def table(yard):
    return vp.site_table(yard, [(0, 12, 0), (-10, -5, 1)], jobs=2, **COARSE)


def test_a_table_has_costs_from_everywhere(yard, table):
    assert table.goals.tolist() == [[0, 12, 0], [-10, -5, 1]]
    assert table.cost((0, 12, 0)) == 0.0
    costs = table.cost([[(0, 0, 0), (20, 0, 0)]], goal=1)
    assert costs.shape == (1, 2) and (costs > 5).all()
    assert np.isinf(table.cost((0, 6, 0)))
    with pytest.raises(vp.InputError, match="goal: the table has no such goal"):
        table.cost((0, 0, 0), goal=2)
    assert vp.site_table(yard, **COARSE).goals.tolist() == [[0, 12, 0]]


def test_a_way_is_read_off_and_begins_a_plan(yard, table):
    way = table.way(yard)
    assert vp.check(yard, way)
    result = vp.plan(yard, site=table, max_iterations=50)
    assert result and result.cost < 1.2 * table.cost(yard.start)
    (again,) = vp.plan_many(yard, yard.start, yard.goal, site=table, max_iterations=50)
    assert again.path == result.path


def test_searches_look_up_the_table(yard, table):
    options = {"style": "driver", "max_iterations": 20_000}
    assert vp.plan(yard, "hybrid-a-star:site", site=table, **options)
    with pytest.raises(vp.InputError, match="site: the estimate needs a table of the site"):
        vp.plan(yard, "rrt-opt-site")
    with pytest.raises(vp.InputError, match="site: is for estimate=site"):
        vp.plan(yard, "hybrid-a-star", site=table)


def test_a_table_is_bound_to_its_world_and_prices(yard, table):
    wall = [(-20, 5), (16, 5), (16, 7), (-20, 7)]
    other = vp.Scenario((0, 0, 0), (0, 12, 0), bounds=(-50, 50, -50, 50), obstacles=[wall])
    with pytest.raises(vp.InputError, match="made for another world"):
        vp.plan(other, site=table)
    with pytest.raises(vp.InputError, match="made for other options"):
        table.way(yard, reverse_weight=3)
    with pytest.raises(vp.InputError, match="the table has no such goal"):
        table.way(yard.with_poses(goal=(0, 13, 0)))


def test_a_matrix_has_a_row_for_each_start(yard, table):
    starts = [(0, 0, 0), (20, 0, 1), (0, 6, 0)]
    cost, bound = vp.matrix(yard, starts, table, jobs=2)
    assert cost.shape == bound.shape == (3, 2)
    assert (bound <= cost).all() and np.isinf(cost[2]).all() and np.isfinite(cost[:2]).all()
    made, _ = vp.matrix(yard, starts[:1], [(0, 12, 0)])
    assert np.allclose(made[0, 0], cost[0, 0], rtol=0.1)


def test_a_matrix_reaches_its_starts_and_leaves_out_goals_that_are_not_free(yard):
    cost, bound = vp.matrix(yard, [(45, 45, 0), (-45, -45, 0)], [(0, 12, 0), (0, 6, 0)])
    assert np.isfinite(cost[:, 0]).all() and np.isinf(cost[:, 1]).all() and (bound > 0).all()


def test_a_bound_is_infinite_where_it_is_proven_that_there_is_no_path(yard):
    cost, bound = vp.matrix(yard, [(45, 45, 0)], [(0, 12, 0), (0, 6, 0)])
    assert np.isfinite(bound[0, 0]) and np.isinf(cost[0, 1]) and np.isinf(bound[0, 1])


def test_the_cheapest_goal_is_proven_by_the_bounds_of_the_others():
    cost = np.array([[9, 7, 30], [9, 7, 30], [np.inf, np.inf, np.inf]])
    bound = np.array([[5, 6, 7], [7, 4, np.inf], [0, np.inf, 0]])
    goal, is_proven = vp.cheapest_goals(cost, bound)
    assert goal.tolist() == [1, 1, -1] and is_proven.tolist() == [False, True, False]
    with pytest.raises(vp.InputError, match="^lower_bound: expected"):
        vp.cheapest_goals(cost, bound[:2])


def test_a_pair_whose_goal_the_table_lacks_is_named(yard, table):
    with pytest.raises(vp.InputError, match=r"^goals\[1\]: the table has no such goal"):
        vp.plan_many(yard, yard.start, [(0, 12, 0), (0, 13, 0)], site=table)


def test_a_table_takes_the_free_goals_of_a_set(yard):
    docks = [vp.GoalRegion(0, 12, 0), vp.GoalRegion(0, 6, 0), vp.GoalRegion(-10, -5, 1, either_way=True)]
    made = vp.site_table(yard.with_poses(goal=docks), **COARSE)
    assert np.allclose(made.goals, [[0, 12, 0], [-10, -5, 1], [-10, -5, 1 - np.pi]])
    assert vp.plan(yard.with_poses(goal=docks), site=made, max_iterations=50)
    with pytest.raises(vp.InputError, match="goals: the goal of the scenario holds infinitely many poses"):
        vp.site_table(yard.with_poses(goal=vp.GoalRegion(x=(0, 1), y=12, heading=0)), **COARSE)


def test_a_table_is_kept_in_a_file(yard, table, tmp_path):
    file = tmp_path / "yard.vst"
    table.save(file)
    read = vp.read_site_table(file)
    assert pickle.loads(pickle.dumps(read)).cost((3, 1, 2)) == table.cost((3, 1, 2))
    file.write_bytes(file.read_bytes()[:-1])
    with pytest.raises(vp.InputError, match="yard.vst: truncated"):
        vp.read_site_table(file)


def test_a_table_is_repaired_where_obstacles_come_and_go(yard):
    changing = vp.ChangingSiteTable(yard, [(0, 12, 0), (-10, -5, 1)], **COARSE)
    before = changing.table
    parked = vp.Scenario(
        yard.start, yard.goal, vehicle=yard.vehicle, bounds=yard.bounds,
        obstacles=[*yard.obstacles, [(8, -4), (12, -4), (12, -1), (8, -1)]]
    )
    changing.repair(parked)
    assert changing.table.cost((4, 12, 0)) == vp.site_table(parked, changing.table.goals, **COARSE).cost((4, 12, 0))
    assert np.isinf(changing.table.cost((10, -3, 0))) and np.isfinite(before.cost((10, -3, 0)))
    assert vp.plan(parked, site=changing.table, max_iterations=50)
    changing.repair(yard)
    assert changing.table.cost((10, -3, 0)) == before.cost((10, -3, 0))


def test_a_replanner_repairs_its_table_where_a_truck_parks(yard):
    site = vp.ChangingSiteTable(yard.with_poses(start=(4.6, -7.2, 1)), [(0, 12, 0), (-10, -5, 1)], **COARSE)
    before = site.table
    replanner = vp.Replanner(yard, site=site, max_iterations=50, tick_iterations=5)
    answer = replanner.tick(0.0)
    assert answer.reaches_goal and answer.without_site == ""
    replanner.patch(added={7: [(8, -4), (12, -4), (12, -1), (8, -1)]})
    assert replanner.tick(0.1).is_safe
    assert np.isinf(site.table.cost((10, -3, 0))) and np.isfinite(before.cost((10, -3, 0)))
    replanner.set_goal((0, 15, 0))
    answer = pickle.loads(pickle.dumps(replanner.tick(0.2)))
    assert answer.without_site == "the table of the site has no such goal"
    site.repair(yard)
    assert site.table.cost((10, -3, 0)) == before.cost((10, -3, 0))


def test_a_replanner_takes_a_table_that_can_be_repaired(yard, table):
    with pytest.raises(vp.InputError, match="site: expected a ChangingSiteTable"):
        vp.Replanner(yard, site=table)
    site = vp.ChangingSiteTable(yard, **COARSE)
    with pytest.raises(vp.InputError, match="site: the table was made for other options"):
        vp.Replanner(yard, site=site, reverse_weight=3)
    run = vp.drive_live(yard, site=site, max_iterations=50, tick_iterations=10, longest=200)
    assert run.has_arrived and not run.contact


def test_threads_take_turns_with_a_table(yard):
    site = vp.ChangingSiteTable(yard, **COARSE)
    replanner = vp.Replanner(yard, site=site, max_iterations=50)

    def attempt(work, given):
        try:
            return bool(work(given))
        except vp.InputError as error:
            assert "is at work in another thread" in str(error)
            return False

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        ticks = [pool.submit(attempt, replanner.tick, 0.0) for _ in range(20)]
        repairs = [pool.submit(attempt, site.repair, yard) for _ in range(20)]
        assert [work.result() for work in ticks + repairs].count(True) <= 20
    assert replanner.tick(0.0) and site.table.cost((0, 12, 0)) == 0.0


def test_a_matrix_of_plans_is_cheaper_and_knows_trailers(yard, table):
    starts = [(0, 0, 0), (20, 0, 1), (0, 6, 0)]
    ways, _ = vp.matrix(yard, starts, table)
    cost, bound = vp.matrix(yard, starts, table, max_iterations=60, jobs=2)
    assert (cost[:2] <= ways[:2]).all() and (bound[:2] <= cost[:2]).all() and np.isinf(cost[2]).all()
    rig = vp.Vehicle(trailers=[{"wheelbase": 5, "front_overhang": 1, "rear_overhang": 1, "width": 2}])
    towed = vp.Scenario(yard.start, yard.goal, vehicle=rig, bounds=yard.bounds, obstacles=yard.obstacles)
    with pytest.raises(vp.InputError, match="site: expected no trailer"):
        vp.matrix(towed, starts, [(0, 12, 0)])
    cost, _ = vp.matrix(towed, starts[:1], [(0, 12, 0)], max_iterations=200)
    assert np.isfinite(cost).all()


def test_what_a_matrix_refuses_is_named_as_in_python(yard, table):
    starts = [[10.0, 0.0, 0.0]]
    for wrong, name in [({"site": table}, "site"), ({"jobs": 0}, "jobs"), ({"max_iterations": 0}, "max_iterations")]:
        with pytest.raises(vp.InputError, match=f"^{name}: expected"):
            vp.matrix(yard, starts, table, **wrong)
    for call in (vp.site_table, vp.ChangingSiteTable, table.way, lambda s, **o: vp.matrix(s, starts, table, **o)):
        for option in ({"site": table}, {"time_limit": 3}, {"seed": 2}, {"threads": 2}, {"target_gap": 0.1}):
            with pytest.raises(vp.InputError, match=f"^{next(iter(option))}: .*expected"):
                call(yard, **option)
    vp.matrix(yard, starts, table, max_iterations=9, seed=2, time_limit=3)
    with pytest.raises(vp.InputError, match="^site: expected"):
        vp.matrix(yard, starts, table, max_iterations=9, site=table)
    with pytest.raises(vp.InputError, match="^jobs: expected"):
        vp.site_table(yard, jobs=0)
    with pytest.raises(vp.InputError, match="^jobs: expected"):
        vp.ChangingSiteTable(yard, jobs=0)
