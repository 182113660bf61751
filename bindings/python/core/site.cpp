// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Tables of what driving costs from everywhere on a site to its goals.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <utility>
#include <vector>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/interrupt.h"
#include "bindings/python/core/options.h"
#include "bindings/python/core/scenario.h"
#include "bindings/python/core/site.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan::python {
namespace {

using namespace py::literals;
using FileOfTable = std::filesystem::path;  // Accepts str and os.PathLike.

/// Complete options of a table for a scenario, and of plans with so many iterations. Throws
/// InputError for a keyword that means nothing: without plans the budget does.
PlanOptions site_options(const CheckedScenario& scenario, const py::kwargs& keywords,
                         std::optional<std::int64_t> iterations = {}) {
  for (const auto& [name, value] : keywords) {
    const std::string key = py::str(name);
    const std::string fault(fault_of_site_option(key));
    const bool is_of_plans = iterations && key != "site";
    if (!fault.empty() && !is_of_plans) throw InputError(key, fault);
  }
  const Planner& planner = default_planner();
  PlanOptions options = options_for(planner, scenario.options(), {{}, iterations, 1, keywords},
                                    scenario.scenario().vehicle);
  const bool has_seed = keywords.contains("seed") && !keywords["seed"].is_none();
  if (has_seed) set_option(options, planner, "seed", typed(keywords["seed"]));
  return options;
}

/// `jobs`, for options that call it threads. Throws InputError.
int threads_of(int jobs) {
  if (jobs < 1 || jobs > 256) throw InputError("jobs", "expected 1 to 256");
  return jobs;
}

/// Poses from Python: (N, 3), or one pose. Throws InputError naming `where`.
std::vector<Pose> list_of(const py::object& given, const char* where) {
  const Poses poses(given, where);
  if (poses.shape().size() > 1) throw InputError(where, "expected the shape (N, 3) or (3,)");
  warn_of_degrees(poses.view(), where);
  return {poses.view().begin(), poses.view().end()};
}

SiteTable table_of(const Problem& problem, const std::vector<Pose>& goals,
                   const PlanOptions& options, SiteTableOptions wanted) {
  std::optional<SiteTable> table;
  {
    const Interruptible interruptible;
    wanted.stop = interruptible.stop();
    const py::gil_scoped_release release;
    table = make_site_table(problem, goals, options, wanted);
  }
  raise_signals();
  if (!table) throw InputError("site_table", "was stopped");
  return *std::move(table);
}

/// Goals from Python; none: those of the scenario.
std::vector<Pose> goals_of(const Problem& problem, const PlanOptions& options,
                           const py::object& goals) {
  return goals.is_none() ? site_goals(problem, options).poses : list_of(goals, "goals");
}

SiteTable make_table(const CheckedScenario& scenario, const py::object& goals, int headings,
                     double cell, int jobs, const py::kwargs& keywords) {
  const Problem& problem = scenario.problem();
  const PlanOptions options = site_options(scenario, keywords);
  return table_of(problem, goals_of(problem, options, goals), options,
                  {.headings = headings,
                   .cell = cell,
                   .threads = threads_of(jobs),
                   .starts = {problem.start()}});
}

std::shared_ptr<SharedSiteTable> changing_table(const CheckedScenario& scenario,
                                                const py::object& goals, int headings, double cell,
                                                int jobs, const py::kwargs& keywords) {
  const Problem& problem = scenario.problem();
  const PlanOptions options = site_options(scenario, keywords);
  const std::vector<Pose> poses = goals_of(problem, options, goals);
  const py::gil_scoped_release release;
  const SiteTableOptions wanted{
      .headings = headings, .cell = cell, .threads = threads_of(jobs), .starts = {problem.start()}};
  return std::make_shared<SharedSiteTable>(
      SharedSiteTable{ChangingSiteTable(problem, poses, options, wanted)});
}

py::object cost_of(const SiteTable& self, const py::object& given, std::size_t goal) {
  if (goal >= self.goals().size()) throw InputError("goal", "the table has no such goal");
  const Poses poses(given, "poses");
  if (poses.shape().empty()) return py::float_(self.cost(poses.view().front(), goal));
  py::array_t<double> costs = empty_array(poses.shape());
  double* const values = costs.mutable_data();
  unlocked(poses.view().size(), [&] {
    for (std::size_t i = 0; i < poses.view().size(); ++i) {
      values[i] = self.cost(poses.view()[i], goal);
    }
  });
  return costs;
}

std::optional<Path> way_of(const SiteTable& self, const CheckedScenario& scenario,
                           const py::kwargs& keywords) {
  const Problem& problem = scenario.problem();
  const auto way = site_way(self, problem, site_options(scenario, keywords));
  if (!way) return std::nullopt;
  return way->path;
}

SiteTable read_table(const FileOfTable& file) { return read_site_table(file.string()); }

/// Costs of the table's ways, or of plans.
std::vector<SiteCost> costs_between(const Problem& problem, const std::vector<Pose>& starts,
                                    const SiteTable& table, PlanOptions options, int jobs,
                                    bool has_plans) {
  std::vector<SiteCost> costs;
  {
    const Interruptible interruptible;
    options.budget.stop = interruptible.stop();
    if (has_plans) options.site = std::make_shared<const SiteTable>(table);
    const py::gil_scoped_release release;
    costs = has_plans ? plan_matrix(problem, starts, options, jobs)
                      : site_matrix(table, problem, starts, options, jobs);
  }
  raise_signals();
  return costs;
}

py::tuple matrix(const CheckedScenario& scenario, const py::object& starts, const py::object& goals,
                 int jobs, std::optional<std::int64_t> iterations, const py::kwargs& keywords) {
  if (iterations && *iterations < 1) throw InputError("max_iterations", "expected at least 1");
  const Problem& problem = scenario.problem();
  const PlanOptions options = site_options(scenario, keywords, iterations);
  const std::vector<Pose> from = list_of(starts, "starts");
  const bool is_table = py::isinstance<SiteTable>(goals);
  const SiteTable table =
      is_table
          ? goals.cast<SiteTable>()
          : table_of(problem, list_of(goals, "goals"), options,
                     {.threads = threads_of(jobs), .starts = from, .allows_blocked_goals = true});
  const std::vector<SiteCost> costs =
      costs_between(problem, from, table, options, threads_of(jobs), iterations.has_value());
  const std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(from.size()),
                                          static_cast<py::ssize_t>(table.goals().size())};
  py::array_t<double> cost = empty_array(shape);
  py::array_t<double> bound = empty_array(shape);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    cost.mutable_data()[i] = costs[i].cost;
    bound.mutable_data()[i] = costs[i].lower_bound;
  }
  return py::make_tuple(cost, bound);
}

