// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which pose and speed does a vehicle have at a time of its drive?

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/trigonometry.h"
#include "speed/driven.h"
#include "speed/way.h"
#include "vandplan/input_error.h"
#include "vandplan/motion.h"

namespace vandplan {
namespace {

using speed::Way;

constexpr double most_samples = 1e7;  // largest number of samples of a drive

/// The last stop that has begun at `t`; null if there is none.
const Stop* stop_at(const SpeedProfile& profile, double t) {
  const auto later = std::ranges::upper_bound(profile.stops, t, {}, &Stop::t);
  return later == profile.stops.begin() ? nullptr : &*std::prev(later);
}

/// Motion of a vehicle that stands at `stop` at time `t`, while its wheels turn.
Motion standing(const Way& way, const Vehicle& vehicle, const Stop& stop, double t) {
  const double before = steering_angle(vehicle, stop.curvature_before);
  const double after = steering_angle(vehicle, stop.curvature_after);
  const double share = stop.pause > 0.0 ? std::min((t - stop.t) / stop.pause, 1.0) : 1.0;
  const PathPoint place = way.at(stop.s, true);
  Motion motion{.t = t, .s = stop.s, .pose = place.pose, .gear = place.gear};
  motion.steering_angle = share < 1.0 ? before + share * (after - before) : after;
  const auto [sin, cos] = base::sin_cos(motion.steering_angle);
  motion.curvature = share < 1.0 ? sin / cos / vehicle.wheelbase : stop.curvature_after;
  return motion;
}

/// Part of a drive with constant acceleration or jerk: from a knot to `end` [m].
struct DrivePart {
  const SpeedKnot& knot;
  double end;
};

/// Part of the drive at time `t`, which must lie within the drive [s].
DrivePart part_at(const SpeedProfile& profile, double t) {
  const auto later = std::ranges::upper_bound(profile.knots, t, {}, &SpeedKnot::t);
  const SpeedKnot& knot = *std::prev(later);
  return {knot, later == profile.knots.end() ? knot.s : later->s};
}

double place_on(const DrivePart& part, double t) {
  const SpeedKnot& knot = part.knot;
  const double d = t - knot.t;
  return std::min(knot.s + d * (knot.v + d * (knot.a / 2 + d * knot.jerk / 6)), part.end);
}

Motion motion_on(const Way& way, const Vehicle& vehicle, const SpeedProfile& profile, double t) {
  t = std::clamp(t, 0.0, profile.duration);
  const Stop* const stop = stop_at(profile, t);
  if (stop != nullptr && t < stop->t + stop->pause) return standing(way, vehicle, *stop, t);
  const DrivePart part = part_at(profile, t);
  const SpeedKnot& knot = part.knot;
  const double d = t - knot.t;
  const double s = place_on(part, t);
  const double v = std::max(knot.v + d * (knot.a + d * knot.jerk / 2), 0.0);
  const double a = knot.a + d * knot.jerk;
  // Where two segments meet at a stop, the earlier one counts until the stop has begun.
  const PathPoint place = way.at(s, s < part.end);
  const int direction = direction_of(place.gear);
  return {.t = t,
          .s = s,
          .pose = place.pose,
          .curvature = place.curvature,
          .steering_angle = steering_angle(vehicle, place.curvature),
          .gear = place.gear,
          .v = direction * v + 0.0,  // adding 0 avoids -0
          .a = direction * a + 0.0};
}

void check_profile(const SpeedProfile& profile) {
  if (!profile.knots.empty()) return;
  throw InputError("profile", "has no knots, expected the speeds along the path");
}

}  // namespace

double speed::driven_at(const SpeedProfile& profile, double t) noexcept {
  t = std::clamp(t, 0.0, profile.duration);
  return place_on(part_at(profile, t), t);
}

Motion motion_at(const Path& path, const Vehicle& vehicle, const SpeedProfile& profile, double t) {
  check_profile(profile);
  if (std::isnan(t)) throw InputError("t", "is no number, expected a time [s]");
  return motion_on(Way(path), vehicle, profile, t);
}

std::vector<Motion> sampled(const Path& path, const Vehicle& vehicle, const SpeedProfile& profile,
                            double step) {
  check_profile(profile);
  if (!(step >= profile.duration / most_samples && step > 0.0)) {
    throw InputError("step",
                     "is " + base::shortest_text(step) +
                         " s, expected more than 0, and 10^7 of them for the drive at most");
  }
  const Way way(path);
  // 1. Times of start, goal and pauses, and a grid without points next to them.
  std::vector<double> times = {0.0, profile.duration};
  for (const Stop& stop : profile.stops) {
    times.push_back(stop.t);
    times.push_back(stop.t + stop.pause);
  }
  std::ranges::sort(times);
  const auto marked = static_cast<std::ptrdiff_t>(times.size());
  auto next = times.begin();
  std::vector<double> grid;
  const double near = step / 1000;
  for (double i = 1.0; i * step < profile.duration; ++i) {
    const double t = i * step;
    next = std::lower_bound(next, times.end(), t - near);
    if (*next > t + near) grid.push_back(t);
  }
  times.insert(times.end(), grid.begin(), grid.end());
  std::inplace_merge(times.begin(), times.begin() + marked, times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  // 2. The motion at these times.
  std::vector<Motion> motions;
  motions.reserve(times.size());
  for (const double t : times) motions.push_back(motion_on(way, vehicle, profile, t));
  return motions;
}

}  // namespace vandplan
