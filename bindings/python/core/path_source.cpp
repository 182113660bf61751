// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Python generators that propose paths.

#include "bindings/python/core/path_source.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/core/own_planner.h"
#include "bindings/python/core/result.h"
#include "bindings/python/core/task.h"
#include "bindings/python/core/value.h"
#include "vandplan/planner.h"

namespace vandplan::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// Source of paths that runs a generator; each of its steps is an iteration.
class Generator final : public PathSource {
 public:
  Generator(const py::function& make, const Task& task, const PlanOptions& options)
      : task_(std::make_shared<PlanningTask>(task, options)), generator_(make(task_)) {
    if (!py::hasattr(generator_, "send")) {
      throw py::type_error("a source of paths: expected a function with yield in it");
    }
  }
  Generator(const Generator&) = delete;
  Generator& operator=(const Generator&) = delete;
  ~Generator() override {
    const py::gil_scoped_acquire lock;
    task_->close();
    generator_ = {};
  }

  std::optional<LocalPath> propose() override {
    const py::gil_scoped_acquire lock;
    py::object heard = py::none();
    if (is_begun_ && best_) heard = py::cast(*std::exchange(best_, std::nullopt));
    is_begun_ = true;
    py::object proposed;
    try {
      proposed = generator_.attr("send")(heard);
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_StopIteration)) throw;
      has_work_ = false;
      return std::nullopt;
    }
    if (proposed.is_none()) return std::nullopt;
    const Path& path = path_from(proposed);
    return LocalPath{to_local(*task_->task().world, path.start), path.segments};
  }

  [[nodiscard]] bool has_work() const override { return has_work_; }

  void hear(const LocalPath& best, double /*cost*/) override {
    best_ = Path{to_scenario(*task_->task().world, best.start), best.segments};
  }

 private:
  std::shared_ptr<PlanningTask> task_;
  py::object generator_;
  std::optional<Path> best_;  // Best path that the generator has not received yet.
  bool is_begun_ = false;
  bool has_work_ = true;
};

std::shared_ptr<Planner> planner_with(const py::dict& sources, std::int64_t share) {
  std::vector<NamedSource> named;
  for (const auto& [name, make] : sources) {
    const auto begin = [function = kept(make.cast<py::function>())](const Task& task,
                                                                    const PlanOptions& options) {
      const py::gil_scoped_acquire lock;
      return std::make_unique<Generator>(*function, task, options);
    };
    named.push_back({.name = py::str(name), .make = begin, .share = share});
  }
  auto planner = std::make_shared<Planner>(with_sources(std::move(named)));
  planner->function = SourcesFunction{std::move(planner->function)};
  return planner;
}

}  // namespace

void bind_path_source(py::module_& module) {
  module.def("with_sources", &planner_with, "sources"_a, py::kw_only(), "share"_a = 16,
             R"(with_sources(sources, *, share=16) -> Planner

The default planner, with more sources of paths beside its own workers.

`sources` are generator functions by name. Each takes a `Task` and yields a `Path`, `SpeedProfile`
or `Result` as a proposal, or None. `yield` returns the planner's cheapest path if there is a new
one, otherwise None.

A proposed path may begin or end elsewhere, or hit obstacles. The planner looks for a free path near
it and shortens that. The judge checks every answer. Sources are ignored for a vehicle with a
trailer.

`share` is the number of steps of a source in a round; the first rounds have fewer. Raises
InputError for a share outside [1, 10000].)");
}

}  // namespace vandplan::python
