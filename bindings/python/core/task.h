// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a planner in Python receive, and what does it return?

#include <pybind11/pybind11.h>

#include <optional>

#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::python {

/// Task together with the connector, cost rule and budget that planners use.
class PlanningTask {
 public:
  PlanningTask(const Task& task, const PlanOptions& options);
  PlanningTask(const PlanningTask&) = delete;
  PlanningTask& operator=(const PlanningTask&) = delete;

  [[nodiscard]] const Task& task() const noexcept { return task_; }
  [[nodiscard]] const PlanOptions& options() const noexcept { return options_; }
  [[nodiscard]] const search::CostRule& rule() const noexcept { return rule_; }
  [[nodiscard]] search::Connector& connector() noexcept { return connector_; }
  /// Budget of the run. Throws InputError after the run.
  [[nodiscard]] search::Budget& budget();

  /// Records that a path of this cost is the best so far.
  void found(double cost);
  [[nodiscard]] const std::vector<CostSample>& trace() const noexcept { return trace_; }

  /// Ends the use of the budget; called when the run is over.
  void close() noexcept { budget_.reset(); }

 private:
  Task task_;
  PlanOptions options_;
  search::CostRule rule_;
  search::Connector connector_;
  std::optional<search::Budget> budget_;
  std::vector<CostSample> trace_;
};

/// Answer of a planner from what its Python function returned: None, a path, a list of paths, or an
/// `Answer`.
[[nodiscard]] PlannerAnswer answer_from(const pybind11::handle& returned, PlanningTask& task);

void bind_task(pybind11::module_& module);

}  // namespace vandplan::python
