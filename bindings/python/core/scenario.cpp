// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Scenarios from arguments, arrays and files.

#include "bindings/python/core/scenario.h"
#include "bindings/python/core/renamed.h"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cstdint>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/goal.h"
#include "bindings/python/core/options.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::python {
namespace {

using namespace py::literals;
using FileName = std::filesystem::path;  // Accepts str and os.PathLike.

std::optional<OccupancyGrid> map_from(const py::object& map, const py::object& resolution,
                                      const py::object& origin) {
  if (map.is_none()) {
    if (resolution.is_none() && origin.is_none()) return std::nullopt;
    throw InputError("map", "is missing: its resolution or origin is given");
  }
  if (py::isinstance<OccupancyGrid>(map)) {
    if (resolution.is_none() && origin.is_none()) return map.cast<OccupancyGrid>();
    throw InputError("resolution", "and origin are those of the map");
  }
  if (resolution.is_none()) throw InputError("resolution", "is missing: the side of a cell [m]");
  const py::object corner = origin.is_none() ? py::make_tuple(0, 0, 0) : origin;
  return grid_from(map, resolution.cast<double>(), corner, false);
}

Bounds bounds_from(const py::object& given, const std::optional<OccupancyGrid>& map) {
  if (given.is_none()) {
    if (map) return bounding_box(outline(*map));
    throw InputError("bounds",
                     "are missing: (x_min, x_max, y_min, y_max), where the rear axle may be");
  }
  const Numbers numbers = numbers_from(given, "bounds");
  if (numbers.size() != 4) {
    throw InputError("bounds", "expected (x_min, x_max, y_min, y_max)");
  }
  const double* const b = numbers.data();
  return {b[0], b[1], b[2], b[3]};
}

py::list arrays_of(const std::vector<Polygon>& polygons) {
  py::list list;
  for (const Polygon& polygon : polygons) list.append(array_of(std::span<const Point>(polygon)));
  return list;
}

CheckedScenario make_scenario(const py::object& start, const py::object& goal,
                              const py::object& bounds, const py::object& obstacles,
                              const py::object& kerbs, const py::object& map,
                              const py::object& resolution, const py::object& origin,
                              const py::object& vehicle, double start_curvature,
                              double goal_curvature, double start_hitch_angle,
                              double goal_hitch_angle, const std::string& name,
                              const py::dict& options, const std::vector<MovingObstacle>& moving,
                              const py::object& inside, const std::vector<Zone>& zones,
                              const std::vector<Mask>& masks, const py::iterable& via,
                              const py::object& grid) {
  if (!grid.is_none()) warn_of_old_name("grid", "map");
  Scenario scenario{.name = name,
                    .vehicle = vehicle_from(vehicle),
                    .start = pose_from(start, "start"),
                    .curvatures = {start_curvature, goal_curvature},
                    .hitch_angles = {start_hitch_angle, goal_hitch_angle},
                    .goal_set = goal_set_from(goal),
                    .via = via_from(via),
                    .obstacles = polygons_from(obstacles, "obstacles"),
                    .kerbs = polygons_from(kerbs, "kerbs"),
                    .inside = polygons_from(inside, "inside"),
                    .zones = zones,
                    .map = map_from(map.is_none() ? grid : map, resolution, origin),
                    .moving = moving};
  scenario.masks = masks;
  for (std::size_t i = 0; i < masks.size(); ++i) {
    scenario.masks[i].map_file = name + ".mask" + std::to_string(i) + ".yaml";
  }
  scenario.bounds = bounds_from(bounds, scenario.map);
  if (scenario.goal_set.empty()) scenario.goal = pose_from(goal, "goal");
  warn_of_degrees({&scenario.start, 1}, "start");
  warn_of_degrees({&scenario.goal, 1}, "goal");
  if (scenario.map) scenario.map_file = name + ".map.yaml";
  return CheckedScenario(std::move(scenario), settings_from(options));
}

std::vector<CheckedScenario> scenarios_of(const FileName& file) {
  const ScenarioFile read = read_scenario_file(file.string());
  for (const std::string& warning : read.warnings) warn(warning);
  std::vector<CheckedScenario> scenarios;
  for (std::size_t i = 0; i < read.size(); ++i) {
    scenarios.emplace_back(scenario_at(read, i), read.options);
  }
  return scenarios;
}

CheckedScenario scenario_of(const FileName& file) {
  std::vector<CheckedScenario> scenarios = scenarios_of(file);
  if (scenarios.size() == 1) return std::move(scenarios.front());
  throw InputError(file.string(), "has a row of goals, which read_scenarios reads");
}

/// Writes the scenario, and its map and masks in files beside it.
void save_scenario(const CheckedScenario& self, const FileName& name) {
  const std::string file = name.string();
  const std::string stem = file.substr(0, file.rfind(".yaml"));
  // Writes a map or mask. Returns its name for files in the same folder.
  const auto written = [&](const Mask& map, const std::string& kind) {
    const std::string path = stem + "." + kind;
    const std::string beside = path.substr(path.rfind('/') + 1);
    write_file(path + ".pgm", mask_to_pgm(map));
    write_file(path + ".yaml", mask_to_yaml(map, beside + ".pgm"));
    return beside + ".yaml";
  };
  ScenarioFile content = self.file();
  Scenario& scenario = content.scenario;
  if (scenario.map) scenario.map_file = written({"", *scenario.map}, "map");
  for (std::size_t i = 0; i < scenario.masks.size(); ++i) {
    scenario.masks[i].map_file = written(scenario.masks[i], "mask" + std::to_string(i));
  }
  write_file(file, to_yaml(content));
}

CheckedScenario moved(const CheckedScenario& self, const py::object& start,
                      const py::object& goal) {
  const Scenario& scenario = self.scenario();
  const auto pose_or = [](const py::object& given, const char* where, const Pose& pose) {
    if (given.is_none()) return pose;
    const Pose other = pose_from(given, where);
    warn_of_degrees({&other, 1}, where);
    return other;
  };
  const Pose from = pose_or(start, "start", scenario.start);
  const std::vector<GoalRegion> set = goal.is_none() ? scenario.goal_set : goal_set_from(goal);
  if (!set.empty()) return self.with_goal_set(from, set, scenario.curvatures.start);
  return self.with_poses(from, pose_or(goal, "goal", scenario.goal), scenario.curvatures);
}

CheckedScenario among(const CheckedScenario& self, const std::vector<MovingObstacle>& moving) {
  return self.with_moving(moving);
}

std::string scenario_text(const CheckedScenario& self) {
  const Scenario& s = self.scenario();
  const std::string goal =
      s.goal_set.empty()
          ? fmt::format("({:g}, {:g}, {:g})", s.goal.x, s.goal.y, s.goal.heading)
          : fmt::format("any of {} region{}", s.goal_set.size(), s.goal_set.size() == 1 ? "" : "s");
  return fmt::format("<vandplan.Scenario {}: ({:g}, {:g}, {:g}) to {}, {} obstacles{}>", s.name,
                     s.start.x, s.start.y, s.start.heading, goal, s.obstacles.size(),
                     s.map ? ", a map" : "");
}

void bind_scenario_data(py::class_<CheckedScenario>& scenario) {
  const auto property = [&](const char* name, auto get, const char* about) {
    scenario.def_property_readonly(
        name, [get](const CheckedScenario& self) { return get(self.scenario()); }, about);
  };
  property(
      "name", [](const Scenario& s) { return s.name; },
      "Name of the scenario, which results state.");
  property(
      "description", [](const Scenario& s) { return s.description; },
      "Description in the scenario's file.");
  property(
      "vehicle", [](const Scenario& s) { return s.vehicle; }, "The vehicle.");
  property(
      "bounds",
      [](const Scenario& s) {
        return py::make_tuple(s.bounds.x_min, s.bounds.x_max, s.bounds.y_min, s.bounds.y_max);
      },
      "Range of the rear axle: (x_min, x_max, y_min, y_max) [m].");
  property(
      "start", [](const Scenario& s) { return array_of(s.start); }, "Start pose [x, y, heading].");
  scenario.def_property_readonly(
      "goal", [](const CheckedScenario& self) { return array_of(self.problem().goal()); },
      "Goal pose [x, y, heading]; with a set of goals, some pose of its first region.");
  property(
      "goal_set", [](const Scenario& s) { return s.goal_set; },
      "Regions of a set of goals, `GoalRegion` objects; empty if the goal is a pose.");
  property(
      "via", [](const Scenario& s) { return s.via; },
      "What the path passes before the goal, `Via` objects.");
  property(
      "start_curvature", [](const Scenario& s) { return s.curvatures.start; },
      "Curvature that the wheels are turned to at the start [1/m].");
  property(
      "goal_curvature", [](const Scenario& s) { return s.curvatures.goal; },
      "Curvature that the wheels are turned to at the goal [1/m].");
  property(
      "start_hitch_angle", [](const Scenario& s) { return s.hitch_angles.start; },
      "Heading of the vehicle less that of its trailer at the start [rad].");
  property(
      "goal_hitch_angle", [](const Scenario& s) { return s.hitch_angles.goal; },
      "Heading of the vehicle less that of its trailer at the goal [rad].");
  property(
      "obstacles", [](const Scenario& s) { return arrays_of(s.obstacles); },
      "Obstacles, polygons of shape (N, 2) [m].");
  property(
      "kerbs", [](const Scenario& s) { return arrays_of(s.kerbs); },
      "Kerbs, polygons that only the wheels must not touch [m].");
  property(
      "inside", [](const Scenario& s) { return arrays_of(s.inside); },
      "Areas, in one of which the whole body must stay; empty: anywhere.");
  property(
      "zones", [](const Scenario& s) { return s.zones; }, "Zones, `Zone` objects.");
  property(
      "masks", [](const Scenario& s) { return s.masks; }, "Further maps, `Mask` objects.");
  property(
      "map", [](const Scenario& s) { return s.map; }, "The map, an `OccupancyGrid`, or None.");
  add_old_property(scenario, "grid", "map",
                   [](const CheckedScenario& self) { return self.scenario().map; });
  property(
      "moving", [](const Scenario& s) { return s.moving; },
      "Moving obstacles, `MovingObstacle` objects.");
  scenario.def_property_readonly(
      "options",
      [](const CheckedScenario& self) {
        py::dict options;
        for (const auto& [name, value] : self.options()) options[name.c_str()] = value;
        return options;
      },
      "Planner options of the scenario by name, as text.");
}

void bind_scenario_class(py::module_& module) {
  py::class_<CheckedScenario> scenario(module, "Scenario", R"(Scenario(start, goal, *, bounds=None,
    obstacles=(), kerbs=(), map=None, resolution=None, origin=None, vehicle=None,
    start_curvature=0, goal_curvature=0, start_hitch_angle=0, goal_hitch_angle=0, name="scenario",
    options={}, moving=(), inside=(), zones=(), masks=(), via=())

A planning problem, checked and immutable. Units are metres and radians.

- `start`: pose [x, y, heading] of the midpoint of the rear axle.
- `goal`: a pose, a `GoalRegion`, or a sequence of `GoalRegion` objects.
- `via`: what the path passes before the goal, in this order: poses, `GoalRegion` or `Via` objects.
- `bounds`: range of the rear axle (x_min, x_max, y_min, y_max); that of the map by default.
- `obstacles`, `kerbs`: simple polygons, arrays of shape (N, 2) or polygons of shapely and
  geopandas without holes. Only the wheels keep off kerbs.
- `inside`: simple polygons, in one of which the whole body must stay.
- `zones`: `Zone` objects: areas with rules.
- `masks`: `Mask` objects, or `OccupancyGrid` objects whose occupied cells are obstacles.
- `map`: an `OccupancyGrid`, or a 2-D array with its `resolution` and `origin`.
- `moving`: `MovingObstacle` objects.
- `vehicle`: a `Vehicle`, a name, or a dict; None: a truck.
- `start_curvature`, `goal_curvature`: curvature that the wheels are turned to [1/m].
- `start_hitch_angle`, `goal_hitch_angle`: heading of the vehicle less that of its trailer.
- `options`: planner options of this scenario, such as {"margin": 0.3}.

Raises InputError naming the argument that is wrong.)");
  scenario
      .def(py::init(&make_scenario), "start"_a, "goal"_a, py::kw_only(), "bounds"_a = py::none(),
           "obstacles"_a = py::tuple(), "kerbs"_a = py::tuple(), "map"_a = py::none(),
           "resolution"_a = py::none(), "origin"_a = py::none(), "vehicle"_a = py::none(),
           "start_curvature"_a = 0.0, "goal_curvature"_a = 0.0, "start_hitch_angle"_a = 0.0,
           "goal_hitch_angle"_a = 0.0, "name"_a = "scenario", "options"_a = py::dict(),
           "moving"_a = std::vector<MovingObstacle>{}, "inside"_a = py::tuple(),
           "zones"_a = std::vector<Zone>{}, "masks"_a = std::vector<Mask>{}, "via"_a = py::tuple(),
           "grid"_a = py::none())
      .def("with_poses", &moved, "start"_a = py::none(), "goal"_a = py::none(),
           R"(with_poses(start=None, goal=None) -> Scenario

Copy with another start or goal, and without vias. It shares the world, so nothing is built again.)")
      .def("with_moving", &among, "moving"_a,
           R"(with_moving(moving) -> Scenario

Copy with these `MovingObstacle` objects in place of the old ones. It shares the world, so nothing
is built again.)")
      .def(
          "with_via",
          [](const CheckedScenario& self, const py::iterable& via) {
            return self.with_via(via_from(via));
          },
          "via"_a, R"(with_via(via) -> Scenario

Copy with these vias in place of the old ones, as for `Scenario`. It shares the world.)")
      .def(
          "to_yaml", [](const CheckedScenario& self) { return to_yaml(self.file()); },
          "to_yaml() -> str\n\nText of a scenario file. A map is only named; `save` writes it "
          "too.")
      .def("save", &save_scenario, "file"_a, R"(save(file)

Writes a scenario file for the command line. Map and masks go to files beside it (.map.yaml,
.map.pgm, .mask0.yaml).)")
      .def("__repr__", &scenario_text)
      .def(py::pickle(&state_of_scenario, &scenario_from_state))
      .def("__copy__", [](const CheckedScenario& self) { return self; })
      .def(
          "__deepcopy__", [](const CheckedScenario& self, const py::dict&) { return self; },
          "memo"_a);
  bind_scenario_data(scenario);
}

}  // namespace

