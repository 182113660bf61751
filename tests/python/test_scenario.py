# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Scenarios from arguments, arrays and files, vehicles and grids."""

import math
import pickle

import numpy as np
import pytest
from conftest import REPOSITORY, WALL

import vandplan as vp


def test_a_scenario_holds_what_it_was_given():
    scenario = vp.Scenario(
        (1, 2, 0.5),
        np.array([3.0, 4, 0]),
        bounds=(-10, 10, -20, 20),
        obstacles=[np.array(WALL, dtype=float), WALL[:3]],
        kerbs=[[(5, 5), (6, 5), (6, 6)]],
        vehicle="city-bus",
        goal_curvature=0.01,
        name="mine",
        options={"margin": 0.3},
    )
    assert np.array_equal(scenario.start, [1, 2, 0.5])
    assert np.array_equal(scenario.goal, [3, 4, 0])
    assert scenario.bounds == (-10, 10, -20, 20)
    assert [len(polygon) for polygon in scenario.obstacles] == [4, 3]
    assert np.array_equal(scenario.obstacles[0], WALL)
    assert len(scenario.kerbs) == 1
    assert scenario.vehicle == vp.Vehicle.named("city-bus")
    assert scenario.goal_curvature == 0.01
    assert scenario.options == {"margin": "0.3"}
    assert scenario.map is None
    assert "mine" in repr(scenario)


def test_zones_and_masks_are_values(tmp_path):
    area = [(15, -5), (25, -5), (25, 8), (15, 8)]
    lawn = vp.Zone(area, name="lawn", closed=True)
    street = vp.Zone(area, gears="forward", direction=(-1, 1), cost=3, max_speed=2, body=True)
    assert pickle.loads(pickle.dumps([lawn, street])) == [lawn, street] and lawn != street
    assert (street.gears, street.direction, street.cost, street.body) == ("forward", (-1, 1), 3, True)
    keepout = vp.OccupancyGrid([[100, 0], [0, -1]], 2.0, (16, 20, 0))
    scenario = vp.Scenario(
        (0, 0, 0), (40, 0, 0), bounds=(-30, 80, -40, 40), zones=[lawn, street], masks=[keepout]
    )
    scenario.save(tmp_path / "yard.yaml")
    for same in (pickle.loads(pickle.dumps(scenario)), vp.read_scenario(tmp_path / "yard.yaml")):
        assert same.zones == [lawn, street]
        assert np.array_equal(same.masks[0].map.cells, keepout.cells)
    verdict = vp.check(scenario, vp.Path((0, 0, 0), [(0, 40)]))
    assert verdict.reason == "the rear axle is in zones[0] (lawn), which is closed"
    assert verdict.hit == {"what": "zones", "index": 0}
    with pytest.raises(vp.InputError, match="gears"):
        vp.Zone(area, gears="fast")


def test_masks_limit_speeds_and_make_metres_dearer(tmp_path):
    percents = np.array([[0, 50], [-1, 20]], np.int8)
    map = vp.OccupancyGrid(np.zeros((2, 2), bool), 20.0, (0, -20, 0))
    wear = vp.Mask(map, cost=4, percents=percents)
    slow = vp.Mask(map, max_speed=2, percents=percents)
    assert (wear.cost, wear.max_speed, slow.cost, slow.max_speed) == (4, None, None, 2)
    scenario = vp.Scenario((0, 0, 0), (60, 0, 0), bounds=(-30, 80, -40, 40), masks=[wear, slow])
    scenario.save(tmp_path / "yard.yaml")
    for same in (pickle.loads(pickle.dumps(scenario)), vp.read_scenario(tmp_path / "yard.yaml")):
        assert [mask.cost for mask in same.masks] == [4, None]
        assert np.array_equal(same.masks[1].percents, percents)
    straight = vp.Path((0, 1, 0), [(0, 60)])
    shifted = scenario.with_poses(start=(0, 1, 0), goal=(60, 1, 0))
    assert vp.speed_profile(shifted, straight).duration > 20 / 1.6
    assert vp.plan(shifted, max_iterations=300).cost > 61
    with pytest.raises(vp.InputError, match="cost"):
        vp.Mask(map, cost=3, max_speed=1)
    with pytest.raises(vp.InputError, match="percents"):
        vp.Mask(map, cost=3, percents=[[1]])


