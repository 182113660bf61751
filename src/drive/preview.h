// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a vehicle steer that sees how the path goes on?

#include <array>
#include <cstddef>

namespace vandplan::driving {

/// Between two curvatures that are looked at, in units of the fading distance.
inline constexpr double preview_step = 0.1;
inline constexpr std::size_t preview_steps = 30;

/// The optimal change of curvature per driven distance, of all quantities in units of the fading
/// distance: -lateral * e - heading * h - curvature * k + sum of ahead[i] * k_i, where the path has
/// the curvature k_i from step i to i + 1.
struct PreviewGains {
  double lateral = 0.0;
  double heading = 0.0;
  double curvature = 0.0;
  std::array<double, preview_steps> ahead = {};
};

/// Worked out at the first call.
[[nodiscard]] const PreviewGains& preview_gains() noexcept;

}  // namespace vandplan::driving