CheckedScenario::CheckedScenario(Scenario scenario, std::vector<Setting> options)
    : scenario_(std::make_shared<const Scenario>(std::move(scenario))),
      options_(std::move(options)) {
  check_scenario(*scenario_);
  for (const auto& [name, value] : options_) {
    const auto honouring = std::ranges::find_if(
        planners(), [&name = name](const Planner& planner) { return honours(planner, name); });
    PlanOptions any;
    set_option(any, honouring == planners().end() ? default_planner() : *honouring, name, value);
    if (any.budget == BudgetOptions{}) continue;
    throw InputError("options." + name, "is an option of the budget, expected it where one plans");
  }
}

const Scenario& CheckedScenario::scenario() const {
  if (ends_) {
    Scenario changed = *scenario_;
    changed.start = ends_->start;
    changed.goal = ends_->goal;
    changed.curvatures = ends_->curvatures;
    changed.goal_set.clear();
    changed.via.clear();
    scenario_ = std::make_shared<const Scenario>(std::move(changed));
    ends_.reset();
  }
  return *scenario_;
}

const Problem& CheckedScenario::problem() const {
  if (!problem_) {
    std::shared_ptr<const Problem> made;
    {
      const py::gil_scoped_release release;
      made = std::make_shared<const Problem>(make_problem(*scenario_));
    }
    if (!problem_) problem_ = std::move(made);
  }
  return *problem_;
}

