// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The kernels of a build without vectors of double. All lengths are NaN, so that the caller
// computes them one by one.

#include <algorithm>
#include <limits>

#include "base/trigonometry.h"
#include "simd/pair_kernels.h"
#include "simd/turn_kernels.h"

namespace vandplan::simd {

void exact_lengths(std::span<const double> /*from*/, std::span<const double> /*to*/,
                   double /*radius*/, std::span<double> out) noexcept {
  std::ranges::fill(out, std::numeric_limits<double>::quiet_NaN());
}

void sines_and_cosines(std::span<const double> angles, std::span<double> sines,
                       std::span<double> cosines) noexcept {
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto [sin, cos] = base::sin_cos(angles[i]);
    sines[i] = sin;
    cosines[i] = cos;
  }
}

}  // namespace vandplan::simd
