// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Planning of one and of many problems, and smoothing.

#include <pybind11/stl.h>

#include <algorithm>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/interrupt.h"
#include "bindings/python/core/options.h"
#include "bindings/python/core/renamed.h"
#include "bindings/python/core/result.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"

namespace vandplan::python {
namespace {

using namespace py::literals;

/// Whether Ctrl-C returns the best path so far instead of raising.
bool returns_at_interrupt(const std::string& word) {
  if (word == "raise" || word == "return") return word == "return";
  throw InputError("on_interrupt", "is \"" + word + "\", expected raise or return");
}

/// Runs `work` with the options, so that Ctrl-C ends it soon. Then raises KeyboardInterrupt, unless
/// `returns` is set.
template <typename Work>
void run_interruptibly(PlanOptions& options, bool returns, Work work) {
  {
    const Interruptible interruptible;
    options.budget.stop = interruptible.stop();
    const py::gil_scoped_release release;
    work();
  }
  options.budget.stop = {};
  try {
    raise_signals();
  } catch (const py::error_already_set& error) {
    if (!returns || !error.matches(PyExc_KeyboardInterrupt)) throw;
  }
}

RunResult planned(const CheckedScenario& scenario, std::shared_ptr<const Planner> planner,
                  PlanOptions options, bool returns) {
  RunResult run{scenario, std::move(planner), {}};
  const Problem& problem = scenario.problem();
  run_interruptibly(options, returns,
                    [&] { run.record.result = plan(problem, *run.planner, options); });
  run.record.scenario = scenario.scenario().name;
  run.record.planner = run.planner->name;
  run.record.options = std::move(options);
  return run;
}

RunResult plan_one(const CheckedScenario& scenario, const py::object& planner,
                   std::optional<double> time_limit, std::optional<std::int64_t> max_iterations,
                   std::uint64_t seed, const std::string& on_interrupt,
                   const std::optional<SiteTable>& site, std::optional<double> time,
                   const py::kwargs& options) {
  time_limit = renamed("time_limit", time_limit, "time", time);
  const bool returns = returns_at_interrupt(on_interrupt);
  std::shared_ptr<const Planner> chosen = planner_from(planner);
  PlanOptions all =
      options_for(*chosen, scenario.options(), {time_limit, max_iterations, seed, options, site},
                  scenario.scenario().vehicle);
  return planned(scenario, std::move(chosen), std::move(all), returns);
}

/// Scenario for each pair of start and goal, all in one world.
std::vector<CheckedScenario> scenarios_for(const CheckedScenario& scenario,
                                           const py::object& starts, const py::object& goals) {
  const Poses from(starts, "starts");
  const Poses to(goals, "goals");
  warn_of_degrees(from.view(), "starts");
  warn_of_degrees(to.view(), "goals");
  const std::vector<py::ssize_t> shape = shape_of_pairs(from, to);
  if (shape.size() > 1) throw InputError("starts, goals", "expected the shape (N, 3) or (3,)");
  const std::size_t size = std::max(from.view().size(), to.view().size());
  std::vector<CheckedScenario> scenarios;
  scenarios.reserve(size);
  for (std::size_t i = 0; i < size && !from.view().empty() && !to.view().empty(); ++i) {
    scenarios.push_back(scenario.with_poses(from.view()[from.view().size() == 1 ? 0 : i],
                                            to.view()[to.view().size() == 1 ? 0 : i],
                                            scenario.scenario().curvatures));
  }
  return scenarios;
}

std::vector<RunResult> plan_pairs(const CheckedScenario& scenario, const py::object& starts,
                                  const py::object& goals, const py::object& planner,
                                  std::optional<int> given_jobs, std::optional<double> time_limit,
                                  std::optional<std::int64_t> max_iterations, std::uint64_t seed,
                                  const std::optional<SiteTable>& site, std::optional<double> time,
                                  std::optional<int> threads, const py::kwargs& keywords) {
  time_limit = renamed("time_limit", time_limit, "time", time);
  const int jobs = renamed("jobs", given_jobs, "threads", threads).value_or(1);
  if (jobs < 1 || jobs > 1024) throw InputError("jobs", "expected 1 to 1024");
  const std::shared_ptr<const Planner> chosen = planner_from(planner);
  PlanOptions options =
      options_for(*chosen, scenario.options(), {time_limit, max_iterations, seed, keywords, site},
                  scenario.scenario().vehicle);
  std::vector<CheckedScenario> scenarios = scenarios_for(scenario, starts, goals);
  std::vector<Problem> problems;
  for (const CheckedScenario& one : scenarios) {
    if (site) {
      site->expect_goal(one.scenario().goal, "goals[" + std::to_string(problems.size()) + "]");
    }
    problems.push_back(one.problem());
  }
  std::vector<PlanResult> results(problems.size());
  run_interruptibly(options, false, [&] {
    plan_many(problems, *chosen, options, jobs,
              [&](std::size_t i, PlanResult result) { results[i] = std::move(result); });
  });
  std::vector<RunResult> runs;
  runs.reserve(results.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    runs.push_back({std::move(scenarios[i]), chosen, {}});
    runs.back().record = {.scenario = scenario.scenario().name,
                          .planner = chosen->name,
                          .options = options,
                          .result = std::move(results[i])};
  }
  return runs;
}

/// Options of the run that planned a path; empty if they are unknown.
std::vector<Setting> stored_with(const py::object& given) {
  if (!py::isinstance<RunResult>(given)) return {};
  return stored_options(given.cast<const RunResult&>().record);
}

RunResult smooth_path(const CheckedScenario& scenario, const py::object& given,
                      const std::string& method, std::optional<double> time_limit,
                      std::optional<std::int64_t> max_iterations, std::uint64_t seed,
                      std::optional<double> time, const py::kwargs& keywords) {
  time_limit = renamed("time_limit", time_limit, "time", time);
  const SmoothMethod chosen = smooth_method_named(method);
  const Path& path = path_from(given);
  RunResult run{scenario, std::make_shared<const Planner>(smoother(path, chosen)), {}};
  PlanOptions options = smooth_options(scenario.options(), stored_with(given));
  set_keywords(options, *run.planner, {time_limit, max_iterations, seed, keywords});
  Smoothed smoothed;
  const Problem& problem = scenario.problem();  // Needs Python's lock.
  run_interruptibly(options, false, [&] { smoothed = smooth(problem, path, chosen, options); });
  smoothed.options.budget.stop = {};
  run.record = {.scenario = scenario.scenario().name,
                .planner = run.planner->name,
                .options = std::move(smoothed.options),
                .result = std::move(smoothed.result)};
  return run;
}

}  // namespace

void bind_planning(py::module_& module) {
  module.def("plan", &plan_one, "scenario"_a, "planner"_a = default_planner().name, py::kw_only(),
             "time_limit"_a = py::none(), "max_iterations"_a = py::none(), "seed"_a = 1,
             "on_interrupt"_a = "raise", "site"_a = py::none(), "time"_a = py::none(),
             R"(plan(scenario, planner="anytime", *, time_limit=None, max_iterations=None, seed=1,
    on_interrupt="raise", site=None, **options) -> Result

Plans a path; the judge checks it before it is returned.

- `planner`: a name, a `Planner`, or a function of a `Task`.
- `time_limit` [s], `max_iterations`: budget of the run; 1 s without both. With `max_iterations`
  alone the result repeats bit for bit.
- `seed`: seed of the random numbers.
- `on_interrupt`: "raise": Ctrl-C ends the run and raises KeyboardInterrupt. "return": it returns
  the best path so far.
- `site`: a `SiteTable`. The default planner begins with its way; searches with estimate="site" look
  up its costs.
- `options`: options of the command line's --set, such as margin=0.3, style="shortest",
  steering="continuous", threads=2. They replace those of the scenario's file.

Prices that are not set are those of a truck driver. They are smaller for a turning radius below 7
m. Raises InputError, a ValueError, for wrong input.)");
  module.def("plan_many", &plan_pairs, "scenario"_a, "starts"_a, "goals"_a,
             "planner"_a = default_planner().name, py::kw_only(), "jobs"_a = py::none(),
             "time_limit"_a = py::none(), "max_iterations"_a = py::none(), "seed"_a = 1,
             "site"_a = py::none(), "time"_a = py::none(), "threads"_a = py::none(),
             R"(plan_many(scenario, starts, goals, planner="anytime", *, jobs=1, time_limit=None,
    max_iterations=None, seed=1, site=None, **options) -> list of Result

Plans from each start to its goal in the world of the scenario, `jobs` problems at a time.

Starts and goals are poses of shape (N, 3), or one pose for all. Each plan has the whole budget, and
the same result as by `plan`. The other keywords are those of `plan`.)");
  module.def(
      "smooth", &smooth_path, "scenario"_a, "path"_a, py::kw_only(), "method"_a = "optimised",
      "time_limit"_a = py::none(), "max_iterations"_a = py::none(), "seed"_a = 1,
      "time"_a = py::none(),
      R"(smooth(scenario, path, *, method="optimised", time_limit=None, max_iterations=None, seed=1,
    **options) -> Result

Cheaper path along the way of a `Path`, `SpeedProfile` or `Result`, which the wheels can follow.

- `method`: "optimised" or "clothoids".
- `time_limit` [s], `max_iterations`, `seed`: budget and seed.
- `options`: options of `plan`. They replace those of a `Result` (prices, cost, margin, min_stroke,
  steering), which replace those of the scenario.

The budget of a `Result` is not used. If its steering is "reeds-shepp", that becomes
"continuous-between-stops"; with a trailer only if the cost is the time. The judge checks the path.
By these options it is never worse than a given path that the judge accepts: without an improvement
the given path is returned.)");
}

}  // namespace vandplan::python
