// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Comparison of planners.

#include "vandplan/evaluation.h"

#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings/python/core/bind.h"
#include "bindings/python/core/interrupt.h"
#include "bindings/python/core/options.h"
#include "bindings/python/core/renamed.h"
#include "bindings/python/core/scenario.h"
#include "bindings/python/core/value.h"

namespace vandplan::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using evaluation::Campaign, evaluation::Comparison;

std::vector<Planner> planners_from(const py::iterable& given) {
  std::vector<Planner> planners;
  for (const py::handle item : given) {
    if (py::isinstance<py::str>(item)) {
      for (Planner& planner : evaluation::planners_called(item.cast<std::string>())) {
        planners.push_back(std::move(planner));
      }
    } else {
      planners.push_back(*planner_from(item));
    }
  }
  return planners;
}

std::vector<Region> regions_from(const std::vector<std::string>& given) {
  std::vector<Region> regions;
  for (const std::string& word : given) {
    if (word != "bounds" && word != "scene") {
      throw InputError("regions", "has \"" + word + "\", expected bounds or scene");
    }
    regions.push_back(word == "bounds" ? Region::bounds : Region::scene);
  }
  return regions;
}

std::vector<evaluation::CampaignScenario> scenarios_from(const py::iterable& given) {
  std::vector<evaluation::CampaignScenario> scenarios;
  for (const py::handle item : given) {
    if (!py::isinstance<CheckedScenario>(item)) {
      throw InputError(fmt::format("scenarios[{}]", scenarios.size()), "expected a Scenario");
    }
    const ScenarioFile file = item.cast<const CheckedScenario&>().file();
    scenarios.push_back({file, file.scenario.name + ".yaml"});
  }
  return scenarios;
}

/// Progress function that calls a Python function with the numbers of runs done and in total.
std::function<void(const evaluation::Progress&)> report_to(const py::object& progress) {
  if (progress.is_none()) return {};
  return [&progress](const evaluation::Progress& now) {
    const py::gil_scoped_acquire lock;
    progress(now.kept + now.done, now.total);
  };
}

Comparison compare(const py::iterable& scenarios, const py::iterable& planners,
                   const std::filesystem::path& folder, int repeats, int repeats_per_goal,
                   std::optional<double> time_limit, std::optional<std::int64_t> max_iterations,
                   std::uint64_t seed, const std::vector<std::string>& regions, int jobs,
                   const py::object& progress, std::optional<double> time,
                   const py::kwargs& options) {
  time_limit = renamed("time_limit", time_limit, "time", time);
  Campaign campaign{.scenarios = scenarios_from(scenarios),
                    .planners = planners_from(planners),
                    .regions = regions_from(regions),
                    .repeats = repeats,
                    .repeats_per_goal = repeats_per_goal,
                    .seed = seed,
                    .settings = settings_from(options)};
  if (time_limit) campaign.settings.push_back({"time_limit", typed(py::float_(*time_limit))});
  if (max_iterations) {
    campaign.settings.push_back({"max_iterations", std::to_string(*max_iterations)});
  }
  Comparison comparison;
  {
    const Interruptible interruptible;
    const evaluation::RunnerOptions runner{
        .jobs = jobs, .stop = interruptible.stop(), .report = report_to(progress)};
    const py::gil_scoped_release release;
    comparison = evaluation::compare(campaign, folder.string(), runner);
  }
  raise_signals();
  return comparison;
}

}  // namespace

void bind_evaluation(py::module_& module) {
  ValueClass<Comparison> comparison(module, "Comparison", R"(Result of a comparison of planners.)");
  comparison
      .field("missing", &Comparison::missing,
             "Number of runs that were not done, because the comparison was stopped.")
      .field("headline", &Comparison::headline, "Summary and its tables, as Markdown.")
      .field("store", &Comparison::store, "File with all runs (SQLite).")
      .field("page", &Comparison::page, "File with the whole report, for a browser.")
      .field("text", &Comparison::text, "File with the whole report, as Markdown.")
      .field("gallery", &Comparison::gallery,
             "File with a picture of the best path of each scenario (PNG).")
      .part(&Comparison::json);
  comparison.pickled()
      .def_property_readonly(
          "figures",
          [](const Comparison& self) {
            return py::module_::import("json").attr("loads")(self.json);
          },
          "Figures of the headline, a dict.")
      .def(
          "runs",
          [](const Comparison& self) {
            return py::module_::import("vandplan.stores").attr("read_store")(self.store);
          },
          "runs() -> pandas.DataFrame\n\nA row for each run, as `read_store` returns it.")
      .def("_repr_markdown_", [](const Comparison& self) { return self.headline; })
      .def("__repr__", [](const Comparison& self) {
        return fmt::format("<vandplan.Comparison in {}>", self.page);
      });
  module.def(
      "compare", &compare, "scenarios"_a, "planners"_a, "folder"_a, py::kw_only(), "repeats"_a = 5,
      "repeats_per_goal"_a = 1, "time_limit"_a = py::none(), "max_iterations"_a = py::none(),
      "seed"_a = 1, "regions"_a = std::vector<std::string>{"bounds"}, "jobs"_a = 1,
      "progress"_a = py::none(), "time"_a = py::none(),
      R"(compare(scenarios, planners, folder, *, repeats=5, repeats_per_goal=1, time_limit=None,
    max_iterations=None, seed=1, regions=["bounds"], jobs=1, progress=None, **options) -> Comparison

Runs each planner on each scenario with equal seeds, and writes a report into `folder`.

The judge checks every path. All runs are stored in `folder`; runs that the folder holds already are
not repeated.

- `planners`: names, words such as "thesis" or "all", `Planner` objects, or functions of a `Task`.
- `repeats`: runs of a planner on each scenario.
- `repeats_per_goal`: runs for each goal, in scenarios with a row of goals.
- `time_limit` [s], `max_iterations`: budget of a run.
- `seed`: seed from which that of each run is derived.
- `regions`: where planners draw samples, "bounds" or "scene".
- `jobs`: number of runs at the same time.
- `progress`: function that is called with the numbers of runs done and in total.
- `options`: options of the planners that accept them.)");
}

}  // namespace vandplan::python
