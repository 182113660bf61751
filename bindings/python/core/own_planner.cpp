// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Planners of the library, and planners from Python functions.

#include "bindings/python/core/own_planner.h"

#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <limits>

#include "bindings/python/core/bind.h"
#include "bindings/python/core/options.h"
#include "bindings/python/core/path_source.h"
#include "bindings/python/core/result.h"
#include "bindings/python/core/task.h"
#include "vandplan/input_error.h"

namespace vandplan::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// Planner function that calls a Python function.
struct PythonFunction {
  std::shared_ptr<const py::function> kept;
  PlannerAnswer operator()(const Task& task, const PlanOptions& options) const;
};

/// Planner function that begins with a path.
struct WarmFunction {
  Path path;
  PlannerFunction function;
  PlannerAnswer operator()(const Task& task, const PlanOptions& options) const {
    return function(task, options);
  }
};

PlannerAnswer call(const py::function& function, const Task& task, const PlanOptions& options) {
  const py::gil_scoped_acquire lock;
  const auto given = std::make_shared<PlanningTask>(task, options);
  PlannerAnswer answer;
  try {
    answer = answer_from(function(given), *given);
  } catch (...) {
    given->close();
    throw;
  }
  given->close();
  return answer;
}

PlannerAnswer PythonFunction::operator()(const Task& task, const PlanOptions& options) const {
  return call(*kept, task, options);
}

Planner warm_planner(const Path& path) {
  Planner planner = warm_started(path);
  planner.function = WarmFunction{path, std::move(planner.function)};
  return planner;
}

OptionValue value_from(const py::handle& given, const std::string& name) {
  if (py::isinstance<py::bool_>(given)) return given.cast<bool>();
  if (py::isinstance<py::int_>(given)) return given.cast<std::int64_t>();
  if (py::isinstance<py::float_>(given)) return given.cast<double>();
  if (py::isinstance<py::str>(given)) return given.cast<std::string>();
  throw InputError("options." + name, "expected a default that is a bool, a number or a word");
}

/// Option from its default alone, (default, least, most), or (default, [word, ...]).
OptionInfo option_from(const std::string& name, const py::handle& given) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  OptionInfo info{
      .name = name, .summary = name, .default_value = {}, .least = -infinity, .most = infinity};
  if (!py::isinstance<py::tuple>(given)) {
    info.default_value = value_from(given, name);
    if (const auto* const word = std::get_if<std::string>(&info.default_value))
      info.words = {*word};
    return info;
  }
  const auto parts = py::reinterpret_borrow<py::tuple>(given);
  if (parts.size() != 2 && parts.size() != 3) {
    throw InputError("options." + name,
                     "expected a default, (default, least, most) or (default, words)");
  }
  info.default_value = value_from(parts[0], name);
  if (parts.size() == 2) {
    info.words = parts[1].cast<std::vector<std::string>>();
  } else {
    info.least = parts[1].cast<double>();
    info.most = parts[2].cast<double>();
  }
  return info;
}

std::shared_ptr<Planner> make_planner(const std::string& name, const py::function& function,
                                      const std::string& summary, const py::dict& options,
                                      const std::vector<std::string>& capabilities, bool anytime,
                                      bool deterministic) {
  auto planner = std::make_shared<Planner>();
  planner->name = name;
  planner->summary = summary;
  planner->properties = {.family = name, .anytime = anytime, .deterministic = deterministic};
  for (const std::string& capability : capabilities) {
    planner->properties.capabilities.add(capability_named(capability));
  }
  for (const auto& [key, value] : options) {
    planner->options.push_back(option_from(py::str(key), value));
  }
  planner->function = planner_function(function);
  return planner;
}

/// A planner as `vandplan.Planner` makes it, also with the keywords of version 0.2.0.
std::shared_ptr<Planner> planner_from_keywords(const std::string& name,
                                               const py::function& function,
                                               const std::string& summary, const py::dict& options,
                                               const std::vector<std::string>& capabilities,
                                               bool anytime, bool deterministic,
                                               bool honours_prices, bool honours_gears) {
  std::shared_ptr<Planner> planner =
      make_planner(name, function, summary, options, capabilities, anytime, deterministic);
  if (honours_prices) planner->properties.capabilities.add(Capability::prices);
  if (honours_gears) planner->properties.capabilities.add(Capability::gears);
  return planner;
}

py::dict options_of(const Planner& planner) {
  py::dict options;
  for (const OptionInfo& info : planner.options) {
    options[info.name.c_str()] = py::dict("default"_a = object_of(info.default_value),
                                          "range"_a = info.range(), "summary"_a = info.summary);
  }
  return options;
}

py::dict properties_of(const Planner& planner) {
  const PlannerProperties& p = planner.properties;
  py::dict properties("family"_a = p.family, "strategy"_a = p.strategy, "estimate"_a = p.estimate,
                      "tries_goal"_a = p.tries_goal, "capabilities"_a = names_of(p.capabilities),
                      "anytime"_a = p.anytime, "deterministic"_a = p.deterministic,
                      "groups"_a = p.groups);
  for (const Capability capability : all_capabilities()) {  // as version 0.2.0 had them
    properties[py::str("honours_" + std::string(name_of(capability)))] = planner.can(capability);
  }
  return properties;
}