CheckedScenario CheckedScenario::with_poses(const Pose& start, const Pose& goal,
                                            const EndCurvatures& curvatures) const {
  CheckedScenario other = *this;
  other.problem_ = std::make_shared<const Problem>(
      vandplan::with_moving(make_problem(problem().world(), scenario_->vehicle, start, goal,
                                         curvatures, scenario_->hitch_angles),
                            scenario_->moving));
  other.ends_ = {start, goal, curvatures};
  return other;
}

CheckedScenario CheckedScenario::with_goal_set(const Pose& start,
                                               const std::vector<GoalRegion>& set,
                                               double start_curvature) const {
  const double angle = scenario_->hitch_angles.start;
  CheckedScenario other = with_poses(start, start, {start_curvature, start_curvature});
  other.problem_ = std::make_shared<const Problem>(vandplan::with_moving(
      vandplan::with_goal_set(make_problem(problem().world(), scenario_->vehicle, start, start,
                                           {start_curvature, start_curvature}, {angle, angle}),
                              set),
      scenario_->moving));
  Scenario changed = scenario();
  changed.start = start;
  changed.goal_set = set;
  changed.via.clear();
  other.scenario_ = std::make_shared<const Scenario>(std::move(changed));
  other.ends_.reset();
  return other;
}

CheckedScenario CheckedScenario::with(Problem problem, Scenario scenario) const {
  CheckedScenario other = *this;
  other.problem_ = std::make_shared<const Problem>(std::move(problem));
  other.scenario_ = std::make_shared<const Scenario>(std::move(scenario));
  other.ends_.reset();
  return other;
}

CheckedScenario CheckedScenario::with_moving(const std::vector<MovingObstacle>& moving) const {
  Scenario changed = scenario();
  changed.moving = moving;
  return with(vandplan::with_moving(problem(), moving), std::move(changed));
}

CheckedScenario CheckedScenario::with_via(const std::vector<Via>& via) const {
  Scenario changed = scenario();
  changed.via = via;
  return with(vandplan::with_via(problem(), via), std::move(changed));
}

void bind_scenario(py::module_& module) {
  bind_scenario_class(module);
  module.def("read_scenario", &scenario_of, "file"_a,
             "read_scenario(file) -> Scenario\n\nReads a scenario file (YAML) with one goal.");
  module.def(
      "read_scenarios", &scenarios_of, "file"_a,
      "read_scenarios(file) -> list of Scenario\n\nReads a scenario file. Returns one scenario, or "
      "one for each goal of a row.");
  module.def(
      "read_tpcap", [](const FileName& file) { return CheckedScenario(read_tpcap(file.string())); },
      "file"_a,
      "read_tpcap(file) -> Scenario\n\nReads a case of the Trajectory Planning Competition for "
      "Automated Parking 2022 (CSV).");
}

}  // namespace vandplan::python
