# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Lengths between arrays of poses, and the nearest of many nodes."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import vandplan as vp

RADIUS = 7.0

numbers = st.floats(-1e4, 1e4, width=32)
pose_arrays = arrays(np.float64, st.tuples(st.integers(0, 20), st.just(3)), elements=numbers)
one_pose = st.tuples(numbers, numbers, numbers)


def test_a_worked_example():
    assert vp.reeds_shepp_length((0, 0, 0), (10, 0, 0), RADIUS) == 10.0
    assert vp.reeds_shepp_length((0, 0, 0), (-10, 0, 0), RADIUS) == 10.0
    half_turn = vp.dubins_length((0, 0, 0), (0, 2 * RADIUS, math.pi), RADIUS)
    assert half_turn == pytest.approx(math.pi * RADIUS)


def test_single_poses_give_a_float_and_arrays_an_array(random_poses):
    poses = random_poses(4)
    assert isinstance(vp.reeds_shepp_length(poses[0], poses[1], RADIUS), float)
    assert isinstance(vp.reeds_shepp_length([0, 0, 0], (1, 2, 3), RADIUS), float)
    assert vp.reeds_shepp_length(poses, poses[0], RADIUS).shape == (4,)
    assert vp.reeds_shepp_length(poses[:1], poses, RADIUS).shape == (4,)
    assert vp.reeds_shepp_length(poses[:1], poses[0], RADIUS).shape == (1,)
    assert vp.reeds_shepp_length(poses[:0], poses[0], RADIUS).shape == (0,)
    assert vp.reeds_shepp_length(poses[:0], poses[:1], RADIUS).shape == (0,)


@pytest.mark.parametrize("exact", [False, True])
def test_poses_fit_together_by_the_rules_of_numpy(random_poses, exact):
    starts, goals = random_poses(5), random_poses(3)
    table = vp.reeds_shepp_length(starts[:, None], goals[None], RADIUS, exact)
    assert table.shape == (5, 3)
    for i in range(5):
        for j in range(3):
            assert table[i, j] == vp.reeds_shepp_length(starts[i], goals[j], RADIUS)
    cube = random_poses(24).reshape(2, 3, 4, 3)
    many = vp.reeds_shepp_length(cube, cube[:, :1], RADIUS)
    assert many.shape == (2, 3, 4)
    assert many[1, 2, 3] == vp.reeds_shepp_length(cube[1, 2, 3], cube[1, 0, 3], RADIUS)


@given(pose_arrays, one_pose, st.floats(0.1, 100))
def test_many_are_the_same_bits_as_one_after_the_other(starts, goal, radius):
    fast = vp.reeds_shepp_length(starts, goal, radius)
    exact = vp.reeds_shepp_length(starts, goal, radius, exact=True)
    assert np.array_equal(fast.view(np.uint64), exact.view(np.uint64))


@given(one_pose, one_pose, st.floats(0.1, 100))
def test_laws_of_lengths(start, goal, radius):
    length = vp.reeds_shepp_length(start, goal, radius)
    tolerance = 1e-9 * (length + radius)
    assert length >= math.dist(start[:2], goal[:2]) - tolerance
    assert length == pytest.approx(vp.reeds_shepp_length(goal, start, radius), abs=tolerance)
    assert length <= vp.dubins_length(start, goal, radius) + tolerance
    low, high = vp.length_bounds(start, goal, radius)
    assert low <= length + tolerance and length <= high + tolerance
    continuous = vp.continuous_length(start, goal, radius, 1 / radius**2)
    assert continuous >= length - tolerance


def test_every_function_takes_arrays(random_poses):
    starts, goals = random_poses(6), random_poses(6)
    for i, (a, b) in enumerate(zip(starts, goals)):
        assert vp.dubins_length(starts, goals, RADIUS)[i] == vp.dubins_length(a, b, RADIUS)
        low, high = vp.length_bounds(starts, goals, RADIUS)
        assert (low[i], high[i]) == vp.length_bounds(a, b, RADIUS)
        turning = vp.continuous_length(starts, goals, RADIUS, 0.05, "throughout")
        assert turning[i] == vp.continuous_length(a, b, RADIUS, 0.05, "throughout")