/// State for pickle: a name, a path of a warm start, or a function with the planner's properties.
py::tuple planner_state(const Planner& planner) {
  if (const auto* const warm = planner.function.target<WarmFunction>()) {
    return py::make_tuple("warm", warm->path);
  }
  if (planner.function.target<SourcesFunction>() != nullptr) {
    throw py::type_error("a planner with sources of paths cannot be pickled");
  }
  const auto* const own = planner.function.target<PythonFunction>();
  if (own == nullptr) return py::make_tuple("named", planner.name);
  py::list options;
  for (const OptionInfo& o : planner.options) {
    options.append(py::make_tuple(o.name, o.default_value, o.least, o.most, o.words));
  }
  const PlannerProperties& p = planner.properties;
  return py::make_tuple("own", planner.name, *own->kept, planner.summary, options,
                        names_of(p.capabilities), p.anytime, p.deterministic);
}

std::shared_ptr<Planner> planner_of(const py::tuple& state) {
  const auto kind = state[0].cast<std::string>();
  if (kind == "warm") return std::make_shared<Planner>(warm_planner(state[1].cast<Path>()));
  if (kind == "named") {
    return std::make_shared<Planner>(planner_named(state[1].cast<std::string>()));
  }
  std::shared_ptr<Planner> planner = make_planner(
      state[1].cast<std::string>(), state[2].cast<py::function>(), state[3].cast<std::string>(),
      py::dict(), state[5].cast<std::vector<std::string>>(), state[6].cast<bool>(),
      state[7].cast<bool>());
  for (const py::handle item : state[4]) {
    const auto option = py::reinterpret_borrow<py::tuple>(item);
    const auto name = option[0].cast<std::string>();
    planner->options.push_back({.name = name,
                                .summary = name,
                                .default_value = value_from(option[1], name),
                                .least = option[2].cast<double>(),
                                .most = option[3].cast<double>(),
                                .words = option[4].cast<std::vector<std::string>>()});
  }
  return planner;
}

}  // namespace

std::shared_ptr<const py::function> kept(const py::function& function) {
  return {new py::function(function), [](const py::function* last) {
            const py::gil_scoped_acquire lock;
            delete last;
          }};
}

PlannerFunction planner_function(const py::function& function) {
  return PythonFunction{kept(function)};
}

std::shared_ptr<const Planner> own_planner(const py::function& function) {
  const std::string name = py::str(py::getattr(function, "__name__", py::str("own")));
  return make_planner(name, function, "a function of Python", {}, {}, false, true);
}

void bind_own_planner(py::module_& module) {
  bind_task(module);
  py::class_<Planner, std::shared_ptr<Planner>>(
      module, "Planner",
      R"(Planner(name, function, *, summary="", options={}, capabilities=(), anytime=False,
    deterministic=True, honours_prices=False, honours_gears=False)

A planner for `plan` and `compare` that calls a Python function.

- `function`: takes a `Task` and returns a path, or another value that `Task` describes. The judge
  checks every path.
- `options`: options of the planner. Each name has a default, (default, least, most), or (default,
  [word, ...]).
- `capabilities`: names of what the planner can do. Other options are refused. With "prices" it
  minimises the cost; otherwise the cost is the length. With "gears" it accepts `gears`: the pieces
  of its task use the allowed gears only, and so must its path. With "steering" it accepts
  `steering`, which the pieces of its task follow. With "target_gap" its answers have lower bounds.
- `anytime`, `deterministic`: properties that `properties` reports.
- `honours_prices`, `honours_gears`: old names of the capabilities "prices" and "gears".)")
      .def(py::init(&planner_from_keywords), "name"_a, "function"_a, py::kw_only(),
           "summary"_a = "", "options"_a = py::dict(),
           "capabilities"_a = std::vector<std::string>(), "anytime"_a = false,
           "deterministic"_a = true, "honours_prices"_a = false, "honours_gears"_a = false)
      .def_readonly("name", &Planner::name, "Name by which the planner is chosen.")
      .def_readonly("summary", &Planner::summary, "Description in one line.")
      .def_property_readonly(
          "options", &options_of,
          "The planner's own options by name: dicts of default, range and summary.")
      .def_property_readonly("properties", &properties_of,
                             "Properties of the planner: what it can do, and whether it is anytime "
                             "or deterministic.")
      .def("__repr__",
           [](const Planner& self) {
             return fmt::format("<vandplan.Planner {}: {}>", self.name, self.summary);
           })
      .def(py::pickle(&planner_state, &planner_of));
  module.def(
      "warm_started", [](const py::object& path) { return warm_planner(path_from(path)); },
      "path"_a,
      R"(warm_started(path) -> Planner

The default planner with a warm start.

`path` is a `Path`, `SpeedProfile` or `Result` of a similar problem, whose start, goal or obstacles
differ slightly. If a path along it is free, it is the first path found, and is improved before
other ways are searched. Ignored with a trailer or among moving obstacles.)");
  module.def(
      "planners",
      [] {
        std::vector<std::shared_ptr<Planner>> all;
        for (const Planner& planner : planners()) all.push_back(std::make_shared<Planner>(planner));
        return all;
      },
      "planners() -> list of Planner\n\nAll planners of the library, the default one first.");
  module.def("_common_options", &said_of_common_options);
  bind_path_source(module);
}

}  // namespace vandplan::python
