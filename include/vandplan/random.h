// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do all random numbers come from?
//
// The standard fixes the sequence of std::mt19937_64, but not those of its distributions. The few
// distributions that we need are ours, so that a seed means the same everywhere.

#include <cstdint>
#include <random>

#include "vandplan/geometry.h"

namespace vandplan {

/// The generator of all random numbers. Its seed comes from the options of a run.
using Rng = std::mt19937_64;

/// A random number in [0, 1), uniform, with 53 random bits.
[[nodiscard]] inline double uniform01(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1.0p-53;
}

/// A random number in [low, high), uniform.
[[nodiscard]] inline double uniform(double low, double high, Rng& rng) {
  return low + (high - low) * uniform01(rng);
}

/// A random pose in the frame of the box: its position is uniform in the box [m], its heading in
/// [-pi, pi).
[[nodiscard]] Pose uniform_pose(const Bounds& box, Rng& rng);
/// A random pose in a box of the world's frame, in that frame.
[[nodiscard]] inline LocalPose uniform_pose(const Local<Bounds>& box, Rng& rng) {
  return Local(uniform_pose(static_cast<const Bounds&>(box), rng));
}

/// Seed for the independent stream of random numbers that has the number `stream` among those of
/// `seed` (splitmix64, Steele 2014).
[[nodiscard]] std::uint64_t stream_seed(std::uint64_t seed, std::uint64_t stream);

}  // namespace vandplan