py::tuple cheapest_of(const Numbers& cost, const Numbers& bound) {
  const bool is_matrix = cost.ndim() == 2 && bound.ndim() == 2 && cost.shape(0) == bound.shape(0) &&
                         cost.shape(1) == bound.shape(1) && cost.shape(1) > 0;
  if (!is_matrix) {
    throw InputError("lower_bound", "expected the costs and bounds of a matrix, of shape (N, M)");
  }
  std::vector<SiteCost> costs(static_cast<std::size_t>(cost.size()));
  for (std::size_t i = 0; i < costs.size(); ++i) {
    costs[i] = {.cost = cost.data()[i], .lower_bound = bound.data()[i]};
  }
  const auto cheapest = cheapest_goals(costs, static_cast<std::size_t>(cost.shape(1)));
  py::array_t<py::ssize_t> goal(cost.shape(0));
  py::array_t<bool> is_proven(cost.shape(0));
  for (std::size_t i = 0; i < cheapest.size(); ++i) {
    goal.mutable_data()[i] = cheapest[i] ? static_cast<py::ssize_t>(cheapest[i]->goal) : -1;
    is_proven.mutable_data()[i] = cheapest[i] && cheapest[i]->is_proven;
  }
  return py::make_tuple(goal, is_proven);
}

void bind_table(py::module_& module) {
  py::class_<SiteTable>(module, "SiteTable",
                        R"(Costs of driving from everywhere on a site to its goals.

`site_table` makes one, `read_site_table` reads one, `plan(scenario, site=table)` plans with it. It
holds for one world, vehicle, prices and margin, and for any start.)")
      .def_property_readonly(
          "goals",
          [](const SiteTable& self) { return array_of(std::span<const Pose>(self.goals())); },
          "Goals of the table, of shape (N, 3).")
      .def("cost", &cost_of, "poses"_a, "goal"_a = 0, R"(cost(poses, goal=0) -> float or array

Approximate cost of driving from each pose to a goal [m], by number. Infinite without a way.)")
      .def("way", &way_of, "scenario"_a, R"(way(scenario, **options) -> Path or None

Free path of arcs and lines from the start of a scenario to its goal, read off the table.

The options are those of `site_table`. Raises InputError if the table was made for something else.)")
      .def(
          "save",
          [](const SiteTable& self, const FileOfTable& file) {
            write_file(file.string(), site_table_to_bytes(self));
          },
          "file"_a,
          "save(file)\n\nWrites a file (.vst) for `read_site_table` and the command line.")
      .def(py::pickle(
          [](const SiteTable& self) { return py::bytes(std::string(site_table_to_bytes(self))); },
          [](const py::bytes& state) {
            const auto bytes = std::make_shared<const std::string>(state);
            return site_table_from_bytes(*bytes, bytes, "site");
          }));
}