def test_a_vehicle_is_a_value_with_the_names_of_files():
    van = vp.Vehicle(wheelbase=3.0, width=2.0, max_speed=(5, 2), max_jerk=1.5)
    assert (van.wheelbase, van.width, van.max_speed, van.max_jerk) == (3.0, 2.0, (5, 2), 1.5)
    assert van.front_overhang == vp.Vehicle().front_overhang
    assert van.max_braking is None
    assert vp.Vehicle(**van.as_dict()) == van
    assert pickle.loads(pickle.dumps(van)) == van
    assert vp.Vehicle(**{**van.as_dict(), "width": 1.9}) != van
    assert "city-bus" in vp.Vehicle.names()
    scenario = vp.Scenario(
        (0, 0, 0), (1, 0, 0), bounds=(-9, 9, -9, 9), vehicle={"wheelbase": 3, "width": 2}
    )
    assert scenario.vehicle.wheelbase == 3


def test_a_vehicle_may_have_an_outline_and_a_trailer():
    rig = vp.Vehicle(
        outline=[(5, -0.5), (5, 0.5), (-1, 1.2), (-1, -1.2)],
        hitch=-0.5,
        trailers=[{"wheelbase": 8.0, "width": 2.5, "front_overhang": 1, "rear_overhang": 4}],
    )
    assert np.array_equal(rig.outline, [(5, -0.5), (5, 0.5), (-1, 1.2), (-1, -1.2)])
    assert rig.trailers[0]["wheelbase"] == 8
    assert vp.Vehicle().trailers == []
    assert vp.Vehicle().outline.shape == (4, 2)
    for same in (vp.Vehicle(**rig.as_dict()), pickle.loads(pickle.dumps(rig))):
        assert same == rig
    named = vp.Vehicle.named("tractor-semitrailer")
    assert vp.Vehicle(**named.as_dict()) == named
    scenario = vp.Scenario(
        (0, 0, 0), (20, 3, 0), bounds=(-60, 60, -60, 60), vehicle=rig, start_hitch_angle=0.2
    )
    assert scenario.start_hitch_angle == 0.2
    result = vp.plan(scenario, max_iterations=2000)
    assert result.status == "solved"
    assert vp.check(scenario, result).valid
    for wrong, message in (
        ({"outline": [(1, 1), (2, 2)]}, "vehicle.outline: has 2 corners"),
        ({"trailers": [{"length": 3}]}, r"trailers\[0\].length: unknown key"),
        ({"trailers": "one"}, "vehicle.trailers: expected a list"),
        ({"trailers": [{}, {}]}, "vehicle.trailers: expected a list"),
    ):
        with pytest.raises(vp.InputError, match=message):
            vp.Vehicle(**wrong)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"bounds": None}, "bounds: are missing"),
        ({"bounds": (1, 2, 3)}, "bounds: expected"),
        ({"bounds": (10, -10, -10, 10)}, "bounds.x"),
        ({"obstacles": [WALL, [(0, 0), (1, 1)]]}, r"obstacles\[1\]"),
        ({"obstacles": [[(0, 0, 0)]]}, r"obstacles\[0\]: has the shape \(1, 3\)"),
        ({"vehicle": "tank"}, "tank"),
        ({"vehicle": {"wheels": 4}}, "vehicle.wheels: unknown key"),
        ({"vehicle": {"width": -1}}, "vehicle.width"),
        ({"vehicle": {"width": "wide"}}, "vehicle.width: is no number"),
        ({"options": {"margin": "wide"}}, "margin"),
        ({"options": {"marign": 1}}, "marign: unknown option"),
        ({"options": {"seed": 2}}, "options.seed: is an option of the budget"),
        ({"start": (0, 0)}, "start: has the shape"),
        ({"goal": (float("inf"), 0, 0)}, "goal"),
        ({"map": np.zeros((4, 4), bool)}, "resolution: is missing"),
        ({"map": np.zeros((4, 4)), "resolution": 1}, "map: is an array of float64"),
        ({"map": np.zeros(4, bool), "resolution": 1}, "2-D"),
        ({"map": np.zeros((4, 4), bool), "resolution": -1}, "map.resolution"),
        ({"resolution": 1}, "map: is missing"),
    ],
)
def test_what_is_no_scenario_is_refused(change, message):
    given = {"start": (0, 0, 0), "goal": (1, 0, 0), "bounds": (-9, 9, -9, 9), **change}
    with pytest.raises(vp.InputError, match=message):
        vp.Scenario(**given)


