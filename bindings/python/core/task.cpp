// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The task that a planner in Python receives, and its answer.

#include "bindings/python/core/task.h"

#include <pybind11/stl.h>

#include <limits>
#include <map>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/options.h"
#include "bindings/python/core/path.h"
#include "vandplan/input_error.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Answer of a planner in Python that has more than a path.
struct Answer {
  py::object path = py::none();
  std::optional<double> lower_bound = {};
  bool proven = false;
  std::string reason = {};
  std::map<std::string, std::int64_t> counters = {};
  py::object tree = py::none();
};

/// Segments of a path, or of consecutive paths.
std::vector<Segment> segments_of(const py::handle& given) {
  if (py::isinstance<Path>(given)) return given.cast<const Path&>().segments;
  const auto expect = [](bool holds) {
    if (holds) return;
    throw InputError("planner", "expected a path, a list of paths, None or an Answer from it");
  };
  expect(py::isinstance<py::sequence>(given) && !py::isinstance<py::str>(given));
  std::vector<Segment> all;
  for (const py::handle part : given) {
    expect(py::isinstance<Path>(part));
    const std::vector<Segment>& segments = part.cast<const Path&>().segments;
    all.insert(all.end(), segments.begin(), segments.end());
  }
  return all;
}

/// Tree with its poses in the frame of the world.
TreeSnapshot tree_from(const py::handle& given, const World& world) {
  const auto pair = given.cast<std::pair<py::object, std::vector<std::int32_t>>>();
  const Poses poses(pair.first, "tree");
  if (poses.view().size() != pair.second.size()) {
    throw InputError("tree", "expected as many parents as poses");
  }
  for (std::size_t i = 0; i < pair.second.size(); ++i) {
    if (pair.second[i] < -1 || pair.second[i] >= static_cast<std::int64_t>(i)) {
      throw InputError("tree", "expected parents before their children, -1 for the root");
    }
  }
  TreeSnapshot tree{.poses = {}, .parents = pair.second};
  for (const Pose& pose : poses.view()) tree.poses.push_back(to_local(world, pose));
  return tree;
}

py::object free_at(PlanningTask& self, const py::object& given) {
  const Poses poses(given, "poses");
  const CollisionChecker& checker = *self.task().checker;
  const World& world = *self.task().world;
  if (poses.shape().empty()) {
    return py::bool_(checker.is_free(to_local(world, poses.view().front())));
  }
  py::array_t<bool> out(std::vector<py::ssize_t>(poses.shape().begin(), poses.shape().end()));
  bool* const values = out.mutable_data();
  unlocked(poses.view().size(), [&] {
    for (std::size_t i = 0; i < poses.view().size(); ++i) {
      values[i] = checker.is_free(to_local(world, poses.view()[i]));
    }
  });
  return out;
}

py::object is_free(PlanningTask& self, const py::object& given) {
  if (!py::isinstance<Path>(given)) return free_at(self, given);
  const auto& path = given.cast<const Path&>();
  return py::bool_(
      self.task().checker->is_free(to_local(*self.task().world, path.start), path.segments));
}

py::object clearance(PlanningTask& self, const py::object& given, std::optional<double> limit) {
  const double most = limit.value_or(infinity);
  const Poses poses(given, "poses");
  const CollisionChecker& checker = *self.task().checker;
  const World& world = *self.task().world;
  if (poses.shape().empty()) {
    return py::float_(checker.clearance(to_local(world, poses.view().front()), most));
  }
  py::array_t<double> out = empty_array(poses.shape());
  double* const values = out.mutable_data();
  unlocked(poses.view().size(), [&] {
    for (std::size_t i = 0; i < poses.view().size(); ++i) {
      values[i] = checker.clearance(to_local(world, poses.view()[i]), most);
    }
  });
  return out;
}

std::optional<Path> steer(PlanningTask& self, const py::object& from, const py::object& to) {
  const Pose start = pose_from(from, "start");
  const World& world = *self.task().world;
  const auto piece =
      self.connector().steer(to_local(world, start), to_local(world, pose_from(to, "goal")));
  if (!piece) return std::nullopt;
  return path_of(start, *piece);
}

