// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Where there are no vectors of double: no length is known, and who asks takes the exact function.

#include <algorithm>
#include <limits>

#include "simd/pair_kernels.h"

namespace vandplan::simd {

void exact_lengths(std::span<const double> /*from*/, std::span<const double> /*to*/,
                   double /*radius*/, std::span<double> out) noexcept {
  std::ranges::fill(out, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace vandplan::simd
