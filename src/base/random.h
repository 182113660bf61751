// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do all random numbers come from?
//
// The sequence of std::mt19937_64 is fixed by the standard, that of its distributions is not: the
// few we need are ours, so that a seed means the same everywhere.

#include <cstdint>
#include <random>

namespace vandplan::base {

/// A stream of random bits.
using Rng = std::mt19937_64;

/// A random number in [0, 1), of 53 random bits.
inline double uniform01(Rng& rng) { return static_cast<double>(rng() >> 11) * 0x1.0p-53; }

/// A random number in [low, high).
inline double uniform(double low, double high, Rng& rng) {
  return low + (high - low) * uniform01(rng);
}

/// A seed for an independent stream: the `stream`-th one of `seed` (splitmix64, Steele 2014).
std::uint64_t stream_seed(std::uint64_t seed, std::uint64_t stream);

}  // namespace vandplan::base
