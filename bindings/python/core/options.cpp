// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "bindings/python/core/options.h"

#include <pybind11/stl.h>

#include <algorithm>

#include "bindings/python/core/own_planner.h"
#include "vandplan/input_error.h"

namespace vandplan::python {

namespace py = pybind11;

std::shared_ptr<const Planner> planner_from(const py::handle& given) {
  if (py::isinstance<py::str>(given)) {
    return std::make_shared<const Planner>(planner_named(given.cast<std::string>()));
  }
  if (py::isinstance<Planner>(given)) {
    return std::const_pointer_cast<const Planner>(given.cast<std::shared_ptr<Planner>>());
  }
  if (PyCallable_Check(given.ptr()) != 0) {
    return own_planner(py::reinterpret_borrow<py::function>(given));
  }
  throw InputError("planner", "expected a name, a Planner, or a function of a task");
}

std::string typed(const py::handle& value) {
  const std::string text = py::str(value);
  if (text == "True" || text == "False") return text == "True" ? "true" : "false";
  return text;
}

std::vector<Setting> settings_from(const py::dict& given) {
  std::vector<Setting> settings;
  for (const auto& [name, value] : given) {
    if (!value.is_none()) settings.push_back({py::str(name), typed(value)});
  }
  return settings;
}

void set_keywords(PlanOptions& options, const Planner& planner, const RunKeywords& keywords) {
  std::vector<Setting> typed = settings_from(keywords.options);
  std::stable_sort(typed.begin(), typed.end(), [](const Setting& a, const Setting& b) {
    return setting_order(a.name) < setting_order(b.name);
  });
  for (const auto& [name, value] : typed) set_option(options, planner, name, value);
  if (keywords.time_limit) options.budget.time_limit = keywords.time_limit;
  if (keywords.max_iterations) options.budget.max_iterations = keywords.max_iterations;
  options.budget.seed = keywords.seed;
  if (keywords.site) options.site = std::make_shared<const SiteTable>(*keywords.site);
}

PlanOptions options_for(const Planner& planner, std::span<const Setting> wanted,
                        const RunKeywords& keywords, const Vehicle& vehicle) {
  PlanOptions options;
  set_honoured(options, planner, wanted);
  set_keywords(options, planner, keywords);
  return complete(planner, options, vehicle);
}

py::object object_of(const OptionValue& value) {
  return std::visit([](const auto& v) -> py::object { return py::cast(v); }, value);
}

namespace {

/// Python value of a common option's JSON: a number, a word or None.
py::object object_of_json(const std::string& json) {
  if (json == "null") return py::none();
  if (json == "true" || json == "false") return py::bool_(json == "true");
  if (json.starts_with('"')) return py::str(json.substr(1, json.size() - 2));
  if (json.find_first_of(".eE") == std::string::npos) return py::int_(py::str(json));
  return py::float_(py::str(json));
}

}  // namespace

py::dict said_of_common_options() {
  py::dict said;
  const auto ask = [&](std::string_view name, std::string_view summary, const auto& set) {
    try {
      set("?");
    } catch (const InputError& error) {
      said[py::str(name)] = py::make_tuple(summary, error.problem());
    }
  };
  for (const CommonOption& common : common_options()) {
    ask(common.name, common.summary, [&](std::string_view value) {
      PlanOptions any;
      common.set(any, value);
    });
  }
  ask("style", "prices and steering that hold where none is set", style_named);
  return said;
}

py::dict dict_of(const Planner& planner, const PlanOptions& options) {
  py::dict all;
  for (const CommonOption& common : common_options()) {
    if (!honours(planner, common.name)) continue;
    all[py::str(common.name)] = object_of_json(common.get(options));
  }
  for (const auto& [name, value] : options.planner.values()) all[name.c_str()] = object_of(value);
  return all;
}

}  // namespace vandplan::python
