// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does the library keep its promises in one world?

#include <cstdint>
#include <string>
#include <vector>

namespace vandplan::nasty {

/// What a trial brought.
struct Trial {
  std::vector<std::string> faults;  ///< a line for each broken promise
  bool refused = false;             ///< the world has a flaw, which was named
  int paths = 0;                    ///< that were judged
};

/// Plans in the world of that number with the default planner, on 1 and on 5 threads, and with two
/// others that the number chooses. Their paths are judged by a second judge, written, read and
/// judged again, bounds are held against the costs of all, and the checker against naive looks.
[[nodiscard]] Trial try_world(std::uint64_t seed);

/// The same, where the default planner has the time for all of its steps.
[[nodiscard]] Trial try_world_patiently(std::uint64_t seed);

/// The same as `try_world` with a trailer behind the vehicle, by planners that plan for rigs.
[[nodiscard]] Trial try_world_of_a_rig(std::uint64_t seed);

/// The same as `try_world` where the goal is a set of poses.
[[nodiscard]] Trial try_world_of_goals(std::uint64_t seed);

/// The same as `try_world` with zones and masks, whose prices are held against naive sums.
[[nodiscard]] Trial try_world_of_zones(std::uint64_t seed);

/// Plans among moving obstacles with the default planner, on 1 and on 5 threads. The times of its
/// drives are looked at by a second judge, too, and again when they were written and read.
[[nodiscard]] Trial try_world_of_movers(std::uint64_t seed);

/// The scenario of that world as a file (its map, if it has one, as MAP.yaml and MAP.pgm beside
/// it), for `vandplan plan`. Returns the file's name.
std::string save_world(std::uint64_t seed, const std::string& folder);

}  // namespace vandplan::nasty
