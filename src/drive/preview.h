// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which steering is optimal if the curvature of the path ahead is known?

#include <array>
#include <cstddef>

namespace vandplan::driving {

/// Distance between two previewed curvatures, in units of the fading distance.
inline constexpr double preview_step = 0.1;
inline constexpr std::size_t preview_steps = 30;

/// Gains of the optimal change of curvature per driven distance: -lateral * e - heading * h -
/// curvature * k + sum of ahead[i] * k_i. Here e is the lateral error, h the heading error, and k
/// the curvature of the vehicle. The path has curvature k_i from step i to i + 1. All quantities
/// are in units of the fading distance.
struct PreviewGains {
  double lateral = 0.0;
  double heading = 0.0;
  double curvature = 0.0;
  std::array<double, preview_steps> ahead = {};
};

/// The gains, which the first call computes.
[[nodiscard]] const PreviewGains& preview_gains() noexcept;

}  // namespace vandplan::driving
