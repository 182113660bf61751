# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""What a user with mypy --strict writes: every wrong line is marked, every other one is right."""

from __future__ import annotations

import pathlib

import numpy as np
from numpy.typing import NDArray

import vandplan as vp


def lengths(poses: NDArray[np.float64]) -> float:
    one: float = vp.reeds_shepp_length((0, 0, 0), (1.0, 2.0, 3.0), 7)
    many = vp.reeds_shepp_length(poses, poses[0], 7, exact=True)
    index, _ = vp.nearest(poses, (0, 0, 0), 7)
    vp.reeds_shepp_length(poses, poses, "wide")  # type: ignore[call-overload]
    return one + float(many.sum()) + float(vp.dubins_length([0, 0, 0], [1, 1, 1], 7)) + index


def straight(task: vp.Task) -> vp.Path | None:
    while task.next():
        if task.is_free(task.start):
            return task.steer(task.start, task.goal)
    return None


def wrong(task: vp.Task) -> str:
    return "left"


def plans(folder: pathlib.Path) -> None:
    grid = vp.OccupancyGrid(np.zeros((40, 40), dtype=bool), 0.5)
    vehicle = vp.Vehicle(wheelbase=3.0, max_speed=(2.0, 1.0))
    yard = vp.Scenario((5, 5, 0), (12, 5, 0), map=grid, vehicle=vehicle, options={"margin": 0.1})
    result = vp.plan(yard, time_limit=0.1, style="shortest", threads=2)
    if result.path is not None:
        poses: NDArray[np.float64] = result.path.poses(0.5)
        clearance: float | None = vp.check(yard, result).clearance
        print(poses.shape, clearance, vp.speed_profile(yard, result).duration)
    result.path.poses()  # type: ignore[union-attr]
    vp.plan(yard, straight)
    vp.plan(yard, vp.Planner("straight", straight, options={"share": (0.2, 0, 1)}))
    vp.plan(yard, wrong)  # type: ignore[arg-type]
    vp.plan(yard, time_limit="soon")  # type: ignore[call-overload]
    vp.Scenario((0, 0, 0), (1, 0, 0), bouns=(0, 1, 0, 1))  # type: ignore[call-arg]
    for one in vp.plan_many(yard, [yard.start], yard.goal, jobs=2):
        one.save(folder / "r.json")
    runs = vp.compare([yard], ["anytime", straight], folder).runs()
    print(len(runs), vp.read_store(folder / "runs.sqlite"))
    vp.plot(yard, result).set_title("yard")


def options(yard: vp.Scenario, planner: str) -> None:
    vp.plan(yard, margin=0.3, style="shortest", steering="continuous", gears="forward", cost="time", threads=2)
    vp.plan(yard, planner, estimate="choi", keep_tree=True, max_nodes=100, goal_bias=0.1)
    vp.plan(yard, time=0.1)  # an old name
    vp.plan_many(yard, [yard.start], yard.goal, threads=2)  # an old name
    vp.plan(yard, time="soon")  # type: ignore[call-overload]
    vp.plan(yard, tme=3)  # type: ignore[call-overload]
    vp.plan(yard, style="foo")  # type: ignore[call-overload]
    vp.plan(yard, margin="wide")  # type: ignore[call-overload]
    vp.plan(yard, keep_tree="yes")  # type: ignore[call-overload]
    mine = vp.Planner("mine", straight, options={"share": 0.2})
    vp.plan(yard, mine, share=0.3)
    vp.plan_many(yard, [yard.start], yard.goal, margin=0.3, jobs=2)
    vp.plan_many(yard, [yard.start], yard.goal, marign=0.3)  # type: ignore[call-overload]
    vp.smooth(yard, vp.plan(yard), margin=0.3)
    vp.smooth(yard, vp.plan(yard), tme=3)  # type: ignore[call-arg]
    vp.drive_live(yard, steering="foo")  # type: ignore[arg-type]
    vp.Replanner(yard, tme=3)  # type: ignore[call-arg]
    vp.compare([yard], ["anytime", straight, mine], "out", margin=0.3)
    vp.compare([yard], ["anytime"], "out", tme=3)  # type: ignore[list-item]
    vp.compare([yard], [mine], "out", share=0.3)


class Shape:
    @property
    def __geo_interface__(self) -> dict[str, object]:
        return {}


def shapes(yard: vp.Scenario, result: vp.Result) -> None:
    vp.Scenario((0, 0, 0), (1, 0, 0), obstacles=[Shape(), yard.obstacles[0]], kerbs=Shape())
    vp.Scenario((0, 0, 0), (1, 0, 0), obstacles=3)  # type: ignore[arg-type]
    print(yard.obstacles[0].__geo_interface__, yard.__geo_interface__, yard._repr_html_())
    if result.path is not None:
        print(np.asarray(result.path), result.path.__geo_interface__)
    vp.read_result(yard, "r.json")
    vp.read_result("r.json", "r.json")  # type: ignore[call-overload]


def ends(yard: vp.Scenario) -> int:
    docks = [vp.GoalRegion(3.0 * i, 4, "any") for i in range(3)]
    vp.GoalRegion(3, 4, "north")  # type: ignore[arg-type]
    reached: vp.ReachedGoal | None = vp.plan(yard.with_poses(goal=docks)).goal
    return reached.index if reached else len(vp.Scenario((0, 0, 0), docks[0]).goal_set)


def drives(yard: vp.Scenario, result: vp.Result) -> float:
    car = vp.MovingObstacle([(0, 0), (1, 0), (1, 1)], [(0, 0, 0, 0)], after="leaves")
    busy = yard.with_moving([car])
    speeds: vp.SpeedProfile | None = vp.plan(busy).speeds
    vp.MovingObstacle([(0, 0), (1, 0), (1, 1)], [(0, 0, 0, 0)], after="flies")  # type: ignore[arg-type]
    vp.drive(yard, result, noise="loud")  # type: ignore[arg-type]
    answer = vp.Replanner(busy, max_iterations=100).tick(0.0, (0, 0, 0), v=1)
    live = vp.drive_live(busy, sensor_range=20, on_action=print)
    contact: vp.Contact | None = vp.drive(yard, result, noise=1).contact
    print(speeds, contact, answer.is_safe, vp.check(yard, result).drive)
    return live.driven.duration
