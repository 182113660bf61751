// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does a drive keep every limit, and how long does the fastest one take?
//
// Both look at every millimetre or finer, and take nothing from the library but the path: what a
// limit means is written here once more.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "vandplan/motion.h"

namespace vandplan {

/// A segment with where it lies on its path.
struct Placed {
  Segment segment;
  double begin;  // [m]
  double end;    // [m]

  [[nodiscard]] double curvature(double s) const {
    return segment.curvature + segment.curvature_rate * (s - begin);
  }
};

inline std::vector<Placed> placed(const Path& path) {
  std::vector<Placed> result;
  double s = 0;
  for (const Segment& segment : path.segments) {
    if (segment.length == 0) continue;
    result.push_back({segment, s, s + std::abs(segment.length)});
    s += std::abs(segment.length);
  }
  return result;
}

/// The largest speed at a place of a segment, whatever happens elsewhere [m/s].
inline double largest_speed(const Placed& p, double s, const Vehicle& vehicle) {
  const DrivingLimits& limits = vehicle.limits;
  const double curvature = p.curvature(s);
  double v = p.segment.length < 0 ? limits.max_speed.reverse : limits.max_speed.forward;
  v = std::min(v, std::sqrt(limits.max_lateral_acceleration / std::abs(curvature)));
  // The angle of the wheels is atan(wheelbase * curvature).
  const double bend = vehicle.wheelbase * curvature;
  const double turn = vehicle.wheelbase * std::abs(p.segment.curvature_rate) / (1 + bend * bend);
  return std::min(v, limits.max_steering_rate / turn);
}

/// By how much the wheels turn between two curvatures [rad].
inline double turn_between(double a, double b, const Vehicle& vehicle) {
  return std::abs(std::atan(vehicle.wheelbase * a) - std::atan(vehicle.wheelbase * b));
}

/// Whether the vehicle has to stand between two segments.
inline bool must_stand(const Placed& before, const Placed& next, const Vehicle& vehicle) {
  if ((before.segment.length < 0) != (next.segment.length < 0)) return true;
  const double turn = turn_between(before.curvature(before.end), next.segment.curvature, vehicle);
  return turn > ignored_steering_jump;
}

/// How long the fastest drive takes without a limit of jerk [s]: looked at every millimetre and in
/// a thousand places of every segment, with an even acceleration in between.
inline double dense_duration(const Path& path, const Vehicle& vehicle, double start_curvature = 0) {
  constexpr double pi = std::numbers::pi;
  const DrivingLimits& limits = vehicle.limits;
  std::vector<double> s;
  std::vector<double> square;  // of the speed
  double standing = 0;
  const std::vector<Placed> all = placed(path);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Placed& p = all[i];
    const double before = i == 0 ? start_curvature : all[i - 1].curvature(p.begin);
    const bool stands = i == 0 || must_stand(all[i - 1], p, vehicle);
    if (stands) {
      const double turn = turn_between(before, p.segment.curvature, vehicle);
      if (i > 0 || turn > ignored_steering_jump) standing += turn / limits.max_steering_rate;
    }
    // Denser near the ends, where the vehicle may come to its speed within a hair's breadth.
    const double steps = std::max(1000.0, std::ceil((p.end - p.begin) / 1e-3 * pi / 2));
    for (double k = 0; k <= steps; ++k) {
      s.push_back(p.begin + (p.end - p.begin) * (1 - std::cos(pi * k / steps)) / 2);
      const double v = largest_speed(p, s.back(), vehicle);
      square.push_back(k == 0 && stands ? 0 : v * v);
    }
  }
  if (s.empty()) return 0;
  square.back() = 0;
  for (std::size_t i = 1; i < s.size(); ++i) {
    const double gain = 2 * limits.max_acceleration * (s[i] - s[i - 1]);
    square[i] = std::min(square[i], square[i - 1] + gain);
  }
  const double braking = limits.max_braking.value_or(limits.max_acceleration);
  for (std::size_t i = s.size() - 1; i > 0; --i) {
    square[i - 1] = std::min(square[i - 1], square[i] + 2 * braking * (s[i] - s[i - 1]));
  }
  double t = standing;
  for (std::size_t i = 1; i < s.size(); ++i) {
    if (s[i] == s[i - 1]) continue;
    t += 2 * (s[i] - s[i - 1]) / (std::sqrt(square[i]) + std::sqrt(square[i - 1]));
  }
  return t;
}

/// What is wrong with a drive, looked at every millimetre and in twenty places between knots; empty
/// if nothing is.
class DenseCheck {
 public:
  DenseCheck(const Path& path, const Vehicle& vehicle, const SpeedProfile& profile)
      : segments_(placed(path)), vehicle_(vehicle), profile_(profile) {}

