// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do random cases draw, beyond what the library does?

#include <cmath>

#include "random.h"

namespace vandplan {

inline bool chance(double probability, Rng& rng) { return uniform01(rng) < probability; }

/// Between the bounds, every power of ten as likely as the next.
inline double any_size(double low, double high, Rng& rng) {
  return low * std::pow(high / low, uniform01(rng));
}

inline double any_sign(double value, Rng& rng) { return chance(0.5, rng) ? value : -value; }

}  // namespace vandplan