std::optional<Path> connect(PlanningTask& self, const py::object& from, const py::object& to,
                            std::optional<double> cutoff) {
  const Pose start = pose_from(from, "start");
  const World& world = *self.task().world;
  const auto edge =
      self.connector().connect(to_local(world, start), to_local(world, pose_from(to, "goal")),
                               {.cutoff = cutoff.value_or(infinity)});
  if (!edge) return std::nullopt;
  return path_of(start, edge->piece);
}

double way_cost(PlanningTask& self, const py::object& given) {
  const std::vector<Segment> segments = segments_of(given);
  search::Driven driven = self.rule().initial_gear;
  double cost = search::drive_cost(self.rule(), segments, driven);
  if (self.rule().clearance_weight == 0.0) return cost;
  if (segments.empty()) return cost;
  const py::object first = py::isinstance<Path>(given) ? given : py::object(given[py::int_(0)]);
  const Pose start = first.cast<const Path&>().start;
  return cost + search::clearance_cost(self.task(), self.rule(),
                                       to_local(*self.task().world, start), segments,
                                       search::ClearanceSampling::search);
}

py::array_t<double> in_scenario(const PlanningTask& self, const LocalPose& pose) {
  return array_of(to_scenario(*self.task().world, pose));
}

py::tuple in_scenario(const PlanningTask& self, const Local<Bounds>& box) {
  const World& world = *self.task().world;
  const Pose low = to_scenario(world, LocalPose({box.x_min, box.y_min, 0.0}));
  const Pose high = to_scenario(world, LocalPose({box.x_max, box.y_max, 0.0}));
  return py::make_tuple(low.x, high.x, low.y, high.y);
}

py::dict own_options(const PlanningTask& self) {
  py::dict options;
  for (const auto& [name, value] : self.options().planner.values()) {
    options[name.c_str()] = object_of(value);
  }
  return options;
}

void bind_task_data(py::class_<PlanningTask, std::shared_ptr<PlanningTask>>& task) {
  task.def_property_readonly(
          "start", [](const PlanningTask& self) { return in_scenario(self, self.task().start); },
          "Start pose [x, y, heading]; it is free.")
      .def_property_readonly(
          "goal", [](const PlanningTask& self) { return in_scenario(self, self.task().goal); },
          "Goal pose [x, y, heading]; it is free.")
      .def_property_readonly(
          "vehicle", [](const PlanningTask& self) { return self.task().vehicle; }, "The vehicle.")
      .def_property_readonly(
          "radius", [](const PlanningTask& self) { return self.task().vehicle.min_turning_radius; },
          "Turning radius of the vehicle [m].")
      .def_property_readonly(
          "bounds",
          [](const PlanningTask& self) {
            return in_scenario(self, sampling_region(self.task(), Region::bounds));
          },
          "Range of the rear axle: (x_min, x_max, y_min, y_max) [m].")
      .def_property_readonly(
          "scene",
          [](const PlanningTask& self) {
            return in_scenario(self, sampling_region(self.task(), Region::scene));
          },
          "Box of start, goal and obstacles plus 20 m, within the bounds: (x_min, x_max, y_min, "
          "y_max) [m].")
      .def_property_readonly(
          "seed", [](const PlanningTask& self) { return self.options().budget.seed; },
          "Seed of random numbers, for example numpy.random.default_rng(task.seed).")
      .def_property_readonly("options", &own_options, "The planner's own options by name.");
}

}  // namespace

PlanningTask::PlanningTask(const Task& task, const PlanOptions& options)
    : task_(task),
      options_(options),
      rule_(search::cost_rule(options.cost, task_)),
      connector_(task_, rule_),
      budget_(options.budget) {}

search::Budget& PlanningTask::budget() {
  if (budget_) return *budget_;
  throw InputError("task", "its run is over");
}

void PlanningTask::found(double cost) {
  trace_.push_back({budget().elapsed(), budget().iterations(), cost});
}

