# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Pictures by matplotlib."""

import numpy as np
import pytest

import vandplan as vp

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")


def test_everything_is_in_the_picture(yard, tmp_path):
    import matplotlib.pyplot as plt

    result = vp.plan(yard, max_iterations=1000)
    axes = vp.plot(yard, result)
    x, y = axes.get_xlim(), axes.get_ylim()
    assert x[0] <= -20 and x[1] >= 15 and y[0] <= 0 and y[1] >= 12
    poses = result.path.poses(0.1)
    assert x[0] <= poses[:, 0].min() and x[1] >= poses[:, 0].max()
    labels = {text.get_text() for text in axes.get_legend().get_texts()}
    assert labels == {"forward", "reverse"} if result.path.gear_changes else {"forward"}
    axes.figure.savefig(tmp_path / "yard.png")
    plt.close(axes.figure)


def test_it_draws_into_given_axes_a_path_or_nothing(yard):
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2)
    assert vp.plot(yard, ax=left) is left
    assert vp.plot(yard, vp.reeds_shepp(yard.start, yard.goal, 7), ax=right) is right
    assert left.get_legend() is None and right.get_legend() is not None
    plt.close(figure)


def test_a_turned_grid_lies_where_it_is():
    import matplotlib.pyplot as plt

    cells = np.zeros((20, 40), dtype=np.int8)
    cells[:, 20] = 100
    cells[0, 0] = -1
    scenario = vp.Scenario(
        (0, 2, 1.57), (0, 4, 1.57), map=vp.OccupancyGrid(cells, 1.0, origin=(5, 0, np.pi / 2), unknown_is_free=True)
    )
    axes = vp.plot(scenario, vp.plan(scenario, "rrt-opt-euc", max_iterations=50, keep_tree=True))
    axes.figure.canvas.draw()
    picture = np.asarray(axes.figure.canvas.buffer_rgba())
    to_pixel = axes.transData.transform

    def shade(x, y):
        column, row = to_pixel((x, y))
        return picture[picture.shape[0] - 1 - int(row), int(column), 0]

    assert shade(-14.5, 20.5) < 120  # column 20 is 20 m up, row 19 is 19 m to the left
    assert shade(-14.5, 30.5) == 255
    assert 150 < shade(4.5, 0.5) < 230  # cells[0, 0] is unknown
    plt.close(axes.figure)
