# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Simulated drives, and plans that are made anew while driving."""

import pickle

import numpy as np
import pytest
from conftest import WALL
from test_moving import crossing_car

import vandplan as vp


@pytest.fixture
def street():
    return vp.Scenario((0, 0, 0), (40, 0, 0), bounds=(-20, 60, -30, 30), name="street")


def test_a_path_is_driven(yard):
    result = vp.plan(yard, max_iterations=2000, steering="continuous", margin=0.3)
    drive = vp.drive(yard, result, noise=1, spare_steering=0.1, keep_log=True)
    assert drive and drive.has_arrived and drive.contact is None and drive.trailer is None
    assert 0 < drive.largest_lateral < 0.5 and drive.duration >= drive.planned_duration - 1
    assert drive.log["t"][0] == 0 and len(drive.log["x"]) > 100
    exact = vp.drive(yard, result.path, seed=2)
    assert exact.largest_lateral < drive.largest_lateral and len(exact.log["t"]) == 0
    assert vp.drive(yard, result, noise=1, seed=2).duration != vp.drive(yard, result, noise=1, seed=3).duration
    with pytest.raises(vp.InputError, match="noise"):
        vp.drive(yard, result, noise=11)
    with pytest.raises(vp.InputError, match="controler: is an unknown keyword"):
        vp.drive(yard, result, controler="lqr")
    with pytest.raises(vp.InputError, match="noise: is 'loud'"):
        vp.drive(yard, result, noise="loud")


def test_a_drive_into_a_wall_says_what_it_hits(yard):
    drive = vp.drive(yard, vp.Path((0, 0, np.pi / 2), [(0, 12)]))
    assert not drive and "obstacles[0]" in drive.contact.what and drive.contact.pose.shape == (3,)
    assert "obstacles[0]" in repr(drive)


def test_controllers_have_names():
    names = [controller["name"] for controller in vp.controllers()]
    assert names[0] == "rear-axle-feedback" and "lqr" in names


def test_a_path_can_be_executed(yard):
    smooth = vp.executable(yard, vp.plan(yard, max_iterations=1000, steering="continuous"))
    assert smooth.flowing and smooth.jumps == 0
    arcs = vp.executable(yard, vp.plan(yard, max_iterations=1000, style="shortest"))
    assert arcs.jumps > 0 and arcs.pausing.duration > arcs.flowing.duration


def test_a_replanner_plans_anew(street):
    replanner = vp.Replanner(street, max_iterations=500)
    with pytest.raises(vp.InputError, match="has no drive"):
        replanner.answer.action_at(0)
    first = replanner.tick(0)
    assert first and first.outcome == "new_way" and first.reaches_goal
    assert first.drive.path.end_pose == pytest.approx(street.goal, abs=1e-6)
    assert first.action_at(1)["v"] > 0
    assert replanner.tick(0.5).outcome == "kept"
    wall = [(30, -1), (31, -1), (31, 1), (30, 1)]
    replanner.patch(added={7: wall})
    around = replanner.tick(1.0)
    assert around.is_safe and around.outcome in ("new_way", "stop")
    blocked = vp.Scenario(street.start, street.goal, bounds=street.bounds, obstacles=[wall])
    rest = around.drive.path
    assert vp.check(blocked.with_poses(start=rest.start, goal=rest.end_pose), rest)
    replanner.patch(removed=[7])
    replanner.set_moving([crossing_car(8)])
    moved = replanner.tick(1.5, pose=replanner.answer.drive.path.start, v=0)
    assert replanner.answer.outcome == moved.outcome
    with pytest.raises(vp.InputError, match="t: is not finite"):
        replanner.tick(np.nan)
    with pytest.raises(vp.InputError, match="not finite"):
        replanner.tick(2, pose=(np.nan, 0, 0))
    assert replanner.tick(2.0) is not None


