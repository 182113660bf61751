// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The kernel of a build without vectors of double: it does nothing, and its caller works out one
// word after the other.

#include "simd/circle_kernels.h"

namespace vandplan::simd {

bool circle_words(std::array<CircleWords, circle_formulas>& /*words*/,
                  const std::array<CircleFormula, circle_formulas>& /*formulas*/,
                  const CircleTurns& /*turns*/) noexcept {
  return false;
}

}  // namespace vandplan::simd
