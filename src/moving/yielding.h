// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// When may the vehicle be where on a path, if others move?
//
// Method, and what it does not find: docs/algorithms/moving.md.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "vandplan/moving.h"

namespace vandplan::moving {

/// Who yields to whom.
struct Traffic {
  std::span<const MovingObstacle> moving;  ///< in the frame of the path
  double margin = 0.0;                     ///< that the vehicle keeps from them [m]
  double start_curvature = 0.0;            ///< that the wheels are turned to before the drive [1/m]
  double start_hitch_angle = 0.0;          ///< before the drive [rad]; 0 without a trailer
  /// With which the vehicle comes to the start, in the gear of the first segment; above 0 it has no
  /// limit of jerk [m/s].
  double start_speed = 0.0;
  /// Only drives that are not longer are of interest [s].
  double longest = std::numeric_limits<double>::infinity();
  /// That the search looks at before it gives up, and boxes that are proven free for it.
  std::int64_t most_states = 200'000;
  /// The first drive that comes along will do: the search is greedy, and looks at places and times
  /// coarsely. It finds less, in a fraction of the time.
  bool is_hasty = false;
  std::function<bool()> is_interrupted = {};  ///< asked now and then; true: it gives up
};

/// What came of it.
struct Yielding {
  std::optional<SpeedProfile> speeds = {};  ///< none: none was found, which proves nothing
  /// States that the search looked at, and boxes that were proven free or occupied for it.
  std::int64_t states = 0;
  /// Whether `most_states` or an interruption ended the search: with more states it may find more.
  bool is_cut_off = false;
  /// Who is met first on the fastest drive; none: nobody, or there is no drive.
  std::optional<Meeting> met = {};
};

/// A drive along the path that keeps the limits of the vehicle and meets nothing, then or later: as
/// fast as the search finds one, the fastest one of all where nothing is in its way.
[[nodiscard]] Yielding yielding_speeds(const Path& path, const Vehicle& vehicle,
                                       const Traffic& traffic);

}  // namespace vandplan::moving
