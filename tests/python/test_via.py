# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""What a path passes before its goal, in Python."""

import pickle

import numpy as np
import pytest

import vandplan as vp


def scenario_via(via, **more):
    return vp.Scenario((0, 0, 0), (40, 0, 0), bounds=(-20, 60, -40, 40), via=via, **more)


def test_a_path_passes_vias():
    gate = vp.GoalRegion((18, 22), (6, 8))
    scenario = scenario_via([(10, 0, 0), gate, vp.Via((30, 4, 0), stop=True)])
    assert [via.stop for via in scenario.via] == [False, False, True]
    assert scenario.via[1].any_of == [gate] and scenario.via[1] == vp.Via(gate)
    result = vp.plan(scenario, max_iterations=4000)
    assert result, result.reason
    assert [passed.s for passed in result.via] == sorted(passed.s for passed in result.via)
    assert np.allclose(result.via[0].pose, [10, 0, 0], atol=1e-5)
    assert result.check.via == result.via
    assert vp.check(scenario, result.path).via == result.via


def test_a_missed_via_is_named():
    free = vp.plan(scenario_via([]), max_iterations=200)
    check = vp.check(scenario_via([(20, 5, 0)]), free.path)
    assert not check and check.reason == "the path does not pass via[0]"


def test_vias_are_kept():
    scenario = scenario_via([vp.Via([vp.GoalRegion(20, 5), vp.GoalRegion(20, -5, 0)], stop=True)])
    assert pickle.loads(pickle.dumps(scenario)).via == scenario.via
    assert "stop: true" in scenario.to_yaml()
    moved = scenario.with_poses(goal=(30, 0, 0))
    assert moved.via == []
    again = moved.with_via(scenario.via)
    assert again.via == scenario.via and np.allclose(again.goal, [30, 0, 0])
    assert vp.plan(again, max_iterations=2000).via


def test_wrong_vias_are_named():
    with pytest.raises(vp.InputError, match=r"via\[0\].straight"):
        scenario_via([vp.GoalRegion(1, 2, 0, straight=3)])
    with pytest.raises(vp.InputError):
        scenario_via([(1, 2)])
