// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// With which speeds does a vehicle drive a path among moving obstacles?
//
// Method and limits of the search: docs/algorithms/moving.md.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/motion.h"

namespace vandplan::moving {

/// Moving obstacles, the state at the start of a drive, and limits of the search for its speeds.
struct Traffic {
  std::span<const MovingObstacle> moving;  ///< moving obstacles, in the frame of the path
  double margin = 0.0;  ///< distance that the vehicle keeps from moving obstacles [m]
  /// Curvature to which the wheels are turned before the drive [1/m].
  double start_curvature = 0.0;
  std::vector<SpeedLimit> limits = {};  ///< limits of places on the path
  double start_hitch_angle = 0.0;       ///< hitch angle before the drive [rad]; 0 without a trailer
  /// Speed at the start, in the gear of the first segment [m/s]. Above 0, `max_jerk` is ignored.
  double start_speed = 0.0;
  /// Longest duration of a drive to search for [s].
  double longest = std::numeric_limits<double>::infinity();
  /// Largest number of states that the search expands, and of boxes that it examines.
  std::int64_t most_states = 200'000;
  /// Whether the search is greedy, on a coarse grid of places and times. It finds fewer drives in a
  /// fraction of the time.
  bool is_hasty = false;
  std::function<bool()> is_interrupted = {};  ///< polled by the search; true ends it
};

/// Result of a search for speeds along a path.
struct Yielding {
  /// Speeds of the drive; none if the search failed, which proves nothing.
  std::optional<SpeedProfile> speeds = {};
  /// Number of expanded states plus examined boxes.
  std::int64_t states = 0;
  /// Whether `most_states` or an interruption ended the search, so a larger limit may find a drive.
  bool is_cut_off = false;
  /// First meeting on the fastest drive; none: it meets nobody, or there is no drive.
  std::optional<Meeting> met = {};
};

/// Searches speeds along a path that keep the limits of the vehicle and meet no moving obstacle,
/// during the drive and after it. If the fastest drive meets nobody, it is the result. Otherwise
/// the search is incomplete: it may miss faster drives, or all of them.
[[nodiscard]] Yielding yielding_speeds(const Path& path, const Vehicle& vehicle,
                                       const Traffic& traffic);

}  // namespace vandplan::moving
