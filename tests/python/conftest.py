# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""What the tests of the Python package share."""

import pathlib

import hypothesis
import numpy as np
import pytest

import vandplan as vp

REPOSITORY = pathlib.Path(__file__).parents[2]

hypothesis.settings.register_profile("repeats", derandomize=True, deadline=None, database=None)
hypothesis.settings.load_profile("repeats")

WALL = [(-20, 5), (15, 5), (15, 7), (-20, 7)]


@pytest.fixture
def yard():
    """A wall between start and goal."""
    return vp.Scenario((0, 0, 0), (0, 12, 0), bounds=(-50, 50, -50, 50), obstacles=[WALL], name="yard")


@pytest.fixture
def random_poses():
    """n poses in a box of 100 m."""
    generator = np.random.default_rng(7)

    def draw(n):
        return generator.uniform([-50, -50, -np.pi], [50, 50, np.pi], (n, 3))

    return draw
