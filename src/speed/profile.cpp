// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/require.h"
#include "path/finite.h"
#include "speed/caps.h"
#include "speed/moving_start.h"
#include "speed/stretch.h"
#include "vandplan/input_error.h"
#include "vandplan/motion.h"

namespace vandplan {
namespace {

using speed::Cap;

/// Segments in a row of less total length are passed over [m]: no vehicle drives them.
constexpr double least_motion = 1e-9;

bool is_stop(const SpeedLimit& limit) { return limit.max_speed == 0.0 && limit.begin == limit.end; }

/// Builds a drive stretch by stretch.
class Drive {
 public:
  Drive(const Vehicle& vehicle, const speed::MovingStart& start)
      : vehicle_(vehicle),
        limits_(start.limits),
        curvature_(start.curvature),
        speed_(start.speed) {}

  /// Adds a segment, at whose stops the vehicle stands.
  void add(const Segment& segment) {
    const double begin = s_;
    const double length = std::abs(segment.length);
    double done = 0.0;
    for (const SpeedLimit& limit : limits_) {
      const double until = limit.begin - begin;
      if (!is_stop(limit) || until < done + least_motion || until > length - least_motion) continue;
      add_part(part_of(segment, done, until));
      done = until;
    }
    add_part(done == 0.0 ? segment : part_of(segment, done, length));
  }

  /// The speed profile; none if the vehicle is too fast to stop where it has to.
  std::optional<SpeedProfile> finish() {
    finish_stretch();
    if (speed_ > 0.0 || is_too_fast_) return std::nullopt;
    profile_.knots.push_back({.t = t_, .s = s_});
    profile_.duration = t_;
    return std::move(profile_);
  }

 private:
  void add_part(const Segment& segment) {
    const double length = std::abs(segment.length);
    passed_over_ += length;
    if (passed_over_ < least_motion || !(s_ < s_ + length)) {
      since_stop_ += length;
      s_ += length;
      return;
    }
    passed_over_ = 0.0;
    const double sign = segment.length < 0.0 ? -1.0 : 1.0;
    const bool changes_gear = gear_ != 0.0 && sign != gear_;
    const bool jumps = turn_to(segment.curvature) > ignored_steering_jump;
    if (changes_gear || jumps || (gear_ != 0.0 && must_stand())) stop(segment.curvature);
    // Distances count from the last stop, so that short segments do not vanish after a long path.
    const std::size_t first = caps_.size();
    speed::add_caps(segment, since_stop_, vehicle_, caps_);
    speed::keep_limits(limits_, stop_, first, caps_);
    since_stop_ += length;
    s_ += length;
    gear_ = sign;
    curvature_ = curvature_at(segment, length);
  }

  /// Whether the vehicle stands at the place reached so far.
  [[nodiscard]] bool must_stand() const {
    return std::any_of(limits_.begin(), limits_.end(), [this](const SpeedLimit& limit) {
      return is_stop(limit) && std::abs(limit.begin - s_) < least_motion;
    });
  }

  /// Angle by which the wheels turn from the current curvature to `curvature` [rad].
  [[nodiscard]] double turn_to(double curvature) const {
    return std::abs(steering_angle(vehicle_, curvature) - steering_angle(vehicle_, curvature_));
  }

  /// Drives the stretch up to this place and stands until the wheels are turned.
  void stop(double curvature) {
    finish_stretch();
    if (speed_ > 0.0) is_too_fast_ = true;
    const double turn = turn_to(curvature);
    const double pause =
        turn > ignored_steering_jump ? turn / vehicle_.limits.max_steering_rate : 0.0;
    profile_.stops.push_back({t_, s_, pause, curvature_, curvature});
    if (pause > 0.0) profile_.knots.push_back({.t = t_, .s = s_});
    profile_.standing += pause;
    t_ += pause;
    curvature_ = curvature;
  }

  void finish_stretch() {
    if (caps_.empty()) return;
    std::vector<SpeedKnot>& knots = profile_.knots;
    const std::size_t first = knots.size();
    const DrivingLimits& limits = vehicle_.limits;
    double duration = 0.0;
    if (speed_ > 0.0) {
      const auto lasts = speed::drive_stretch_from(speed_ * speed_, caps_, limits, knots);
      is_too_fast_ = is_too_fast_ || !lasts;
      speed_ = 0.0;
      duration = lasts.value_or(0.0);
    } else {
      duration = limits.max_jerk ? speed::drive_stretch_smoothly(caps_, limits, knots)
                                 : speed::drive_stretch(caps_, limits, knots);
    }
    for (std::size_t i = first; i < knots.size(); ++i) {
      knots[i].t += t_;
      knots[i].s += stop_;
    }
    t_ += duration;
    stop_ = s_;
    since_stop_ = 0.0;
    caps_.clear();
  }

  const Vehicle& vehicle_;
  std::span<const SpeedLimit> limits_;
  SpeedProfile profile_;
  std::vector<Cap> caps_;     // caps of the stretch so far
  double curvature_;          // curvature to which the wheels are turned [1/m]
  double speed_;              // speed at the begin of the stretch [m/s]
  bool is_too_fast_ = false;  // whether the vehicle is too fast to stop where it has to
  double gear_ = 0.0;         // gear: 1 forward, -1 reverse, 0 before the first segment
  double s_ = 0.0;
  double t_ = 0.0;
  double stop_ = 0.0;         // begin of the stretch, from the start of the path [m]
  double since_stop_ = 0.0;   // length of the stretch so far [m]
  double passed_over_ = 0.0;  // length of the last segments that were passed over [m]
};

}  // namespace

std::string_view name_of(SpeedBound bound) noexcept {
  switch (bound) {
    case SpeedBound::max_speed:
      return "max_speed";
    case SpeedBound::lateral_acceleration:
      return "lateral_acceleration";
    case SpeedBound::steering_rate:
      return "steering_rate";
    case SpeedBound::acceleration:
      return "acceleration";
    case SpeedBound::braking:
      return "braking";
    case SpeedBound::jerk:
      return "jerk";
    case SpeedBound::standing:
      break;
  }
  return "standing";
}

SpeedProfile speed_profile(const Path& path, const Vehicle& vehicle, const SpeedOptions& options) {
  return *speed::profile_from(path, vehicle, {options.start_curvature, 0.0, options.limits});
}

std::optional<SpeedProfile> speed::profile_from(const Path& path, const Vehicle& vehicle,
                                                const MovingStart& start) {
  check_limits(vehicle.limits);
  base::require(vehicle.wheelbase > 0.0, "vehicle.wheelbase", vehicle.wheelbase, "more than 0 m");
  base::require(std::isfinite(start.curvature), "start_curvature", start.curvature,
                "a number [1/m]");
  for (const SpeedLimit& limit : start.limits) {
    base::require(limit.max_speed > 0.0 || is_stop(limit), "limits", limit.max_speed,
                  "more than 0 m/s, or 0 at one place");
  }
  vandplan::path::check_finite(path);
  Drive drive(vehicle, start);
  for (const Segment& segment : merged(path.segments)) drive.add(segment);
  return drive.finish();
}

}  // namespace vandplan
