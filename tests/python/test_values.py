# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Values are pickled and copied, signatures can be read, and nonsense is refused."""

import ast
import copy
import inspect
import multiprocessing
import pathlib
import pickle

import numpy as np
import pytest
from conftest import REPOSITORY
from test_moving import crossing_car

import vandplan as vp

STUB = ast.parse((pathlib.Path(vp.__file__).parent / "_core.pyi").read_text("utf-8"))


def straight(task):
    return task.steer(task.start, task.goal)


def every_value(tmp_path):
    """A value of each public class that is one, by name."""
    grid = vp.OccupancyGrid(np.array([[0, 1], [-1, 0]] * 10).repeat(10, axis=1), 0.5, (1, 2, 0.1))
    free = vp.Scenario((5, 5, 0), (20, 12, 1), bounds=(-50, 50, -50, 50), options={"margin": 0.25}, name="free")
    scenario = free.with_moving([crossing_car(60)])
    result = vp.plan(free, max_iterations=200)
    busy = vp.plan(scenario, max_iterations=3000)
    nodes = vp.NearestNodes(7, [(0, 0, 0), (9, 0, 1)])
    rig = vp.read_scenario(REPOSITORY / "scenarios/trailer/dock.yaml")
    trailer = vp.drive(rig, vp.Path(rig.start, [(0, 1)]), keep_log=True)
    live = vp.drive_live(free, max_iterations=100, longest=1, keep_log=True)
    executable = vp.executable(free, result)
    hit = vp.drive(vp.Scenario((0, 0, 0), (9, 0, 0), bounds=(-9, 9, -9, 9), obstacles=[[(8, -1), (9, -1), (9, 1)]]),
                   vp.Path((0, 0, 0), [(0, 6)]))
    replanner = vp.Replanner(free, max_iterations=100)
    return {
        "Answer": vp.Answer(result.path, lower_bound=3, counters={"tries": 2}, reason="why"),
        "Comparison": vp.compare([free], [straight], tmp_path, repeats=1, max_iterations=1),
        "Contact": hit.contact,
        "DriveCheck": busy.check.drive,
        "DriveResult": trailer,
        "ExecutableCheck": executable,
        "Execution": executable.flowing,
        "GoalRegion": vp.GoalRegion((3, 4), 2, (1, 2), either_way=True, straight=4),
        "LiveDriveResult": live,
        "Mask": vp.Mask(grid, cost=3),
        "Meeting": vp.first_meeting(busy.speeds, scenario.moving, 1000),
        "MovingObstacle": crossing_car(60),
        "NearestNodes": nodes,
        "OccupancyGrid": grid,
        "PassedVia": vp.plan(
            vp.Scenario((0, 0, 0), (20, 0, 0), bounds=(-9, 29, -9, 9), via=[(9, 0, 0)]), max_iterations=50
        ).via[0],
        "Path": result.path,
        "PathCheck": busy.check,
        "Planner": vp.Planner("straight", straight, options={"share": (0.2, 0, 1), "way": ("a", ["a", "b"])}),
        "ReachedGoal": vp.plan(free.with_poses(goal=vp.GoalRegion(20, 12)), max_iterations=50).goal,
        "ReplanAnswer": replanner.tick(0),
        "Result": busy,
        "Scenario": vp.Scenario((5, 5, 0), (7, 6, 0), map=grid, vehicle=rig.vehicle, options={"margin": 0.1}),
        "SiteTable": vp.site_table(free, headings=8, cell=1),
        "SpeedProfile": busy.speeds,
        "TrailerDeviation": trailer.trailer,
        "Vehicle": rig.vehicle,
        "Via": vp.Via((9, 0, 0), stop=True),
        "Zone": vp.Zone([(0, 0), (9, 0), (9, 9)], direction=(0, 1), max_speed=2),
    }


# They live as long as a run or a drive does.
LIVING = {"ChangingSiteTable", "Task", "Replanner"}


