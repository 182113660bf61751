// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which map is in a file of ROS' map_server, and which of its settings look wrong?

#include <string>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::io {

/// Result of `read_map`; adds warnings "file:line: key: what".
[[nodiscard]] OccupancyGrid map_from(const std::string& name, std::vector<std::string>& warnings);

}  // namespace vandplan::io
