// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which map is in a file of ROS' map_server, and which of its settings look wrong?

#include <cstdint>
#include <string>
#include <vector>

#include "io/document.h"
#include "vandplan/geometry.h"

namespace vandplan::io {

/// Result of `read_map`; adds warnings "file:line: key: what". `percents`, if given, becomes the
/// occupancy of each cell as nav2_map_server publishes it; `Mask::unknown` for unknown cells.
[[nodiscard]] OccupancyGrid map_from(const std::string& name, std::vector<std::string>& warnings,
                                     std::vector<std::uint8_t>* percents = nullptr);

/// Map that a node of a scenario names; the name is relative to the scenario's file `where`.
[[nodiscard]] OccupancyGrid map_named(const Document& file, const Node& node,
                                      const std::string& where, std::vector<std::string>& warnings,
                                      std::vector<std::uint8_t>* percents = nullptr);

}  // namespace vandplan::io
