# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Plans paths for trucks and buses: drivable, exact, and checked by an independent judge.

    import vandplan as vp

    scenario = vp.Scenario((0, 0, 0), (0, 12, 0), bounds=(-50, 50, -50, 50),
                           obstacles=[[(-20, 5), (15, 5), (15, 7), (-20, 7)]])
    result = vp.plan(scenario, time=0.5)
    print(result.path.poses(step=1.0))

Metres, radians, counter-clockwise; a pose [x, y, heading] is that of the midpoint of the rear axle.
numpy, pandas and matplotlib are imported when they are needed first.
"""

from vandplan._core import (
    Answer,
    Comparison,
    InputError,
    NearestNodes,
    OccupancyGrid,
    Path,
    PathCheck,
    Planner,
    Result,
    Scenario,
    SpeedProfile,
    Task,
    Vehicle,
    __version__,
    check,
    compare,
    continuous_length,
    continuous_path,
    draw,
    dubins,
    dubins_length,
    length_bounds,
    nearest,
    plan,
    plan_many,
    planners,
    read_map,
    read_result,
    read_scenario,
    read_scenarios,
    read_tpcap,
    reeds_shepp,
    reeds_shepp_length,
    smooth,
    speed_profile,
    warm_started,
)
from vandplan.plotting import plot
from vandplan.stores import read_store

__all__ = [
    "Answer",
    "Comparison",
    "InputError",
    "NearestNodes",
    "OccupancyGrid",
    "Path",
    "PathCheck",
    "Planner",
    "Result",
    "Scenario",
    "SpeedProfile",
    "Task",
    "Vehicle",
    "__version__",
    "check",
    "compare",
    "continuous_length",
    "continuous_path",
    "draw",
    "dubins",
    "dubins_length",
    "length_bounds",
    "nearest",
    "plan",
    "plan_many",
    "planners",
    "plot",
    "read_map",
    "read_result",
    "read_scenario",
    "read_scenarios",
    "read_store",
    "read_tpcap",
    "reeds_shepp",
    "reeds_shepp_length",
    "smooth",
    "speed_profile",
    "warm_started",
]
