// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do all random numbers come from?
//
// The sequence of std::mt19937_64 is fixed by the standard, that of its distributions is not: the
// few we need are ours, so that a seed means the same everywhere.

#include <cstdint>
#include <random>

#include "vandplan/geometry.h"

namespace vandplan {

/// The one generator of random numbers. Its seed comes from the options of a run.
using Rng = std::mt19937_64;

/// A number in [0, 1), 53 random bits.
[[nodiscard]] inline double uniform01(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1.0p-53;
}

/// A number in [low, high).
[[nodiscard]] inline double uniform(double low, double high, Rng& rng) {
  return low + (high - low) * uniform01(rng);
}

/// A pose whose position is uniform in the box and whose heading is uniform in [-pi, pi).
[[nodiscard]] Pose uniform_pose(const Bounds& box, Rng& rng);
[[nodiscard]] inline LocalPose uniform_pose(const Local<Bounds>& box, Rng& rng) {
  return Local(uniform_pose(static_cast<const Bounds&>(box), rng));
}

/// A seed for an independent stream: the `stream`-th one of `seed` (splitmix64, Steele 2014).
[[nodiscard]] std::uint64_t stream_seed(std::uint64_t seed, std::uint64_t stream);

}  // namespace vandplan
