# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Polygons and paths as shapely and geopandas know them: objects with `__geo_interface__`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from vandplan._core import Path, Scenario
from vandplan.stores import refusal

if TYPE_CHECKING:
    _Array = np.ndarray[Any, np.dtype[np.float64]]
else:
    _Array = np.ndarray


class Polygon(_Array):
    """Corners of a polygon [m]: an array of shape (N, 2) that shapely and geopandas read, too."""

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        if self.ndim != 2 or self.shape[1] != 2 or len(self) < 3:
            raise AttributeError(f"an array of the shape {self.shape} is no polygon")
        return _polygon(self.tolist())


def _polygon(corners: Iterable[Iterable[float]]) -> dict[str, Any]:
    ring = [tuple(corner) for corner in corners]
    return {"type": "Polygon", "coordinates": ((*ring, ring[0]),)}


def rings_of(shape: Any, where: str) -> list[list[tuple[float, float]]]:
    """Corners of each polygon in an object with `__geo_interface__`, or in GeoJSON as dicts.

    Raises InputError naming `where` for a polygon with a hole and for what is no polygon.
    """
    found = getattr(shape, "__geo_interface__", shape)
    kind = found["type"]
    if kind == "Feature":
        return rings_of(found["geometry"], where)
    if kind in ("FeatureCollection", "GeometryCollection"):
        members = found["features" if kind == "FeatureCollection" else "geometries"]
        return [ring for member in members for ring in rings_of(member, where)]
    if kind not in ("Polygon", "MultiPolygon"):
        raise refusal(where, f"is a {kind}, expected a Polygon or MultiPolygon")
    polygons = found["coordinates"] if kind == "MultiPolygon" else [found["coordinates"]]
    if any(len(polygon) > 1 for polygon in polygons):
        raise refusal(where, "has a hole, expected polygons without holes")
    rings = [[(x, y) for x, y, *_ in polygon[0]] for polygon in polygons if polygon]
    return [ring[:-1] if ring[:1] == ring[-1:] else ring for ring in rings]


def line_of(path: Path) -> dict[str, Any]:
    """The line of a path's rear axle, with points at most 0.1 m apart."""
    points = [tuple(point) for point in path.poses()[:, :2].tolist()]
    return {"type": "LineString", "coordinates": tuple(points if len(points) > 1 else points * 2)}


def features_of(scenario: Scenario) -> dict[str, Any]:
    """A feature for each object of a scenario: `what` and `index` name it as the scenario does."""
    features: list[dict[str, Any]] = []

    def add(geometry: dict[str, Any], what: str, index: int = 0, heading: float | None = None) -> None:
        properties = {"what": what, "index": index, "heading": heading}
        features.append({"type": "Feature", "geometry": geometry, "properties": properties})

    x_min, x_max, y_min, y_max = scenario.bounds
    add(_polygon([(x_min, y_min), (x_max, y_min), (x_max, y_max), (x_min, y_max)]), "bounds")
    if scenario.map is not None:
        add(_polygon(scenario.map.outline.tolist()), "map")
    for what in ("obstacles", "kerbs", "inside"):
        for index, corners in enumerate(getattr(scenario, what)):
            add(_polygon(corners.tolist()), what, index)
    for index, region in enumerate(scenario.goal_set):
        if region.area is not None:
            add(_polygon(region.area.tolist()), "goal_set", index)
    for what in ("start", "goal"):
        x, y, heading = getattr(scenario, what).tolist()
        add({"type": "Point", "coordinates": (x, y)}, what, heading=heading)
    return {"type": "FeatureCollection", "features": features}
