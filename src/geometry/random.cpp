// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/random.h"

#include <numbers>

namespace vandplan {

Pose uniform_pose(const Bounds& box, Rng& rng) {
  const double x = uniform(box.x_min, box.x_max, rng);
  const double y = uniform(box.y_min, box.y_max, rng);
  return {x, y, uniform(-std::numbers::pi, std::numbers::pi, rng)};
}

std::uint64_t stream_seed(std::uint64_t seed, std::uint64_t stream) {
  std::uint64_t z = seed + (stream + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

}  // namespace vandplan
