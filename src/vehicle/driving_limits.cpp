// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/vehicle.h"

#include <string>

#include "base/text.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

/// Range of every limit, in the unit of the limit: far beyond vehicles at both ends, and such that
/// no time overflows.
constexpr double least = 1e-3;
constexpr double most = 1e3;

void require(double value, const char* key, const char* unit) {
  if (value >= least && value <= most) return;
  throw InputError(key, "is " + base::shortest_text(value) + ", expected " +
                            base::shortest_text(least) + " to " + base::shortest_text(most) + " " +
                            unit);
}

void require(const std::optional<double>& value, const char* key, const char* unit) {
  if (value) require(*value, key, unit);
}

}  // namespace

void check_limits(const DrivingLimits& limits) {
  require(limits.max_steering_rate, "max_steering_rate", "rad/s");
  require(limits.max_curvature_rate, "max_curvature_rate", "1/m^2");
  require(limits.max_speed.forward, "max_speed.forward", "m/s");
  require(limits.max_speed.reverse, "max_speed.reverse", "m/s");
  require(limits.max_acceleration, "max_acceleration", "m/s^2");
  require(limits.max_braking, "max_braking", "m/s^2");
  require(limits.max_lateral_acceleration, "max_lateral_acceleration", "m/s^2");
  require(limits.max_jerk, "max_jerk", "m/s^3");
}

}  // namespace vandplan
