# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""What others read our objects by: numpy, shapely and geopandas, notebooks."""

import math
import pickle
import re
import warnings
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import REPOSITORY, WALL

import vandplan as vp

SVG = "{http://www.w3.org/2000/svg}"


def test_a_path_is_an_array_of_its_poses():
    path = vp.Path((1, 2, 0), [(0, 3), (0.1, -2)])
    assert np.array_equal(np.asarray(path), path.poses())
    assert np.asarray(path, dtype=np.float32).dtype == np.float32
    with pytest.raises(ValueError, match="copy"):
        path.__array__(copy=False)
    assert vp.reeds_shepp_length(path, path.end_pose, 7)[-1] == pytest.approx(0, abs=1e-9)


def polygons(yard):
    truck = vp.MovingObstacle(vp.Vehicle().outline, [(0, 0, 0, 0)])
    grid = vp.OccupancyGrid(np.zeros((4, 6), bool), 0.5)
    region = vp.GoalRegion(area=[(0, 0), (3, 0), (3, 2)])
    return {"obstacle": yard.obstacles[0], "vehicle": vp.Vehicle().outline, "moving": truck.outline,
            "grid": grid.outline, "region": region.area}


def test_polygons_are_arrays_that_say_their_geometry(yard):
    for name, polygon in polygons(yard).items():
        assert isinstance(polygon, np.ndarray), name
        ring = polygon.__geo_interface__["coordinates"][0]
        assert ring[0] == ring[-1] and np.array_equal(ring[:-1], polygon), name
        assert np.array_equal(pickle.loads(pickle.dumps(polygon)), polygon)
    moved = yard.obstacles[0] + (1, 2)
    assert moved.__geo_interface__["coordinates"][0][0] == (WALL[0][0] + 1, WALL[0][1] + 2)
    assert not hasattr(yard.obstacles[0][:, 0], "__geo_interface__")
    assert not hasattr(yard.obstacles[0].mean(axis=0), "__geo_interface__")


def test_shapely_reads_polygons_and_paths(yard):
    geometry = pytest.importorskip("shapely.geometry")
    areas = {"obstacle": 70, "grid": 6, "region": 3}
    for name, polygon in polygons(yard).items():
        shape = geometry.shape(polygon)
        assert shape.geom_type == "Polygon" and shape.is_valid
        assert shape.area == pytest.approx(areas.get(name, shape.area)) and shape.area > 0
    path = vp.reeds_shepp((0, 0, 0), (3, 9, 2), 7)
    assert geometry.shape(path).length == pytest.approx(path.length, rel=1e-3)
    standing = geometry.shape(vp.Path((1, 2, 0), []))
    assert standing.geom_type == "LineString" and standing.length == 0


def test_polygons_of_shapely_are_obstacles():
    geometry = pytest.importorskip("shapely.geometry")
    box, other = geometry.box(2, 2, 4, 5), geometry.box(-5, -5, -4, -4)
    for given in ([box, other], geometry.MultiPolygon([box, other]), [geometry.MultiPolygon([box, other])]):
        scenario = vp.Scenario((0, 0, 0), (9, 0, 0), bounds=(-20, 20, -20, 20), obstacles=given, kerbs=[[(9, 9), (10, 9), (9, 10)]])
        assert [len(corners) for corners in scenario.obstacles] == [4, 4]
        assert geometry.shape(scenario.obstacles[0]).equals(box)
    assert vp.GoalRegion(area=box).area.shape == (4, 2)
    again = vp.Scenario((0, 0, 0), (9, 0, 0), bounds=(-20, 20, -20, 20), obstacles=scenario.obstacles)
    assert np.array_equal(again.obstacles[1], scenario.obstacles[1])


@pytest.mark.parametrize(
    ("shape", "message"),
    [
        ({"type": "Polygon", "coordinates": [[(0, 0), (9, 0), (9, 9)], [(1, 1), (2, 1), (2, 2)]]}, "has a hole"),
        ({"type": "LineString", "coordinates": [(0, 0), (9, 0)]}, "is a LineString, expected a Polygon"),
    ],
)
def test_other_shapes_are_refused_by_name(shape, message):
    class Shape:
        __geo_interface__ = {"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": shape}]}

    with pytest.raises(vp.InputError, match=rf"obstacles\[0\]: {message}"):
        vp.Scenario((0, 0, 0), (9, 0, 0), bounds=(-9, 9, -9, 9), obstacles=[Shape()])
    with pytest.raises(vp.InputError, match=f"kerbs: {message}"):
        vp.Scenario((0, 0, 0), (9, 0, 0), bounds=(-9, 9, -9, 9), kerbs=Shape())
    with pytest.raises(vp.InputError, match=f"area: {message}"):
        vp.GoalRegion(area=Shape())