def test_a_rig_replans_from_its_hitch_angle():
    lane = vp.Scenario(
        (0, 0, 0), (60, 0, 0), vehicle="tractor-semitrailer", bounds=(-40, 100, -30, 30), start_hitch_angle=0.3
    )
    replanner = vp.Replanner(lane, max_iterations=1000)
    first = replanner.tick(0)
    assert first.reaches_goal and first.start_hitch_angle == 0.3
    assert pickle.loads(pickle.dumps(first)).start_hitch_angle == 0.3
    near = replanner.tick(0, pose=lane.start, hitch_angle=0.4)
    assert near.outcome == "kept" and near.start_hitch_angle == 0.3
    other = replanner.tick(0, pose=lane.start, hitch_angle=-0.5)
    assert other.is_safe and other.start_hitch_angle == -0.5
    folded = replanner.tick(0, pose=lane.start, hitch_angle=1.5)
    assert not folded and "folded up" in folded.reason
    with pytest.raises(vp.InputError, match=r"state.hitch_angle: is 4, expected -pi to pi"):
        replanner.tick(0, pose=lane.start, hitch_angle=4)
    with pytest.raises(vp.InputError, match="hitch_angle: is given without a pose"):
        replanner.tick(0, hitch_angle=0.1)


def test_cells_that_are_seen_are_patched():
    scenario = vp.Scenario((5, 10, 0), (32, 10, 0), map=np.zeros((100, 200), bool), resolution=0.2)
    replanner = vp.Replanner(scenario, max_iterations=500)
    first = replanner.tick(0)
    assert first.reaches_goal
    replanner.patch(cells=[(40, 120, np.ones((20, 4), bool))])
    assert replanner.tick(0.1).drive.path != first.drive.path
    with pytest.raises(vp.InputError, match="cells"):
        replanner.patch(cells=[(0, 0)])
    with pytest.raises(vp.InputError):
        replanner.patch(cells=[(99, 0, np.ones((2, 2), bool))])


def test_a_drive_in_a_closed_loop_waits_for_what_comes(street):
    actions = []
    busy = street.with_moving([crossing_car(8)])
    live = vp.drive_live(busy, max_iterations=500, action_rate=2, on_action=actions.append, period=0.5)
    assert live and live.end_distance < 0.5 and live.moving_clearance > 0
    assert live.ticks > 10 and live.driven.duration == pytest.approx(live.duration, abs=0.1)
    assert {"t", "steering_angle", "v", "a"} == set(actions[0])
    with pytest.raises(vp.InputError, match="period"):
        vp.drive_live(street, period=0.01)
    with pytest.raises(vp.InputError, match="prediction"):
        vp.drive_live(street, prediction="hope")


def test_what_a_callback_raises_arrives(street):
    def stop(action):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        vp.drive_live(street, max_iterations=100, action_rate=1, on_action=stop)


def test_a_wall_in_the_way_is_seen_late():
    walled = vp.Scenario((-40, 0, 0), (40, 0, 0), bounds=(-60, 60, -40, 40), obstacles=[WALL])
    live = vp.drive_live(walled, max_iterations=500, sensor_range=15, period=0.5, longest=200)
    assert live.contact is None and live.ticks > 0


def test_plans_and_drives_are_recorded(yard, street, tmp_path):
    file = tmp_path / "r.mcap"
    result = vp.plan(yard, max_iterations=500)
    vp.record(yard, result, file)
    plan = file.read_bytes()
    assert plan.startswith(b"\x89MCAP0\r\n") and b"foxglove.SceneUpdate" in plan and b"/improvement" in plan
    vp.record(yard, result, file, vp.drive(yard, result, keep_log=True))
    assert b"/driven" in file.read_bytes() and b"/improvement" not in file.read_bytes()
    live = vp.drive_live(street, max_iterations=500, period=0.5, keep_log=True)
    vp.record(street, None, file, drive=live)
    assert b"/driven" in file.read_bytes() and b"/plan" not in file.read_bytes()
    with pytest.raises(vp.InputError, match="drive: has no log, expected keep_log=True"):
        vp.record(yard, result, file, vp.drive(yard, result))
    with pytest.raises(vp.InputError, match="drive: expected a DriveResult"):
        vp.record(yard, result, file, result)