def parts(value, depth=4):
    """All that a value says of itself, as plain values."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, dict):
        return {key: parts(part, depth) for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [parts(part, depth) for part in value]
    if type(value).__module__ != "vandplan._core" or depth == 0:
        return value
    names = [name for name, kind in vars(type(value)).items() if isinstance(kind, property)]
    is_old = {name: (vars(type(value))[name].__doc__ or "").startswith("Old name") for name in names}
    return {name: parts(getattr(value, name), depth - 1) for name in names if not is_old[name]}


def test_every_public_class_is_pickled_and_copied(tmp_path):
    values = every_value(tmp_path)
    classes = {name for name in vp.__all__ if isinstance(getattr(vp, name), type)}
    assert set(values) == classes - LIVING - {"InputError"}
    for name, value in values.items():
        said = repr(parts(value))
        assert type(value).__name__ == name
        assert "nan" not in said or name in ("DriveResult", "LiveDriveResult"), name
        for again in (pickle.loads(pickle.dumps(value)), copy.copy(value), copy.deepcopy(value)):
            assert repr(parts(again)) == said, name
            assert repr(parts(again.__getstate__())) == repr(parts(value.__getstate__())), name
    error = pickle.loads(pickle.dumps(vp.InputError("here: wrong")))
    assert isinstance(error, vp.InputError) and str(error) == "here: wrong"


def test_what_was_pickled_is_as_good_as_before(yard, tmp_path):
    result = vp.plan(yard, max_iterations=500, style="shortest", margin=0.2)
    again = pickle.loads(pickle.dumps(result))
    assert vp.check(yard, again) and vp.check(again.scenario, again)
    assert again.options == result.options and again.options["margin"] == 0.2
    again.save(tmp_path / "again.json")
    result.save(tmp_path / "result.json")
    assert (tmp_path / "again.json").read_text("utf-8") == (tmp_path / "result.json").read_text("utf-8")
    scenario = pickle.loads(pickle.dumps(yard))
    assert vp.plan(scenario, max_iterations=500, style="shortest", margin=0.2).path == result.path
    read = pickle.loads(pickle.dumps(vp.read_result(yard, tmp_path / "result.json")))
    assert vp.check(yard, read) and read.path == result.path
    tree = vp.plan(yard, "rrt-opt-euc", max_iterations=100, goal_bias=0.3, seed=2)
    assert pickle.loads(pickle.dumps(tree)).options == tree.options
    nodes = pickle.loads(pickle.dumps(vp.NearestNodes(7, [(0, 0, 0), (9, 0, 1)])))
    assert len(nodes) == 2 and nodes.nearest((9, 0, 1)) == (1, 0.0)


def test_planners_are_pickled(yard):
    own = pickle.loads(pickle.dumps(vp.Planner("straight", straight, options={"share": (0.2, 0, 1)})))
    assert vp.plan(yard.with_poses(goal=(9, 0, 0)), own, max_iterations=1, share=0.5)
    for planner in vp.planners():
        assert pickle.loads(pickle.dumps(planner)).properties == planner.properties
    known = vp.plan(yard, max_iterations=300)
    warm = pickle.loads(pickle.dumps(vp.warm_started(known)))
    assert vp.plan(yard, warm, max_iterations=0).path == vp.plan(yard, vp.warm_started(known), max_iterations=0).path


def plan_with_seed(arguments):
    scenario, seed = arguments
    return vp.plan(scenario, max_iterations=100, seed=seed)


def test_other_processes_plan(yard):
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        results = pool.map(plan_with_seed, [(yard, 1), (yard, 2)])
    assert [result.path for result in results] == [plan_with_seed((yard, seed)).path for seed in (1, 2)]


def stub_arguments(function):
    """Names, kinds and defaults of a function of the stub; a default of `...` may be any."""
    given = function.args
    found = []
    positional = given.posonlyargs + given.args
    defaults = [None] * (len(positional) - len(given.defaults)) + given.defaults
    found += [(a.arg, "positional", d) for a, d in zip(positional, defaults)]
    if given.vararg:
        found.append((given.vararg.arg, "all", None))
    found += [(a.arg, "keyword", d) for a, d in zip(given.kwonlyargs, given.kw_defaults)]
    if given.kwarg:
        found.append((given.kwarg.arg, "rest", None))
    return [argument for argument in found if argument[0] != "self"]


# Keywords that work for one version, and that help does not name.
OLD_NAMES = {("GoalRegion.__init__", "of_trailer"), ("Scenario.__init__", "grid")}

KINDS = {
    inspect.Parameter.POSITIONAL_OR_KEYWORD: "positional",
    inspect.Parameter.KEYWORD_ONLY: "keyword",
    inspect.Parameter.VAR_KEYWORD: "rest",
}


def check_signature(thing, function, where):
    found = [p for p in inspect.signature(thing).parameters.values() if p.name != "self"]
    wanted = [argument for argument in stub_arguments(function) if (where, argument[0]) not in OLD_NAMES]
    assert [(p.name, KINDS[p.kind]) for p in found] == [(name, kind) for name, kind, _ in wanted], where
    for parameter, (name, _, default) in zip(found, wanted):
        has_default = parameter.default is not inspect.Parameter.empty
        assert has_default == (default is not None), f"{where}: {name}"
        if has_default and not (isinstance(default, ast.Constant) and default.value is ...):
            assert parameter.default == ast.literal_eval(default), f"{where}: {name}"


def test_every_signature_is_that_of_the_stub():
    # Keywords of a vehicle are those of scenario files, whatever they are.
    free = {"Vehicle.__init__", "InputError.__init__"}
    checked = set()
    for item in STUB.body:
        if isinstance(item, ast.FunctionDef) and item.name not in checked:  # the first of overloads
            check_signature(getattr(vp, item.name), item, item.name)
            checked.add(item.name)
        if not isinstance(item, ast.ClassDef):
            continue
        for member in item.body:
            where = f"{item.name}.{getattr(member, 'name', '')}"
            is_public = isinstance(member, ast.FunctionDef) and (member.name == "__init__" or member.name[0] != "_")
            if not is_public or member.decorator_list or where in free:
                continue
            thing = getattr(vp, item.name)
            check_signature(thing if member.name == "__init__" else getattr(thing, member.name), member, where)
            checked.add(where)
    assert {"plan", "reeds_shepp_length", "Path.poses"} <= checked and len(checked) > 60


def test_everything_that_is_called_has_a_signature():
    for name in vp.__all__:
        thing = getattr(vp, name)
        if name in ("__version__", "InputError"):
            continue
        if not isinstance(thing, type):
            assert inspect.signature(thing) is not None, name
        elif "__init__" in vars(thing) and "cannot" not in (thing.__init__.__doc__ or ""):
            for member, value in vars(thing).items():
                if not member.startswith("_") and callable(value):
                    assert inspect.signature(value) is not None, f"{name}.{member}"
    text = inspect.signature(vp.plan)
    assert str(text).startswith("(scenario, planner='anytime', *, time_limit=None, max_iterations=None, seed=1")
    assert vp.plan.__doc__.startswith("-> Result\n\nPlans a path")


NONSENSE = [None, np.nan, np.inf, -1, 0, 1e300, "", "x", b"x", [], {}, (), object(), [np.nan] * 3, [[1, 2], [3]], (0, 0, 0)]


@pytest.mark.parametrize("name", [n for n in vp.__all__ if callable(getattr(vp, n)) and n != "InputError"])
@pytest.mark.filterwarnings("ignore:.*degrees are:UserWarning")
def test_nonsense_is_refused_at_every_door(name, yard, tmp_path, monkeypatch):
    """No crash, and nothing but an error of use: whatever is handed in, at whatever place."""
    monkeypatch.chdir(tmp_path)
    function = getattr(vp, name)
    try:
        signature = inspect.signature(function)
    except ValueError:
        with pytest.raises(TypeError):
            function()
        return
    sensible = {
        "scenario": yard, "path": vp.reeds_shepp((0, 0, 0), (9, 1, 0), 7), "start": (0, 0, 0), "goal": (9, 0, 0),
        "starts": [(0, 0, 0)], "goals": [(9, 0, 0)], "nodes": [(0, 0, 0)], "samples": (1, 0, 0), "radius": 7.0,
        "curvature_rate": 0.1, "segments": [(0, 1)], "cells": np.zeros((3, 3), bool), "resolution": 1.0,
        "outline": [(0, 0), (1, 0), (1, 1)], "trajectory": [(0, 0, 0, 0)], "moving": [crossing_car(9)],
        "function": straight, "name": "own", "planners": [straight], "scenarios": [yard], "folder": tmp_path / "f",
        "file": tmp_path / "missing", "result": None, "vehicle": vp.Vehicle(), "bounds": (-9, 19, -9, 9),
    }
    if name == "plot":
        pytest.importorskip("matplotlib").use("Agg")
    if name == "first_meeting":
        sensible["drive"] = vp.speed_profile(vp.Vehicle(), sensible["path"])
    brief = {"max_iterations": 1} if "max_iterations" in signature.parameters else {}
    if name == "drive_live":
        brief["longest"] = 0.1
    if name == "compare":
        brief["repeats"] = 1
    if name == "Scenario":
        sensible["map"] = np.zeros((9, 9), bool)
    usable = {key: value for key, value in sensible.items() if key in signature.parameters}
    for parameter in signature.parameters.values():
        if parameter.kind is inspect.Parameter.VAR_KEYWORD:
            continue
        for nonsense in NONSENSE:
            if parameter.name in ("file", "folder", "jobs") and not isinstance(nonsense, (float, bytes)):
                continue
            if parameter.name in ("time_limit", "longest", "repeats", "repeats_per_goal") and nonsense in (None, 1e300):
                continue
            try:
                function(**{**brief, **usable, parameter.name: nonsense})
            except (ValueError, TypeError, OverflowError, FileNotFoundError, MemoryError, IsADirectoryError):
                pass  # an error of use: what numpy and pybind11 say, too


def test_a_heading_in_degrees_is_doubted(yard):
    with pytest.warns(UserWarning, match=r"goal.heading: is 90 rad.*90 degrees are 1.5708 rad"):
        vp.Scenario((0, 0, 0), (0, 12, 90), bounds=(-50, 50, -50, 50))
    with pytest.warns(UserWarning, match="start.heading"):
        yard.with_poses(start=(0, 0, -180))
    with pytest.warns(UserWarning, match=r"starts\[1\].heading"):
        vp.plan_many(yard, [(0, 0, 0), (0, 0, 45)], yard.goal, max_iterations=1)
