// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/checks.h"

#include <cmath>
#include <numbers>

#include "base/require.h"
#include "vandplan/input_error.h"

namespace vandplan::replanning {
namespace {

constexpr double most_speed = 1000.0;  // largest speed that is accepted as a measurement [m/s]

}  // namespace

void check_options(const ReplanOptions& options) {
  base::require(options.tick_iterations >= 0, "tick_iterations",
                static_cast<double>(options.tick_iterations), "0 or more");
  base::require(options.tick_states >= 1, "tick_states", static_cast<double>(options.tick_states),
                "1 or more");
  base::require(options.committed >= 0.0 && options.committed <= 60.0, "committed",
                options.committed, "0 to 60 s");
  base::require(options.better >= 0.0 && options.better <= 1.0, "better", options.better, "0 to 1");
  base::require(options.reserve >= 0.01 && options.reserve <= 0.5, "reserve", options.reserve,
                "0.01 to 0.5");
  if (options.plan.site) {
    throw InputError("site",
                     "is a table that no patch changes, expected a ChangingSiteTable in "
                     "ReplanOptions::site");
  }
}

void check_vehicle_of(const Scenario& scenario) {
  if (scenario.vehicle.limits.max_jerk) {
    throw InputError("vehicle.max_jerk", "is not honoured while planning anew, expected none");
  }
}

void check_state(const VehicleState& state, const Problem& problem) {
  try {
    check_poses(state.pose, problem.goal());
  } catch (const InputError& error) {
    throw InputError("state.pose", error.what());
  }
  base::require(std::abs(state.v) <= most_speed, "state.v", state.v, "-1000 to 1000 m/s");
  base::require(std::isfinite(state.curvature), "state.curvature", state.curvature,
                "a number [1/m]");
  const double angle = state.hitch_angle.value_or(0.0);
  base::require(std::abs(angle) <= std::numbers::pi, "state.hitch_angle", angle, "-pi to pi");
  base::require(angle == 0.0 || problem.vehicle().trailer, "state.hitch_angle", angle,
                "0 without a trailer");
}

void check_limit(const TickLimit& limit) {
  if (!limit.time_limit) return;
  base::require(*limit.time_limit >= 0.0, "time_limit", *limit.time_limit, "0 s or more");
}

}  // namespace vandplan::replanning
