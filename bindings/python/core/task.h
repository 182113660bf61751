// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a planner in Python given, and what does it answer?

#include <pybind11/pybind11.h>

#include <optional>

#include "vandplan/outcome.h"
#include "vandplan/search.h"

namespace vandplan::python {

/// A task with what planners are made of, all in one.
class PlanningTask {
 public:
  PlanningTask(const Task& task, const PlanOptions& options);
  PlanningTask(const PlanningTask&) = delete;
  PlanningTask& operator=(const PlanningTask&) = delete;

  [[nodiscard]] const Task& task() const noexcept { return task_; }
  [[nodiscard]] const PlanOptions& options() const noexcept { return options_; }
  [[nodiscard]] const search::CostRule& rule() const noexcept { return rule_; }
  [[nodiscard]] search::Connector& connector() noexcept { return connector_; }
  /// Throws InputError once the run is over.
  [[nodiscard]] search::Budget& budget();

  /// Notes that a path of this cost is the best so far.
  void found(double cost);
  [[nodiscard]] const std::vector<CostSample>& trace() const noexcept { return trace_; }

  /// The run is over: nobody may ask for its budget any more.
  void close() noexcept { budget_.reset(); }

 private:
  Task task_;
  PlanOptions options_;
  search::CostRule rule_;
  search::Connector connector_;
  std::optional<search::Budget> budget_;
  std::vector<CostSample> trace_;
};

/// What a function of Python returned, as an answer: None, a path, a list of paths, or an `Answer`.
[[nodiscard]] PlannerAnswer answer_from(const pybind11::handle& returned, PlanningTask& task);

void bind_task(pybind11::module_& module);

}  // namespace vandplan::python
