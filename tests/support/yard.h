// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is the least scenario file, and how is it spoiled?

#include <stdexcept>
#include <string>

namespace vandplan {

/// A wall stands between start and goal; solved in a few iterations.
inline std::string yard() {
  return "name: yard\n"
         "vehicle: {wheelbase: 4.5, front_overhang: 1.4, rear_overhang: 1.6, width: 2.55, "
         "min_turning_radius: 7.0}\n"
         "bounds: {x: [-50, 50], y: [-50, 50]}\n"
         "start: {x: 0, y: 0, heading: 0}\n"
         "goal: {x: 20, y: 5, heading: 0}\n"
         "obstacles:\n"
         "  - [[12, -9], [13, -9], [13, 9], [12, 9]]\n";
}

/// The text with the first `from` turned into `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  if (place == std::string::npos) throw std::logic_error("there is no \"" + from + "\"");
  return text.replace(place, from.size(), to);
}

}  // namespace vandplan
