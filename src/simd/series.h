// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do the scalar kernels evaluate a polynomial? The vector ones do the same in lanes.

#include <cstddef>

namespace vandplan::simd {

/// Rounding error of pi in float: pi - float(pi).
inline constexpr float rest_of_pi = -8.742278e-8F;

/// The polynomial series[0] x^(n-1) + ... + series[n-1].
template <std::size_t n>
constexpr float horner(const float (&series)[n], float x) noexcept {
  float sum = series[0];
  for (std::size_t i = 1; i < n; ++i) sum = series[i] + x * sum;
  return sum;
}

}  // namespace vandplan::simd
