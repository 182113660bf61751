// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Where and when does a drive first meet a moving obstacle?

#include <algorithm>
#include <string>

#include "base/require.h"
#include "moving/encounters.h"
#include "path/finite.h"
#include "speed/driven.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using moving::Encounters;

/// A drive and one moving obstacle.
struct Approach {
  const Encounters& encounters;
  const SpeedProfile& speeds;
  std::size_t obstacle;

  [[nodiscard]] double place(double t) const { return speed::driven_at(speeds, t); }

  /// Measure of both motions: no point of vehicle or obstacle moves further than it grows [m].
  [[nodiscard]] double moved(double t) const {
    return encounters.driven(place(t)) + encounters.moved(obstacle, t);
  }

  /// Time of the first meeting from `begin` to `end` [s]; none if there is none. `moved_begin` and
  /// `moved_end` are the values of `moved` there.
  [[nodiscard]] std::optional<double> first(double begin, double moved_begin, double end,
                                            double moved_end) const {
    const double middle = begin + (end - begin) / 2;
    const double moved_middle = moved(middle);
    const double most = std::max(moved_middle - moved_begin, moved_end - moved_middle);
    const double gap = encounters.gap(obstacle, encounters.state_at(place(middle)), middle,
                                      std::max(most, meeting_tolerance) * (1.0 + 1e-9));
    if (gap > most) return std::nullopt;
    const bool is_split = begin < middle && middle < end;
    if (most <= meeting_tolerance / 2 || !is_split) return begin;
    const auto earlier = first(begin, moved_begin, middle, moved_middle);
    return earlier ? earlier : first(middle, moved_middle, end, moved_end);
  }
};

}  // namespace

std::optional<Meeting> moving::first_meeting(const Course& course, const SpeedProfile& speeds,
                                             std::span<const MovingObstacle> moving,
                                             double margin) {
  const Encounters encounters(course, moving, margin);
  double end = std::max(speeds.duration, end_of_motion(moving));
  std::optional<Meeting> meeting;
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const Approach approach{encounters, speeds, i};
    const double last = std::min(end, encounters.leaves(i).value_or(end));
    if (last < 0.0) continue;
    const auto t = approach.first(0.0, approach.moved(0.0), last, approach.moved(last));
    if (!t || (meeting && *t >= meeting->t)) continue;
    const double s = approach.place(*t);
    meeting = {*t, s, encounters.state_at(s).pose, i};
    end = *t;
  }
  return meeting;
}

std::optional<Meeting> first_meeting(const TimedPath& drive, const Vehicle& vehicle,
                                     std::span<const MovingObstacle> moving, double margin) {
  path::check_finite(drive.path);
  if (drive.speeds.knots.empty()) throw InputError("drive.speeds", "has no knots, expected speeds");
  base::require(margin >= 0.0, "margin", margin, "a number >= 0 [m]");
  for (std::size_t i = 0; i < moving.size(); ++i) {
    if (moving[i].outline.size() >= 3 && !moving[i].trajectory.empty()) continue;
    throw InputError("moving[" + std::to_string(i) + "]",
                     "lacks corners or a trajectory, expected three corners and a row at least");
  }
  return moving::first_meeting({drive.path, vehicle}, drive.speeds, moving, margin);
}

}  // namespace vandplan