def test_geopandas_makes_a_frame_of_a_scenario():
    geopandas = pytest.importorskip("geopandas")
    scenario = vp.Scenario(
        (0, 0, 0), [vp.GoalRegion(9, 0), vp.GoalRegion(area=[(5, 5), (8, 5), (8, 8)])], bounds=(-9, 19, -9, 9),
        obstacles=[[(2, 4), (3, 4), (3, 5)]] * 2, kerbs=[[(-2, -4), (-3, -4), (-3, -5)]], inside=[[(-50, -50), (50, -50), (0, 90)]],
        map=np.zeros((4, 4), bool), resolution=1.0,
    )
    frame = geopandas.GeoDataFrame.from_features(scenario)
    assert list(frame.what) == ["bounds", "map", "obstacles", "obstacles", "kerbs", "inside", "goal_set", "start", "goal"]
    assert list(frame["index"]) == [0, 0, 0, 1, 0, 0, 1, 0, 0]
    assert frame.total_bounds == pytest.approx([-50, -50, 50, 90])
    obstacles = frame[frame.what == "obstacles"].geometry
    assert len(vp.Scenario((0, 0, 0), (9, 0, 0), bounds=(-9, 19, -9, 9), obstacles=obstacles).obstacles) == 2


def svg_of(thing):
    return svg_in(thing._repr_html_())


def svg_in(text):
    page = ElementTree.fromstring(text)
    assert page.tag == "div" and [child.tag for child in page] == [SVG + "svg"]
    return page[0]


def ids_of(svg):
    return [element.get("id") for element in svg.iter() if element.get("id")]


def test_pictures_in_notebooks_show_footprints_under_the_mouse(yard):
    result = vp.plan(yard, max_iterations=1000)
    for thing in (result, result.path, vp.speed_profile(yard, result)):
        svg = svg_of(thing)
        places = [g for g in svg.iter(SVG + "g") if g.get("class") == "vandplan-place"]
        assert len(places) > 20
        body = places[0].find(SVG + "use").get("href")
        assert body[1:] in ids_of(svg)
        title = places[0].find(SVG + "title").text
        assert title.startswith("0.0 m ") and "heading 0.0°" in title
        assert any("vandplan-place:hover" in style.text for style in svg.iter(SVG + "style"))
        # Nothing comes from elsewhere, and nothing runs.
        text = thing._repr_html_()
        assert not list(svg.iter(SVG + "script")) and "onclick" not in text
        assert all(address.startswith(("#", "data:")) for address in re.findall(r'href="([^"]*)"', text))
        assert len(text) < 300_000


def test_a_footprint_is_where_the_vehicle_is():
    path = vp.Path((3, 4, 0.5), [(0, 2)])
    uses = [use.get("transform") for use in svg_of(path).iter(SVG + "use") if "vandplan-body" in use.get("href", "")]
    turned = f"{math.degrees(0.5):.2f}"
    assert uses[0] == f"translate(3.000,4.000) rotate({turned})"
    end = path.end_pose
    assert uses[-1] == f"translate({end[0]:.3f},{end[1]:.3f}) rotate({turned})"


def test_a_page_may_hold_many_pictures(yard):
    text = yard._repr_html_()
    own, others = (set(ids_of(svg)) for svg in (svg_in(text), svg_of(yard.with_poses(goal=(5, 12, 0)))))
    assert own and not own & others
    named = set(re.findall(r'(?:url\(|href=")#([\w-]+)', text))
    assert named and named <= own


def test_a_scenario_is_shown_with_the_numbers_of_its_obstacles(yard):
    titles = [title.text for title in svg_of(yard).iter(SVG + "title")]
    assert titles == ["obstacles[0]"]
    assert "vandplan-trailer" in vp.Result._repr_html_(vp.plan(vp.read_scenario(REPOSITORY / "scenarios/trailer/dock.yaml"), max_iterations=500))


def test_the_scenario_comes_first(yard, tmp_path):
    result = vp.plan(yard, max_iterations=500)
    result.save(tmp_path / "r.json")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = vp.read_result(yard, tmp_path / "r.json")
        fastest = vp.speed_profile(yard, result)
        assert vp.speed_profile(yard.vehicle, result.path).duration == fastest.duration
        assert vp.speed_profile("city-bus", result.path).vehicle == vp.Vehicle.named("city-bus")
    turned = vp.Scenario(yard.start, yard.goal, bounds=yard.bounds, start_curvature=0.1)
    assert vp.speed_profile(turned, result.path).duration > fastest.duration
    assert vp.speed_profile(turned, result.path, 0).duration == fastest.duration
    # For one version in the old order, too.
    with pytest.warns(DeprecationWarning, match=r"read_result\(scenario, file\)"):
        assert vp.read_result(tmp_path / "r.json", yard).path == again.path
    for call in (
        lambda: vp.speed_profile(result),
        lambda: vp.speed_profile(result.path, yard.vehicle),
        lambda: vp.speed_profile(result, vehicle=yard.vehicle),
        lambda: vp.speed_profile(path=result.path, vehicle=yard.vehicle, start_curvature=0.0),
    ):
        with pytest.warns(DeprecationWarning, match=r"speed_profile\(scenario, path\)"):
            assert call().duration == fastest.duration
    with pytest.raises(vp.InputError, match="vehicle: is that of the scenario"):
        vp.speed_profile(yard, result, vehicle="city-bus")
