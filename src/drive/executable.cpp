// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/trigonometry.h"
#include "drive/plant.h"
#include "drive/watch.h"
#include "vandplan/drive.h"
#include "vandplan/input_error.h"
#include "vandplan/motion.h"

namespace vandplan {
namespace {

using namespace driving;

constexpr double period = 1e-3;  // time between two samples of the drive [s]
constexpr double most_moments = 1e6;
constexpr double relaxed = 1 + 1e-3;  // factor of the vehicle's limits, for rounding
// Largest distance between the driven and the planned end [m].
constexpr double end_tolerance = 0.01;
// Largest error of the heading at the end [rad].
constexpr double end_turn_tolerance = std::numbers::pi / 180;

template <class... Values>
std::string text(const char* format, Values... values) {
  std::array<char, 160> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, values...);
  return buffer.data();
}

/// Stops at which the curvature jumps and the gear stays.
std::vector<Stop> jumps_of(const std::vector<Motion>& motions, const SpeedProfile& profile) {
  std::vector<Stop> jumps;
  for (const Stop& stop : profile.stops) {
    if (stop.s == 0.0) continue;
    const auto after = std::ranges::upper_bound(motions, stop.s, {}, &Motion::s);
    const auto begin = std::ranges::lower_bound(motions, stop.s, {}, &Motion::s);
    if (begin == motions.begin() || after == motions.end()) continue;
    if (std::prev(begin)->gear == after->gear) jumps.push_back(stop);
  }
  return jumps;
}

/// Text about the first curvature that the vehicle cannot drive; empty if there is none.
std::string too_sharp(const Path& path, const Vehicle& vehicle) {
  for (const Segment& segment : path.segments) {
    for (const double driven : {0.0, std::abs(segment.length)}) {
      const double curvature = curvature_at(segment, driven);
      if (std::abs(curvature) <= relaxed / vehicle.min_turning_radius) continue;
      return text("curvature %.6g is tighter than the turning radius of %.6g m allows", curvature,
                  vehicle.min_turning_radius);
    }
  }
  return {};
}

/// Simulates a drive through its samples. The pauses `left_out` are skipped.
Execution executed(const Problem& problem, const Path& path, const std::vector<Motion>& motions,
                   const std::vector<Stop>& left_out) {
  const Vehicle& vehicle = problem.vehicle();
  const double rate = relaxed * vehicle.limits.max_steering_rate;
  Watch watch(problem);
  Execution result{.passes = true, .reason = too_sharp(path, vehicle)};
  State state{to_local(*problem.world(), path.start), problem.hitch_angles().start};
  State wanted = state;  // planned state at the end
  for (const Segment& segment : path.segments) wanted = advance(vehicle, wanted, segment);
  const auto look = [&](const Segment& arc, const State& to) {
    const auto what = watch.look(state, arc, to);
    if (what && result.reason.empty()) {
      result.reason = text("after %.2f s %s", result.duration, what->c_str());
    }
  };
  look({}, state);
  double wheels = steering_angle(vehicle, problem.curvatures().start);
  auto gap = left_out.begin();
  for (std::size_t i = 0; i + 1 < motions.size(); ++i) {
    const Motion& now = motions[i];
    const Motion& next = motions[i + 1];
    while (gap != left_out.end() && now.t >= gap->t + gap->pause) ++gap;
    if (gap != left_out.end() && now.t >= gap->t) continue;
    const double most = rate * (next.t - now.t);
    const double turned = std::clamp(next.steering_angle - wheels, -most, most);
    const auto [sin, cos] = base::sin_cos(wheels + turned / 2);
    const double way = next.s - now.s;
    const Segment arc{sin / cos / vehicle.wheelbase,
                      way > 0.0 ? direction_of(now.gear) * way : 0.0};
    const State to = advance(vehicle, state, arc);
    result.duration += next.t - now.t;
    wheels += turned;
    if (way > 0.0) look(arc, to);
    state = to;
  }
  const Pose end = relative(wanted.pose, state.pose);
  result.end_distance = std::sqrt(end.x * end.x + end.y * end.y);
  result.end_heading = std::abs(end.heading);
  const auto expect_end = [&](const char* what, double distance, double turn) {
    if (!result.reason.empty()) return;
    if (distance <= end_tolerance && turn <= end_turn_tolerance) return;
    result.reason =
        text("%sends %.3g m and %.3g degrees away", what, distance, turn * 180 / std::numbers::pi);
  };
  expect_end("", result.end_distance, result.end_heading);
  if (vehicle.trailer) {
    const Pose behind = relative(trailer_pose(vehicle, wanted), trailer_pose(vehicle, state));
    expect_end("the trailer ", std::sqrt(behind.x * behind.x + behind.y * behind.y),
               std::abs(behind.heading));
  }
  result.passes = result.reason.empty();
  return result;
}

}  // namespace

ExecutableCheck executable(const Problem& problem, const Path& path) {
  if (problem.world() == nullptr) {
    throw InputError("problem", "is empty, expected one that make_problem returned");
  }
  const Vehicle& vehicle = problem.vehicle();
  const SpeedProfile profile = speed_profile(path, vehicle, speed_options(problem, path));
  // Longer drives have longer steps, to limit the memory.
  const double step = std::max(period, profile.duration / most_moments);
  const std::vector<Motion> motions = sampled(path, vehicle, profile, step);
  const std::vector<Stop> jumps = jumps_of(motions, profile);
  ExecutableCheck check;
  check.jumps = static_cast<int>(jumps.size());
  check.pausing = executed(problem, path, motions, {});
  check.flowing = jumps.empty() ? check.pausing : executed(problem, path, motions, jumps);
  return check;
}

}  // namespace vandplan
