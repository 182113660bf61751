// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Scenarios as bytes.

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/scenario.h"

namespace vandplan::python {

/// State for pickle: the text of the scenario's file without masks, its map and its masks.
py::tuple state_of_scenario(const CheckedScenario& self) {
  ScenarioFile file = self.file();
  std::vector<py::tuple> masks;
  for (const Mask& mask : file.scenario.masks) masks.push_back(state_of_mask(mask));
  file.scenario.masks.clear();
  return py::make_tuple(to_yaml(file), self.scenario().map, masks);
}

CheckedScenario scenario_from_state(const py::tuple& state) {
  ScenarioFile file = scenario_from_yaml(state[0].cast<std::string>(), "pickle",
                                         state[1].cast<std::optional<OccupancyGrid>>());
  if (state.size() > 2) {
    for (const auto& mask : state[2].cast<std::vector<py::tuple>>()) {
      file.scenario.masks.push_back(mask_from_state(mask));
    }
  }
  return CheckedScenario(std::move(file.scenario), std::move(file.options));
}

}  // namespace vandplan::python
