# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""What moves, and the times of drives among it."""

import numpy as np
import pytest
from conftest import REPOSITORY

import vandplan as vp

CROSSING = REPOSITORY / "scenarios/moving/crossing-traffic.yaml"
CAR = [(-1, -0.95), (3.5, -0.95), (3.5, 0.95), (-1, 0.95)]


@pytest.fixture(scope="module")
def crossing():
    return vp.read_scenario(CROSSING)


@pytest.fixture(scope="module")
def planned(crossing):
    return vp.plan(crossing, max_iterations=3000)


@pytest.fixture
def street():
    """A truck drives to the right; nothing else is there."""
    return vp.Scenario((0, 0, 0), (40, 0, 0), bounds=(-20, 60, -30, 30), name="street")


def crossing_car(t):
    """A car that is in front of the truck at that time."""
    return vp.MovingObstacle(CAR, [(t - 5, 20, -40, np.pi / 2), (t + 5, 20, 40, np.pi / 2)], after="leaves")


def test_what_was_planned_among_movers_keeps_its_times(crossing, planned):
    assert planned and planned.check.valid
    assert planned.check.times == "planned" and planned.check.drive.valid
    assert planned.speeds.duration == planned.check.drive.duration
    assert planned.speeds.path == planned.path
    fastest = vp.speed_profile(crossing.vehicle, planned.path)
    assert planned.speeds.duration > fastest.duration + 3, "it waits for nobody"
    assert vp.speed_profile(crossing, planned).knots["t"] == pytest.approx(planned.speeds.knots["t"], abs=0)
    with pytest.raises(vp.InputError, match="vehicle: is given"):
        vp.speed_profile("city-bus", planned)


def test_the_judge_sees_the_times(crossing, planned, tmp_path):
    for given in (planned, planned.speeds):
        check = vp.check(crossing, given)
        assert check.valid and check.times == "planned" and check.drive.clearance > 0
    bare = vp.check(crossing, planned.path)
    assert not bare.valid and bare.times == "fastest"
    assert bare.reason.startswith("the path has no times") and "moving[" in bare.reason
    assert bare.drive.t > 0 and bare.at["s"] > 0
    planned.save(tmp_path / "r.json")
    again = vp.read_result(crossing, tmp_path / "r.json")
    assert vp.check(crossing, again).valid
    assert again.speeds.duration == pytest.approx(planned.speeds.duration)


def test_a_path_without_times_says_so_even_where_it_meets_nobody(street):
    late = street.with_moving([crossing_car(500)])
    path = vp.Path((0, 0, 0), [(0, 40)])
    check = vp.check(late, path)
    assert check.valid and check.times == "fastest" and "without times" in repr(check)
    assert vp.check(street, path).times == "" and vp.check(street, path).drive is None
    assert vp.plan(street, max_iterations=50).speeds is None


def test_a_result_without_times_has_no_speeds_among_movers(street, tmp_path):
    vp.plan(street, max_iterations=50).save(tmp_path / "r.json")
    late = street.with_moving([crossing_car(500)])
    read = vp.read_result(late, tmp_path / "r.json")
    assert read.speeds is None
    with pytest.raises(vp.InputError, match="path: has no times"):
        vp.speed_profile(late, read)


def test_movers_are_made_in_python(street):
    car = crossing_car(10)
    assert np.array_equal(car.outline, CAR) and car.trajectory.shape == (2, 4)
    assert car.after == "leaves" and car.inflate == 0
    assert car.pose_at(10) == pytest.approx([20, 0, np.pi / 2]) and car.pose_at(16) is None
    growing = vp.MovingObstacle(CAR, [(0, 0, 0, 0), (4, 0, 0, 0)], inflate=0.1)
    assert growing.growth_at(2) == pytest.approx(0.2) and growing.growth_at(9) == pytest.approx(0.4)
    assert vp.end_of_motion([car, growing]) == 15
    assert car == crossing_car(10) and car != growing
    busy = vp.Scenario(street.start, street.goal, bounds=street.bounds, moving=[car])
    assert busy.moving == [car] and street.moving == []
    assert busy.with_moving([]).moving == [] and busy.with_poses(goal=(39, 0, 0)).moving == [car]


def test_a_plan_waits_for_a_mover_that_was_made_in_python(street):
    alone = vp.speed_profile(street, vp.Path((0, 0, 0), [(0, 40)]))
    then = float(np.interp(16, alone.sampled(0.1)["s"], alone.sampled(0.1)["t"]))
    busy = street.with_moving([crossing_car(then)])
    meeting = vp.first_meeting(alone, busy.moving)
    assert meeting.obstacle == 0 and meeting.t == pytest.approx(then, abs=2)
    assert vp.first_meeting(alone, []) is None
    assert not vp.check(busy, alone)
    result = vp.plan(busy, max_iterations=2000)
    assert vp.check(busy, result)
    assert vp.first_meeting(result.speeds, busy.moving) is None
    assert vp.first_meeting(result.speeds, busy.moving, margin=1000) is not None


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((CAR[:2], [(0, 0, 0, 0)]), "outline"),
        ((CAR, []), "trajectory"),
        ((CAR, [(0, 0, 0)]), "trajectory: expected rows"),
        ((CAR, [(1, 0, 0, 0), (0, 0, 0, 0)]), "trajectory"),
        ((CAR, [(0, 0, 0, np.nan)]), "trajectory"),
        ((CAR, [(0, 0, 0, 0)], "flies"), "after"),
        ((CAR, [(0, 0, 0, 0)], "stays", -1), "inflate"),
    ],
)
def test_a_mover_that_is_none_is_refused(arguments, message):
    with pytest.raises(vp.InputError, match=message):
        vp.MovingObstacle(*arguments)