void bind_changing_table(py::module_& module) {
  py::class_<SharedSiteTable, std::shared_ptr<SharedSiteTable>>(
      module, "ChangingSiteTable",
      R"(ChangingSiteTable(scenario, goals=None, *, headings=36, cell=0.12, jobs=1, **options)

A table of a site that is repaired where the site changes.

    docks = ChangingSiteTable(yard, goals)
    docks.repair(yard_with_a_parked_truck)
    plan(yard_with_a_parked_truck, site=docks.table)

`Replanner(scenario, site=docks)` repairs it where its patches change the ground.

The arguments are those of `site_table`. It keeps some 15 MB for each goal.)")
      .def(py::init(&changing_table), "scenario"_a, "goals"_a = py::none(), py::kw_only(),
           "headings"_a = SiteTableOptions{}.headings, "cell"_a = SiteTableOptions{}.cell,
           "jobs"_a = 1)
      .def(
          "repair",
          [](SharedSiteTable& self, const CheckedScenario& scenario) {
            self.alone.run([&] { self.table.repair(scenario.scenario()); });
          },
          "scenario"_a, R"(repair(scenario)

Makes the table that of a scenario with the same vehicle and other obstacles, cells or zones. Its
start does not matter.

The result is the table that `site_table` makes, except that the table keeps its box. A goal that is
not free has no ways until it is free again.)")
      .def_property_readonly(
          "table",
          [](const SharedSiteTable& self) {
            self.alone.expect();
            return self.table.table();
          },
          "The table now, a `SiteTable`. A repair does not change it.");
}

}  // namespace

void bind_site(py::module_& module) {
  bind_table(module);
  bind_changing_table(module);
  module.def("site_table", &make_table, "scenario"_a, "goals"_a = py::none(), py::kw_only(),
             "headings"_a = SiteTableOptions{}.headings, "cell"_a = SiteTableOptions{}.cell,
             "jobs"_a = 1,
             R"(site_table(scenario, goals=None, *, headings=36, cell=0.12, jobs=1,
    **options) -> SiteTable

Computes what driving costs from everywhere on a site to each goal.

- `goals`: poses of shape (N, 3), or one pose. None: the goal of the scenario, or the poses of its
  `any_of` that are free.
- `headings`: headings of a full turn. `cell`: side of a cell of places [turning radii].
- `jobs`: threads that share the goals.
- `options`: options of `plan` that set prices, gears and margin. Those of the budget are refused.

A trailer is left out: the table is that of the tractor alone.

Raises InputError for a goal that is not free, or cost="time".)");
  module.def("matrix", &matrix, "scenario"_a, "starts"_a, "goals"_a, py::kw_only(), "jobs"_a = 1,
             "max_iterations"_a = py::none(),
             R"(matrix(scenario, starts, goals, *, jobs=1, max_iterations=None, **options)
    -> (cost, lower_bound)

Costs of free ways from each start to each goal, and proven lower bounds [m], of shape (N, M).

`goals` are poses or a `SiteTable`. A cost is infinite if no way was found, its bound too if it is
proven that there is none. Bounds are those of open ground and hold for every path. With `max_iterations`, costs and bounds are those of plans that
begin with the ways: mostly cheaper, and slower. Where no plan is as cheap, the way's cost stays,
unless steering="continuous". A trailer needs plans, and is straight at both ends. The other keywords are
those of `site_table`, with `max_iterations` also the budget of each plan.)");
  module.def("cheapest_goals", &cheapest_of, "cost"_a, "lower_bound"_a,
             R"(cheapest_goals(cost, lower_bound) -> (goal, is_proven)

The goal that costs least from each start, by its number; -1 if none was found. `cost` and
`lower_bound` are those of `matrix`. It is proven to be the cheapest if it costs no more than the
lower bounds of all other goals.)");
  module.def("read_site_table", &read_table, "file"_a,
             "read_site_table(file) -> SiteTable\n\nReads a file of `SiteTable.save` or the "
             "command line.");
}

}  // namespace vandplan::python
