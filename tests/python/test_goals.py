# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Goals that are more than a pose."""

import math

import numpy as np
import pytest

import vandplan as vp

BOUNDS = (-50, 90, -50, 50)


def scenario_to(goal, **more):
    return vp.Scenario((0, 0, 0), goal, bounds=BOUNDS, **more)


def test_a_region_says_what_it_was_given():
    region = vp.GoalRegion((44, 46), 20, (1.4, 1.7), either_way=True, curvature=0.01)
    assert region.x == (44, 46) and region.y == 20 and region.heading == (1.4, 1.7)
    assert region.either_way and region.curvature == 0.01 and region.hitch_angle == 0
    assert region.straight == 0 and vp.GoalRegion(1, 2, 3, straight=8).straight == 8
    assert region.area is None and not region.is_of_trailer
    assert region == vp.GoalRegion((44, 46), 20, (1.4, 1.7), either_way=True, curvature=0.01)
    assert region != vp.GoalRegion((44, 46), 20, 1.4) and region != 3
    area = vp.GoalRegion(area=[(40, 15), (50, 15), (50, 25)])
    assert area.heading == "any" and area.x is None and np.array_equal(area.area[2], [50, 25])
    assert "any" in repr(area) and "turned round" in repr(region)


def test_the_path_ends_at_the_cheapest_goal():
    docks = [vp.GoalRegion(60, 20 + 4 * i, 0) for i in range(3)]
    result = vp.plan(scenario_to([*docks, vp.GoalRegion(30, (-1, 1))]), max_iterations=2000)
    assert result.goal.index == 3
    assert np.allclose(result.goal.pose, result.path.end_pose, atol=2e-6)
    assert result.check.goal == result.goal and result.goal != 3
    assert "3" in repr(result.goal)
    assert vp.check(result.scenario, result)
    assert vp.plan(scenario_to((30, 0, 0)), max_iterations=100).goal is None


def test_a_path_is_smoothed_up_to_its_straight_end():
    dock = scenario_to(vp.GoalRegion(40, 10, 0, straight=8))
    arcs = vp.plan(dock, max_iterations=1000, style="shortest", steering="reeds-shepp")
    smooth = vp.smooth(dock, arcs, max_iterations=1000)
    assert smooth and smooth.goal.index == 0 and smooth.path != arcs.path
    assert smooth.path.segments[-1, 0] == 0
    assert vp.check(dock, smooth)


def test_scenarios_keep_their_sets():
    region = vp.GoalRegion(30, 0, (-0.1, 0.1))
    scenario = scenario_to(region)
    assert scenario.goal_set == [region]
    assert np.allclose(scenario.goal, [30, 0, 0])
    assert "any of 1 region" in repr(scenario)
    moved = scenario.with_poses(start=(1, 2, 0.5))
    assert moved.goal_set == [region] and np.array_equal(moved.start, [1, 2, 0.5])
    assert np.allclose(vp.plan(moved, max_iterations=200).path.start, [1, 2, 0.5])
    posed = scenario.with_poses(goal=(20, 0, 0))
    assert posed.goal_set == [] and np.array_equal(posed.goal, [20, 0, 0])
    assert vp.plan(posed, max_iterations=200).goal is None
    both = posed.with_poses(goal=[region, vp.GoalRegion(10, 5, 0)])
    assert len(both.goal_set) == 2
    assert "any_of" in both.to_yaml()


def test_files_hold_sets(tmp_path):
    scenario = scenario_to([vp.GoalRegion(30, 0, 0), vp.GoalRegion(area=[(40, 15), (50, 15), (50, 25)])])
    scenario.save(tmp_path / "set.yaml")
    read = vp.read_scenario(tmp_path / "set.yaml")
    assert read.goal_set == scenario.goal_set
    result = vp.plan(read, max_iterations=300)
    result.save(tmp_path / "r.json")
    again = vp.read_result(read, tmp_path / "r.json")
    assert again.goal == result.goal and vp.check(read, again)


def test_trailers_have_sets():
    region = vp.GoalRegion((20, 25), 0, 0, hitch_angle=(-0.1, 0.1), is_of_trailer=True)
    result = vp.plan(scenario_to(region, vehicle="tractor-semitrailer"), max_iterations=2000)
    assert result and result.goal.index == 0 and result.check


@pytest.mark.parametrize("make, where", [
    (lambda: vp.GoalRegion(1), "area"),
    (lambda: vp.GoalRegion(1, 2, area=[(0, 0), (1, 0), (1, 1)]), "area"),
    (lambda: vp.GoalRegion(1, 2, "north"), "heading"),
    (lambda: vp.GoalRegion((1, 2, 3), 2), "x"),
    (lambda: scenario_to(vp.GoalRegion((2, 1), 0)), "goal.x"),
    (lambda: scenario_to(vp.GoalRegion(1, math.nan)), "goal.y"),
    (lambda: scenario_to(vp.GoalRegion(1, 1, (0, 7))), "goal.heading"),
    (lambda: scenario_to([vp.GoalRegion(1, 1), vp.GoalRegion(1, 1, 0, hitch_angle=0.1)]), "goal.any_of[1].hitch_angles"),
    (lambda: scenario_to([vp.GoalRegion(1, 1), (1, 1, 0)]), "goal"),
])
def test_nonsense_is_refused(make, where):
    with pytest.raises(vp.InputError) as error:
        make()
    assert error.value.where == where
