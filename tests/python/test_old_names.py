# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Names that were replaced work for one version, and warn."""

import warnings

import numpy as np
import pytest

import vandplan as vp


@pytest.fixture
def result(yard):
    return vp.plan(yard, max_iterations=200)


def old(call):
    """What `call` returns, while it warns exactly once."""
    with pytest.warns(DeprecationWarning, match="is deprecated, write ") as caught:
        value = call()
    assert len(caught) == 1
    return value


def test_old_properties_have_the_new_values(result):
    assert old(lambda: result.bound) == result.lower_bound
    assert old(lambda: result.time) == result.time_total
    assert np.array_equal(old(lambda: result.trace), result.anytime)
    assert np.array_equal(old(lambda: result.path.end), result.path.end_pose)
    assert old(lambda: result.scenario.grid) is None
    assert old(lambda: vp.GoalRegion(1, 2).of_trailer) is False


def test_a_bound_that_is_not_proven_is_none(yard):
    stuck = vp.plan(yard, lambda task: None, max_iterations=1)
    assert stuck.lower_bound is None and stuck.gap is None
    assert old(lambda: stuck.bound) == 0


def test_old_methods_return_the_same(result):
    profile = vp.speed_profile(result.scenario, result)
    for before, now in [
        (old(lambda: result.path.samples(0.5)), result.path.sampled(0.5)),
        (old(lambda: result.path.samples()), result.path.sampled()),
        (old(lambda: profile.motions(0.5)), profile.sampled(0.5)),
        (old(lambda: profile.at([1, 2])), profile.motion_at([1, 2])),
    ]:
        assert before.keys() == now.keys()
        assert all(np.array_equal(before[name], now[name]) for name in now)


def test_old_keywords_mean_the_same(yard, tmp_path):
    starts = [yard.start] * 2
    few = {"max_iterations": 50}
    assert old(lambda: vp.plan(yard, time=600, **few)).options["time_limit"] == 600
    path = vp.plan(yard, max_iterations=500)
    assert old(lambda: vp.smooth(yard, path, time=600, **few)).options["time_limit"] == 600
    assert len(old(lambda: vp.plan_many(yard, starts, yard.goal, threads=2, **few))) == 2
    assert old(lambda: vp.Replanner(yard, time=600, **few)).tick(0).reaches_goal
    assert not old(lambda: vp.compare([yard], ["rrt-opt-euc"], tmp_path, repeats=1, time=0.01)).missing
    assert old(lambda: vp.GoalRegion(1, 2, of_trailer=True)) == vp.GoalRegion(1, 2, is_of_trailer=True)
    cells = np.zeros((40, 40), bool)
    park = old(lambda: vp.Scenario((5, 5, 0), (9, 5, 0), grid=cells, resolution=0.5))
    assert park.map.shape == (40, 40)


def test_new_names_do_not_warn(yard, result):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        vp.plan(yard, time_limit=600, max_iterations=20)
        assert result.lower_bound and result.time_total >= 0 and len(result.anytime)


def test_a_place_says_its_gear(yard):
    at = vp.check(yard, vp.Path(yard.start, [[0, -5]])).at
    assert at is None or at["gear"] == "reverse"
    far = vp.check(yard.with_poses(goal=(0, 40, 0)), vp.Path(yard.start, [[0, -60]]))
    assert far.at["gear"] == "reverse" and far.at["direction"] == -1
