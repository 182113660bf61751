// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/exponential.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vandplan::base {

double exponential(double x) noexcept {
  if (!(std::abs(x) <= 700.0)) {
    if (std::isnan(x)) return x;
    return x < 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  }
  // x = n log 2 + r with |r| <= log 2 / 2; the high part of log 2 has 21 zero bits at its end, so
  // that its product with n is exact (Cody & Waite 1980).
  constexpr double per_doubling = 1.4426950408889634;
  constexpr double log2_high = 0x1.62e42feep-1;
  constexpr double log2_low = 0x1.a39ef35793c76p-33;
  constexpr double round = 0x1.8p52;
  const double n = (x * per_doubling + round) - round;
  const double high = x - n * log2_high;
  const double low = n * log2_low;
  const double r = high - low;
  // What the last subtraction lost: it counts to first order.
  const double rest = (high - r) - low;
  // Taylor's series; the first term left out is below 5e-18. Pairs of terms depend on each other
  // less than single terms would.
  constexpr std::array<double, 12> c = {1.0 / 2,        1.0 / 6,         1.0 / 24,
                                        1.0 / 120,      1.0 / 720,       1.0 / 5040,
                                        1.0 / 40320,    1.0 / 362880,    1.0 / 3628800,
                                        1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800.0};
  const double r2 = r * r;
  const double r4 = r2 * r2;
  const double low_terms = (c[0] + r * c[1]) + r2 * (c[2] + r * c[3]);
  const double middle_terms = (c[4] + r * c[5]) + r2 * (c[6] + r * c[7]);
  const double high_terms = (c[8] + r * c[9]) + r2 * (c[10] + r * c[11]);
  const double sum = low_terms + r4 * (middle_terms + r4 * high_terms);
  const double power = 1.0 + (r + (r2 * sum + rest));
  const auto exponent = static_cast<std::int64_t>(n);
  return power * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

}  // namespace vandplan::base