def test_other_memory_layouts_mean_the_same(random_poses):
    poses = random_poses(10)
    expected = vp.reeds_shepp_length(poses, (0, 0, 0), RADIUS)
    for same in (np.asfortranarray(poses), poses.tolist(), poses[::-1][::-1]):
        assert np.array_equal(vp.reeds_shepp_length(same, (0, 0, 0), RADIUS), expected)
    wide = np.hstack([poses, poses])[:, :3]
    assert np.array_equal(vp.reeds_shepp_length(wide, (0, 0, 0), RADIUS), expected)
    whole = np.array([[1, 2, 3]])
    assert vp.reeds_shepp_length(whole, (0, 0, 0), RADIUS)[0] == vp.reeds_shepp_length(
        (1.0, 2.0, 3.0), (0, 0, 0), RADIUS
    )


@pytest.mark.parametrize(
    ("starts", "goals", "radius", "where"),
    [
        ("here", (0, 0, 0), 7, "starts"),
        ((0, 0), (0, 0, 0), 7, "starts"),
        ((0, 0, 0), np.zeros((2, 4)), 7, "goals"),
        (np.zeros((2, 3)), np.zeros((3, 3)), 7, "starts, goals"),
        ((0, 0, 0), (1, 1, 1), 0, "radius"),
        ((0, 0, 0), (1, 1, 1), float("nan"), "radius"),
    ],
)
def test_what_is_no_pose_is_refused(starts, goals, radius, where):
    with pytest.raises(ValueError) as refused:
        vp.reeds_shepp_length(starts, goals, radius)
    assert isinstance(refused.value, vp.InputError)
    assert refused.value.where == where
    assert str(refused.value) == f"{where}: {refused.value.problem}"


def test_nearest_is_what_comparing_all_lengths_finds(random_poses):
    nodes, samples = random_poses(300), random_poses(40)
    index, length = vp.nearest(nodes, samples, RADIUS)
    table = vp.reeds_shepp_length(samples[:, None], nodes[None], RADIUS)
    assert np.array_equal(index, table.argmin(axis=1))
    assert np.array_equal(length, table.min(axis=1))
    kept = vp.NearestNodes(RADIUS, nodes[:100])
    kept.add(nodes[100:])
    assert len(kept) == 300
    assert kept.nearest(samples[0]) == (index[0], length[0])
    assert kept.nearest(tuple(samples[0])) == (index[0], length[0])


def test_near_nodes_come_in_order_without_those_that_were_removed(random_poses):
    nodes, sample = random_poses(200), random_poses(1)[0]
    kept = vp.NearestNodes(RADIUS, nodes)
    lengths = vp.reeds_shepp_length(nodes, sample, RADIUS)
    order = np.argsort(lengths, kind="stable")
    index, length = kept.near(sample, count=5)
    assert np.array_equal(index, order[:5]) and np.array_equal(length, lengths[order[:5]])
    within = lengths[order[20]]
    assert np.array_equal(kept.near(sample, within=within)[0], order[:21])
    assert np.array_equal(kept.near(sample, count=3, within=within)[0], order[:3])
    for node in order[:2]:
        kept.remove(node)
    for nodes in (kept, pickle.loads(pickle.dumps(kept))):
        assert len(nodes) == 198 and nodes.nearest(sample)[0] == order[2]
        assert np.array_equal(nodes.near(sample, count=1)[0], order[2:3])
    for node in (order[0], -1, 200):
        with pytest.raises(vp.InputError, match="node"):
            kept.remove(node)
    for within in (-1, math.nan):
        with pytest.raises(vp.InputError, match="within"):
            kept.near(sample, within=within)


def test_nodes_that_are_none_or_not_finite_are_refused():
    with pytest.raises(vp.InputError, match="expected one at least"):
        vp.NearestNodes(RADIUS).nearest((0, 0, 0))
    with pytest.raises(vp.InputError, match=r"nodes\[1\]"):
        vp.nearest([(0, 0, 0), (math.nan, 0, 0)], (0, 0, 0), RADIUS)