PlannerAnswer answer_from(const py::handle& returned, PlanningTask& task) {
  Answer said{.path = py::reinterpret_borrow<py::object>(returned)};
  if (py::isinstance<Answer>(returned)) said = returned.cast<const Answer&>();
  PlannerAnswer answer{.lower_bound = said.lower_bound,
                       .iterations = task.budget().iterations(),
                       .reason = said.reason};
  for (const auto& [name, value] : said.counters) answer.counters.push_back({name, value});
  if (!said.tree.is_none()) answer.tree = tree_from(said.tree, *task.task().world);
  if (said.path.is_none()) {
    const std::optional<PlanStatus> exhausted = task.budget().exhausted();
    answer.status = said.proven ? PlanStatus::no_path : exhausted.value_or(PlanStatus::stopped);
    return answer;
  }
  answer.status = PlanStatus::solved;
  answer.segments = merged(segments_of(said.path));
  answer.anytime = task.trace();
  return answer;
}

void bind_task(py::module_& module) {
  py::class_<Answer>(module, "Answer", R"(Answer(path=None, *, lower_bound=None, proven=False,
    reason="", counters={}, tree=None)

Return value of a planner that has more than a path.

- `path`: a path, or a list of consecutive paths.
- `lower_bound`: proven lower bound on the cost of all paths [m]; None: nothing is proven.
- `proven`: without a path, whether it is proven that there is none.
- `reason`: why there is no path, one line.
- `counters`: counters by name.
- `tree`: search tree (poses, parents); parents come before their children, -1 for the root.)")
      .def(py::init([](py::object path, std::optional<double> lower_bound, bool proven,
                       std::string reason, std::map<std::string, std::int64_t> counters,
                       py::object tree) {
             return Answer{std::move(path),   lower_bound,         proven,
                           std::move(reason), std::move(counters), std::move(tree)};
           }),
           "path"_a = py::none(), py::kw_only(), "lower_bound"_a = py::none(), "proven"_a = false,
           "reason"_a = "", "counters"_a = py::dict(), "tree"_a = py::none())
      .def(py::pickle(
          [](const Answer& self) {
            return py::make_tuple(self.path, self.lower_bound, self.proven, self.reason,
                                  self.counters, self.tree);
          },
          [](const py::tuple& state) {
            return Answer{state[0],
                          state[1].cast<std::optional<double>>(),
                          state[2].cast<bool>(),
                          state[3].cast<std::string>(),
                          state[4].cast<std::map<std::string, std::int64_t>>(),
                          state[5]};
          }));

  py::class_<PlanningTask, std::shared_ptr<PlanningTask>> task(
      module, "Task",
      R"(Task of a planner in Python, with functions for planning.

All poses are in the scenario's frame. A planner returns a path from `start` to `goal`, a list of
consecutive paths, None, or an `Answer`.)");
  bind_task_data(task);
  task.def(
          "next", [](PlanningTask& self) { return self.budget().next(); },
          "next() -> bool\n\nBegins the next iteration. False if the run must end.")
      .def_property_readonly(
          "elapsed", [](PlanningTask& self) { return self.budget().elapsed(); },
          "Time since the begin of the run [s].")
      .def("is_free", &is_free, "what"_a, R"(is_free(what) -> bool or array of bool

Whether the vehicle is free at a pose, at each pose of an array, or along a whole path.)")
      .def("clearance", &clearance, "poses"_a, "most"_a = py::none(),
           R"(clearance(poses, most=None) -> float or array

Distance of the vehicle from the nearest obstacle at each pose, at most `most` [m].)")
      .def("steer", &steer, "start"_a, "goal"_a, R"(steer(start, goal) -> Path or None

Cheapest path between two poses on open ground. With continuous steering there may be none.)")
      .def("connect", &connect, "start"_a, "goal"_a, "cutoff"_a = py::none(),
           R"(connect(start, goal, cutoff=None) -> Path or None

Path of `steer`, if it is free and costs less than `cutoff` [m]. None: any cost.)")
      .def("cost", &way_cost, "path"_a, R"(cost(path) -> float

Cost of a path or of a list of consecutive paths [m]; the length if prices are not honoured.)")
      .def("found", &PlanningTask::found, "cost"_a,
           "found(cost)\n\nRecords the time of a new best path for `Result.anytime`.");
}

}  // namespace vandplan::python
