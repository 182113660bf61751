// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for messages of ROS 2: the names that our plugins use.

#include <cstdint>
#include <string>
#include <vector>

namespace rcl_interfaces::msg {
struct FloatingPointRange {
  double from_value = 0.0;
  double to_value = 0.0;
  double step = 0.0;
};
struct IntegerRange {
  std::int64_t from_value = 0;
  std::int64_t to_value = 0;
  std::uint64_t step = 0;
};
struct ParameterDescriptor {
  std::string description;
  std::vector<FloatingPointRange> floating_point_range;
  std::vector<IntegerRange> integer_range;
};
}  // namespace rcl_interfaces::msg