  [[nodiscard]] std::string fault() {
    for (std::size_t i = 0; i + 1 < profile_.knots.size() && fault_.empty(); ++i) {
      look_at(profile_.knots[i], profile_.knots[i + 1]);
    }
    const SpeedKnot& last = profile_.knots.back();
    expect(last.v == 0 && last.t == profile_.duration, "does not end", last.s);
    const double length = segments_.empty() ? 0 : segments_.back().end;
    expect_near(last.s, length, 1e-9 * (1 + length), "ends elsewhere", last.s);
    look_at_stops();
    return fault_;
  }

 private:
  void expect(bool holds, const char* what, double s) {
    if (holds || !fault_.empty()) return;
    fault_ = std::string(what) + " at s = " + std::to_string(s);
  }
  void expect_near(double a, double b, double tolerance, const char* what, double s) {
    expect(std::abs(a - b) <= tolerance, what, s);
  }
  void expect_within(double value, double limit, const char* what, double s) {
    expect(value <= limit * (1 + 1e-9), what, s);
  }

  /// The largest speed at a place; where two segments meet, which rounding moves, the larger one.
  double largest_at(double s) {
    constexpr double rounding = 1e-9;
    while (at_ + 1 < segments_.size() && s > segments_[at_].end) ++at_;
    while (at_ > 0 && s < segments_[at_].begin) --at_;
    double largest = largest_speed(segments_[at_], s, vehicle_);
    if (at_ > 0 && s <= segments_[at_].begin + rounding) {
      largest = std::max(largest, largest_speed(segments_[at_ - 1], s, vehicle_));
    }
    if (at_ + 1 < segments_.size() && s >= segments_[at_].end - rounding) {
      largest = std::max(largest, largest_speed(segments_[at_ + 1], s, vehicle_));
    }
    return largest;
  }

  void look_at(const SpeedKnot& knot, const SpeedKnot& next) {
    const DrivingLimits& limits = vehicle_.limits;
    const double duration = next.t - knot.t;
    expect(duration >= 0, "time runs back", knot.s);
    const double places = std::max(20.0, std::ceil((next.s - knot.s) / 1e-3));
    for (double k = 0; k <= places; ++k) {
      const double t = duration * (k / places);
      const double a = knot.a + knot.jerk * t;
      const double v = knot.v + t * (knot.a + t * knot.jerk / 2);
      const double s = knot.s + t * (knot.v + t * (knot.a / 2 + t * knot.jerk / 6));
      expect_within(a, limits.max_acceleration, "gains speed too fast", s);
      expect_within(-a, limits.max_braking.value_or(limits.max_acceleration), "brakes hard", s);
      expect(v >= -1e-9, "goes back", s);
      if (v > 0) expect_within(v, largest_at(s), "is too fast", s);
    }
    if (limits.max_jerk) expect_within(std::abs(knot.jerk), *limits.max_jerk, "jerks", knot.s);
    expect_near(knot.v + duration * (knot.a + duration * knot.jerk / 2), next.v,
                1e-9 * (1 + next.v), "its speed jumps", next.s);
    expect_near(knot.s + duration * (knot.v + duration * (knot.a / 2 + duration * knot.jerk / 6)),
                next.s, 1e-9 * (1 + next.s), "its place jumps", next.s);
    if (limits.max_jerk) {
      expect_near(knot.a + duration * knot.jerk, next.a, 1e-6 * limits.max_acceleration,
                  "its acceleration jumps", next.s);
    }
  }

  /// It stands for long enough wherever it has to.
  void look_at_stops() {
    for (std::size_t i = 1; i < segments_.size(); ++i) {
      if (!must_stand(segments_[i - 1], segments_[i], vehicle_)) continue;
      const double s = segments_[i].begin;
      const auto stop = std::ranges::find_if(profile_.stops, [&](const Stop& known) {
        return std::abs(known.s - s) <= 1e-9 * (1 + s);
      });
      expect(stop != profile_.stops.end(), "does not stand", s);
      if (stop == profile_.stops.end()) return;
      const double turn =
          turn_between(segments_[i - 1].curvature(s), segments_[i].segment.curvature, vehicle_);
      expect_near(stop->pause, turn / vehicle_.limits.max_steering_rate, 1e-9 * (1 + stop->pause),
                  "stands for too long or short", s);
      for (const SpeedKnot& knot : profile_.knots) {
        if (knot.t >= stop->t && knot.t <= stop->t + stop->pause) {
          expect(knot.s == stop->s && knot.v == 0, "moves while it stands", s);
        }
      }
    }
  }

  std::vector<Placed> segments_;
  const Vehicle& vehicle_;
  const SpeedProfile& profile_;
  std::size_t at_ = 0;
  std::string fault_;
};

inline std::string fault_of(const Path& path, const Vehicle& vehicle, const SpeedProfile& profile) {
  return DenseCheck(path, vehicle, profile).fault();
}

}  // namespace vandplan
