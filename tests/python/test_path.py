# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Paths and the steering functions that make them."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import vandplan as vp

poses = st.tuples(st.floats(-50, 50), st.floats(-50, 50), st.floats(-4, 4))


def turned_by(a, b):
    return abs(math.remainder(a - b, 2 * math.pi))


def test_a_quarter_turn_and_back():
    path = vp.Path((1, 2, 0), [(0.1, 5 * math.pi), (0.0, -3.0)])
    assert path.length == pytest.approx(5 * math.pi + 3)
    assert path.gear_changes == 1
    assert path.end_pose == pytest.approx([11, 9, math.pi / 2])
    assert path.pose_at(5 * math.pi) == pytest.approx([11, 12, math.pi / 2])
    assert path.segments.shape == (2, 3)
    assert np.array_equal(path.start, [1, 2, 0])


def test_poses_at_many_distances():
    path = vp.reeds_shepp((0, 0, 0), (3, 9, 2), 7)
    s = np.linspace(-1, path.length + 1, 12).reshape(3, 4)
    at = path.pose_at(s)
    assert at.shape == (3, 4, 3)
    assert np.array_equal(at[0, 0], path.start)  # clamped
    assert np.array_equal(at[1, 2], path.pose_at(s[1, 2]))
    assert path.pose_at(1.0).shape == (3,)
    assert path.pose_at([]).shape == (0, 3)


def test_samples_are_columns_of_the_poses():
    path = vp.Path((0, 0, 0), [(0.1, 2.0), (0.0, -1.0)])
    samples = path.sampled(0.5)
    assert set(samples) == {"s", "x", "y", "heading", "curvature", "direction"}
    together = np.column_stack([samples["x"], samples["y"], samples["heading"]])
    assert np.array_equal(together, path.poses(0.5))
    assert set(samples["direction"]) == {1, -1}
    steps = np.linalg.norm(np.diff(path.poses(0.5)[:, :2], axis=0), axis=1)
    assert steps.max() <= 0.5 + 1e-12


@given(poses, poses, st.floats(1, 20))
def test_steering_ends_at_the_goal(start, goal, radius):
    for path in (
        vp.reeds_shepp(start, goal, radius),
        vp.dubins(start, goal, radius),
        vp.continuous_path(start, goal, radius, 0.1, "throughout"),
    ):
        assert math.dist(path.end_pose[:2], goal[:2]) < 1e-6
        assert turned_by(path.end_pose[2], goal[2]) < 1e-6
    assert vp.reeds_shepp(start, goal, radius).length == pytest.approx(
        vp.reeds_shepp_length(start, goal, radius)
    )


def test_paths_are_compared_pickled_and_shown():
    path = vp.Path((0, 0, 0), [(0.1, 2.0, 0.0), (0.0, -1.0, 0.5)])
    assert pickle.loads(pickle.dumps(path)) == path
    assert path != vp.Path((0, 0, 0), [(0.1, 2.0)])
    assert path != "path"
    assert repr(path) == "<vandplan.Path: 3.000 m, 2 segments, 1 gear changes>"
    assert vp.Path((0, 0, 0), []).length == 0


def test_what_is_no_path_is_refused():
    with pytest.raises(vp.InputError, match="rows"):
        vp.Path((0, 0, 0), [1, 2, 3])
    with pytest.raises(vp.InputError, match=r"segments\[1\]: is not finite"):
        vp.Path((0, 0, 0), [(0, 1), (0, math.inf)])
    with pytest.raises(vp.InputError, match="step: is 0.0, expected a positive number"):
        vp.Path((0, 0, 0), [(0, 1)]).poses(0)
    with pytest.raises(vp.InputError, match="between-stops or throughout"):
        vp.continuous_path((0, 0, 0), (1, 1, 1), 7, 0.1, "never")
