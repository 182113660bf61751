// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/timed_path.h"

#include <algorithm>
#include <cmath>

#include "search/route.h"
#include "vandplan/vehicle.h"

namespace vandplan::replanning {
namespace {

constexpr double least_time = 1e-9;  // least time between two knots [s]

/// Index of the last knot that is not later than `t`.
std::size_t knot_at(const SpeedProfile& speeds, double t) {
  const auto later = std::ranges::upper_bound(speeds.knots, t, {}, &SpeedKnot::t);
  const auto i = later - speeds.knots.begin();
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(i - 1, 0));
}

/// State of the motion `d` seconds after a knot.
SpeedKnot advanced(const SpeedKnot& knot, double d) {
  SpeedKnot now = knot;
  now.t += d;
  now.s += d * (knot.v + d * (knot.a / 2 + d * knot.jerk / 6));
  now.v = std::max(knot.v + d * (knot.a + d * knot.jerk / 2), 0.0);
  now.a += d * knot.jerk;
  return now;
}

}  // namespace

TimedPath standing_at(const Pose& pose) {
  TimedPath drive{{pose, {}}, {}};
  drive.speeds.knots.push_back({});
  return drive;
}

double hitch_angle_after(const Vehicle& vehicle, double angle, std::span<const Segment> segments) {
  if (!vehicle.trailer) return angle;
  for (const Segment& segment : segments) {
    angle = vandplan::hitch_angle_after(vehicle, angle, segment);
  }
  return angle;
}

CutDrive rest_of(const TimedPath& drive, const Vehicle& vehicle, double t, double hitch_angle) {
  const SpeedProfile& speeds = drive.speeds;
  t = std::clamp(t, 0.0, speeds.duration);
  CutDrive rest{{{}, {}}, {motion_at(drive.path, vehicle, speeds, t)}};
  const double s = rest.begin.s;
  rest.begin.hitch_angle =
      hitch_angle_after(vehicle, hitch_angle, search::part_of(drive.path.segments, 0.0, s));
  const double end = speeds.knots.back().s;
  rest.begin.t = 0.0;
  rest.begin.s = 0.0;
  rest.drive.path = {rest.begin.pose, search::part_of(drive.path.segments, s, end)};
  SpeedProfile& left = rest.drive.speeds;
  const std::size_t first = knot_at(speeds, t);
  SpeedKnot now = advanced(speeds.knots[first], t - speeds.knots[first].t);
  now.t = 0.0;
  now.s = 0.0;
  left.knots.push_back(now);
  for (std::size_t i = first + 1; i < speeds.knots.size(); ++i) {
    SpeedKnot knot = speeds.knots[i];
    knot.t -= t;
    knot.s = std::max(knot.s - s, 0.0);
    if (knot.t <= least_time) left.knots.clear();
    left.knots.push_back(knot);
  }
  left.knots.front().t = 0.0;
  left.knots.front().s = 0.0;
  left.duration = left.knots.back().t;
  for (Stop stop : speeds.stops) {
    if (stop.t + stop.pause < t || (stop.t < t && stop.pause == 0.0)) continue;
    if (stop.t < t) {
      stop.pause -= t - stop.t;
      stop.curvature_before = rest.begin.curvature;
      stop.t = t;
    }
    stop.t -= t;
    stop.s = std::max(stop.s - s, 0.0);
    left.standing += stop.pause;
    left.stops.push_back(stop);
  }
  return rest;
}

TimedPath before(const TimedPath& drive, const Vehicle& vehicle, double t) {
  const SpeedProfile& speeds = drive.speeds;
  t = std::clamp(t, 0.0, speeds.duration);
  const double s = motion_at(drive.path, vehicle, speeds, t).s;
  TimedPath first{{drive.path.start, search::part_of(drive.path.segments, 0.0, s)}, {}};
  const std::size_t last = knot_at(speeds, t);
  for (std::size_t i = 0; i <= last; ++i) {
    if (speeds.knots[i].t < t) first.speeds.knots.push_back(speeds.knots[i]);
  }
  SpeedKnot end = advanced(speeds.knots[last], t - speeds.knots[last].t);
  end.s = s;
  first.speeds.knots.push_back(end);
  first.speeds.duration = t;
  for (Stop stop : speeds.stops) {
    if (stop.t >= t) break;
    if (stop.t + stop.pause > t) {
      stop.curvature_after = motion_at(drive.path, vehicle, speeds, t).curvature;
      stop.pause = t - stop.t;
    }
    first.speeds.standing += stop.pause;
    first.speeds.stops.push_back(stop);
  }
  return first;
}

TimedPath joined(const TimedPath& first, const TimedPath& then) {
  TimedPath both = first;
  both.path.segments.insert(both.path.segments.end(), then.path.segments.begin(),
                            then.path.segments.end());
  SpeedProfile& speeds = both.speeds;
  const double t = speeds.duration;
  const double s = speeds.knots.back().s;
  speeds.knots.pop_back();
  for (SpeedKnot knot : then.speeds.knots) {
    knot.t += t;
    knot.s += s;
    speeds.knots.push_back(knot);
  }
  for (Stop stop : then.speeds.stops) {
    stop.t += t;
    stop.s += s;
    speeds.stops.push_back(stop);
  }
  speeds.duration += then.speeds.duration;
  speeds.standing += then.speeds.standing;
  return both;
}

}  // namespace vandplan::replanning