@pytest.mark.parametrize("kind", [bool, np.int8, np.int32, np.uint8])
def test_a_grid_of_any_whole_numbers(kind):
    cells = np.zeros((20, 30), dtype=kind)
    cells[5, 7] = 1
    grid = vp.OccupancyGrid(cells, 0.5, origin=(10, 20, 0))
    assert grid.shape == (20, 30)
    assert grid.cells[5, 7] == 100 and grid.cells.sum() == 100
    assert np.array_equal(grid.outline[2], [25, 30])
    scenario = vp.Scenario((12, 22, 0), (20, 22, 0), map=grid)
    assert scenario.bounds == (10, 25, 20, 30)


def test_cells_of_ros_are_free_occupied_or_unknown():
    cells = np.array([[0, 100], [-1, 50]], dtype=np.int8)
    assert np.array_equal(vp.OccupancyGrid(cells, 1).cells, [[0, 100], [-1, 100]])
    sliced = np.zeros((4, 4), dtype=np.int8)
    sliced[::2, ::2] = cells
    assert np.array_equal(vp.OccupancyGrid(sliced[::2, ::2], 1).cells, [[0, 100], [-1, 100]])


def test_rows_of_a_grid_count_upwards():
    cells = np.zeros((40, 40), dtype=bool)
    cells[30:, :] = True  # y from 15 m
    truck = {"map": cells, "resolution": 0.5}
    low = vp.plan(vp.Scenario((5, 5, 0), (12, 5, 0), **truck), max_iterations=100)
    high = vp.plan(vp.Scenario((5, 18, 0), (12, 18, 0), **truck), max_iterations=100)
    assert low.status == "solved"
    assert high.status == "start_in_collision"


def test_files_are_read_as_the_command_line_reads_them(tmp_path):
    thesis = REPOSITORY / "scenarios" / "thesis"
    scenario = vp.read_scenario(thesis / "5-leave-cage.yaml")
    assert len(scenario.obstacles) == len(vp.read_scenario(str(thesis / "5-leave-cage.yaml")).obstacles)
    row = vp.read_scenarios(thesis / "8-furthest-open.yaml")
    assert len(row) > 1
    with pytest.raises(vp.InputError, match="row of goals"):
        vp.read_scenario(thesis / "8-furthest-open.yaml")
    wrong = tmp_path / "wrong.yaml"
    wrong.write_text("name: x\nwheels: 4\n", "utf-8")
    with pytest.raises(vp.InputError, match=r"wrong.yaml:2: .*wheels"):
        vp.read_scenario(wrong)
    with pytest.raises(vp.InputError, match="none.yaml"):
        vp.read_scenario(tmp_path / "none.yaml")


def test_a_scenario_with_a_grid_is_saved_and_read_back(tmp_path):
    cells = np.zeros((20, 30), dtype=np.int8)
    cells[5:8, 7] = 100
    cells[0, 0] = -1
    scenario = vp.Scenario(
        (5, 8, 0), (10, 8, 0), map=cells, resolution=0.5, origin=(-1, -2, 0.1), options={"margin": 0.1}
    )
    scenario.save(tmp_path / "yard.yaml")
    again = vp.read_scenario(tmp_path / "yard.yaml")
    assert np.array_equal(again.map.cells, scenario.map.cells)
    assert again.bounds == scenario.bounds
    assert np.array_equal(again.map.origin, scenario.map.origin)
    assert again.options == {"margin": "0.1"}


def test_other_poses_in_the_same_world(yard):
    moved = yard.with_poses(start=(0, -10, 0))
    assert np.array_equal(moved.start, [0, -10, 0])
    assert np.array_equal(moved.goal, yard.goal)
    assert vp.plan(moved, max_iterations=2000).path.start == pytest.approx([0, -10, 0])
    with pytest.raises(vp.InputError, match="goal"):
        yard.with_poses(goal=(1e9, 0, 0))


def test_a_vehicle_may_have_a_steering_angle_in_place_of_a_radius():
    vehicle = vp.Vehicle(max_steering_angle=0.5, wheelbase=3.0)
    assert vehicle.min_turning_radius == pytest.approx(3 / math.tan(0.5))
    assert vehicle.max_steering_angle == pytest.approx(0.5)
    assert vp.Vehicle(**vehicle.as_dict()) == vehicle
    with pytest.raises(vp.InputError, match="beside min_turning_radius"):
        vp.Vehicle(max_steering_angle=0.5, min_turning_radius=7)
    for angle in (0, 35, math.nan):
        with pytest.raises(vp.InputError, match="max_steering_angle"):
            vp.Vehicle(max_steering_angle=angle)
