# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Draws scenarios and paths with matplotlib."""

from __future__ import annotations

import math

from vandplan._core import Path, Result, Scenario, SpeedProfile

TYPE_CHECKING = False  # importing typing takes longer than everything else
if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

_OBSTACLE = "0.55"
_KERB = "#d9b77e"
_SWEPT = "#cfe3f4"
_FORWARD = "#1f5f99"
_REVERSE = "#c2410c"
_START = "#2e7d32"
_GOAL = "#8e24aa"


def _outlines(scenario: Scenario, poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Corners of the body at each pose [m]; shape (N, 4, 2)."""
    import numpy as np

    v = scenario.vehicle
    front, rear, half = v.wheelbase + v.front_overhang, -v.rear_overhang, v.width / 2
    body = np.array([[rear, -half], [front, -half], [front, half], [rear, half]])
    cos, sin = np.cos(poses[:, 2, None]), np.sin(poses[:, 2, None])
    x = poses[:, 0, None] + cos * body[:, 0] - sin * body[:, 1]
    y = poses[:, 1, None] + sin * body[:, 0] + cos * body[:, 1]
    return np.stack([x, y], axis=-1)


def _draw_grid(ax: Axes, scenario: Scenario) -> None:
    import numpy as np
    from matplotlib.transforms import Affine2D

    grid = scenario.map
    if grid is None:
        return
    shades = np.full((*grid.shape, 4), 1.0)
    shades[..., 3] = 0.0
    shades[grid.cells > 0] = (0.35, 0.35, 0.35, 1.0)
    shades[grid.cells < 0] = (0.8, 0.8, 0.8, 1.0)
    x, y, heading = grid.origin
    rows, columns = grid.shape
    image = ax.imshow(
        shades,
        origin="lower",
        interpolation="nearest",
        extent=(0, columns * grid.resolution, 0, rows * grid.resolution),
        zorder=1,
    )
    image.set_transform(Affine2D().rotate(heading).translate(x, y) + ax.transData)
    corners = grid.outline
    ax.update_datalim(corners)


def _draw_polygons(ax: Axes, scenario: Scenario) -> None:
    from matplotlib.patches import Polygon

    for corners in scenario.obstacles:
        ax.add_patch(Polygon(corners, closed=True, facecolor=_OBSTACLE, edgecolor="0.3", zorder=2))
    for corners in scenario.kerbs:
        ax.add_patch(Polygon(corners, closed=True, facecolor=_KERB, edgecolor="0.3", zorder=2))


def _draw_vehicle(ax: Axes, scenario: Scenario, pose: NDArray[np.float64], colour: str) -> None:
    from matplotlib.patches import Polygon

    outline = _outlines(scenario, pose[None])[0]
    ax.add_patch(Polygon(outline, closed=True, fill=False, edgecolor=colour, linewidth=2, zorder=6))
    reach = 0.4 * scenario.vehicle.wheelbase
    ax.annotate(
        "",
        xy=(pose[0] + reach * math.cos(pose[2]), pose[1] + reach * math.sin(pose[2])),
        xytext=(pose[0], pose[1]),
        arrowprops={"arrowstyle": "->", "color": colour},
        zorder=6,
    )


def _draw_path(ax: Axes, scenario: Scenario, path: Path) -> None:
    import numpy as np
    from matplotlib.collections import LineCollection, PolyCollection

    step = max(path.length / 2000, 0.05)
    poses = path.poses(step)
    swept = _outlines(scenario, path.poses(max(path.length / 500, 0.2)))
    ax.add_collection(PolyCollection(swept, facecolor=_SWEPT, edgecolor=_SWEPT, zorder=0.5))
    direction = path.sampled(step)["direction"][:-1]
    pieces = np.stack([poses[:-1, :2], poses[1:, :2]], axis=1)
    for sign, colour, label in ((1, _FORWARD, "forward"), (-1, _REVERSE, "reverse")):
        driven = pieces[direction == sign]
        if len(driven) > 0:
            lines = LineCollection(driven, colors=colour, linewidths=2, label=label, zorder=5)
            ax.add_collection(lines)
    ax.update_datalim(swept.reshape(-1, 2))


def _draw_tree(ax: Axes, tree: tuple[NDArray[np.float64], NDArray[np.int32]] | None) -> None:
    import numpy as np
    from matplotlib.collections import LineCollection

    if tree is None:
        return
    poses, parents = tree
    nodes = np.flatnonzero(parents >= 0)
    edges = np.stack([poses[parents[nodes], :2], poses[nodes, :2]], axis=1)
    ax.add_collection(LineCollection(edges, colors="0.6", linewidths=0.5, zorder=3))


def plot(
    scenario: Scenario,
    result: Result | SpeedProfile | Path | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Draws a scenario with matplotlib, and a result, drive or path in it. Returns the axes.

    Obstacles are grey, kerbs brown, the swept area is light blue. The path is blue forward and
    orange in reverse; the vehicle is green at the start and purple at the goal. Axes are in metres.
    Without `ax` a new figure is made. Raises TypeError for a wrong type.
    """
    import numpy as np

    if not isinstance(scenario, Scenario):
        raise TypeError(f"scenario: a {type(scenario).__name__} is none")
    if result is not None and not isinstance(result, (Result, SpeedProfile, Path)):
        raise TypeError(f"result: a {type(result).__name__} cannot be drawn")
    if ax is not None and not hasattr(ax, "add_patch"):
        raise TypeError(f"ax: a {type(ax).__name__} is no axes of matplotlib")
    if ax is None:
        import matplotlib.pyplot as plt

        ax = plt.subplots(figsize=(8, 6))[1]
    _draw_grid(ax, scenario)
    _draw_polygons(ax, scenario)
    path = result if result is None or isinstance(result, Path) else result.path
    if isinstance(result, Result):
        _draw_tree(ax, result.tree)
    if path is not None:
        _draw_path(ax, scenario, path)
    _draw_vehicle(ax, scenario, scenario.start, _START)
    _draw_vehicle(ax, scenario, scenario.goal, _GOAL)
    ends = _outlines(scenario, np.stack([scenario.start, scenario.goal]))
    ax.update_datalim(ends.reshape(-1, 2))
    for corners in scenario.obstacles + scenario.kerbs:
        ax.update_datalim(corners)
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.set_xlabel("x [m]")
    ax.set_ylabel("y [m]")
    if path is not None:
        ax.legend(loc="best")
    return ax
