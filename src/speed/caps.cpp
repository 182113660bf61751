// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "speed/caps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vandplan::speed {
namespace {

// Largest relative gap in speed^2 between a limit and the tangents below it.
constexpr double tolerance = 1e-3;
constexpr int deepest = 24;  // largest number of nested divisions of a part

/// Tangent of a limit: squared speed and its slope over the distance.
struct Tangent {
  double s;  // distance from the start of the segment [m]
  double value;
  double slope;

  [[nodiscard]] double at(double place) const { return value + slope * (place - s); }
};

/// Limits of the squared speed on one segment.
class SegmentLimits {
 public:
  SegmentLimits(const Segment& segment, const Vehicle& vehicle)
      : segment_(segment), wheelbase_(vehicle.wheelbase), limits_(vehicle.limits) {
    const double speed =
        segment.length < 0.0 ? limits_.max_speed.reverse : limits_.max_speed.forward;
    top_ = speed * speed;
    // The wheels turn by wheelbase * rate / (1 + (wheelbase * curvature)^2) per driven metre.
    straight_ = limits_.max_steering_rate / (wheelbase_ * std::abs(segment.curvature_rate));
  }

  /// Tangent of the limit `bound` at `s` metres of the segment.
  [[nodiscard]] Tangent tangent(SpeedBound bound, double s) const {
    const double curvature = curvature_at(segment_, s);
    const double rate = segment_.curvature_rate;
    if (bound == SpeedBound::lateral_acceleration) {
      const double value = limits_.max_lateral_acceleration / std::abs(curvature);
      return {s, value, -value / curvature * rate};
    }
    if (bound == SpeedBound::steering_rate) {
      const double bend = 1 + wheelbase_ * curvature * wheelbase_ * curvature;
      const double speed = straight_ * bend;
      return {s, speed * speed, 4 * straight_ * speed * wheelbase_ * wheelbase_ * curvature * rate};
    }
    return {s, top_, 0.0};
  }

  /// Lowest limit at `s` metres of the segment.
  [[nodiscard]] SpeedBound bound_at(double s) const {
    const double curvature = std::abs(curvature_at(segment_, s));
    double lowest = top_;
    SpeedBound bound = SpeedBound::max_speed;
    if (lowest * curvature > limits_.max_lateral_acceleration) {
      lowest = limits_.max_lateral_acceleration / curvature;
      bound = SpeedBound::lateral_acceleration;
    }
    if (segment_.curvature_rate == 0.0) return bound;
    if (tangent(SpeedBound::steering_rate, s).value < lowest) bound = SpeedBound::steering_rate;
    return bound;
  }

  /// Non-negative curvatures at which another limit may become the lowest one [1/m].
  [[nodiscard]] std::array<double, 4> turning_points() const {
    const double lateral = limits_.max_lateral_acceleration / top_;
    const double speed = std::sqrt(top_);
    const double steering = std::sqrt(std::max(speed / straight_ - 1, 0.0)) / wheelbase_;
    return {0.0, lateral, steering, equal_limits()};
  }

 private:
  /// Curvature at which the limits of lateral acceleration and steering rate are equal [1/m].
  [[nodiscard]] double equal_limits() const {
    const double top = limits_.max_lateral_acceleration / (straight_ * straight_);
    // curvature * (1 + (wheelbase * curvature)^2)^2 = top, and the left side grows.
    double low = 0.0;
    double high = std::min(top, std::cbrt(top / (wheelbase_ * wheelbase_)));
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      const double bend = 1 + wheelbase_ * middle * wheelbase_ * middle;
      (middle * bend * bend < top ? low : high) = middle;
    }
    return high;
  }

  Segment segment_;
  double wheelbase_;
  DrivingLimits limits_;
  double top_;       // square of the gear's largest speed [m^2/s^2]
  double straight_;  // speed at which the wheels turn as fast as they can, at curvature 0 [m/s]
};

/// Builds the caps of one segment.
class Builder {
 public:
  Builder(const SegmentLimits& limits, const DrivingLimits& driving, double s,
          std::vector<Cap>& caps)
      : limits_(limits),
        steepest_rise_(2 * driving.max_acceleration),
        steepest_fall_(-2 * driving.max_braking.value_or(driving.max_acceleration)),
        s_(s),
        caps_(caps) {}

  /// Adds the caps of a part on which one limit is the lowest; that limit is convex there.
  void add_part(double begin, double end) {
    bound_ = limits_.bound_at((begin + end) / 2);
    const Tangent first = limits_.tangent(bound_, begin);
    const Tangent last = limits_.tangent(bound_, end);
    from_ = begin;
    value_ = first.value;
    if (bound_ != SpeedBound::max_speed) add_tangents(first, last, 0);
    add_line_to(end, last.value);
  }

 private:
  /// Adds a cap from the end of the last one to (`end`, `value`).
  void add_line_to(double end, double value) {
    const Cap line{s_ + from_, s_ + end, value_, value, bound_};
    if (line.begin < line.end) caps_.push_back(line);
    from_ = end;
    value_ = value;
  }

  /// Adds all but the last of the lines below a convex limit. The lines are its tangents at `a` and
  /// `b`, and more tangents between them where the gap is too large.
  void add_tangents(const Tangent& a, const Tangent& b, int depth) {
    const double gain = b.slope - a.slope;
    double meet = (a.s + b.s) / 2;
    if (gain != 0.0) {
      meet = std::clamp(a.s + (a.value - b.at(a.s)) / gain, a.s, b.s);
    }
    const double low = std::min(a.at(meet), b.at(meet));
    const Tangent between = limits_.tangent(bound_, meet);
    const bool is_close = between.value - low <= tolerance * between.value;
    // Where the limit changes faster than the vehicle can, only its lower end matters.
    const bool is_steep = a.slope >= steepest_rise_ || b.slope <= steepest_fall_;
    const bool is_inside = a.s < meet && meet < b.s;
    if (is_close || is_steep || !is_inside || depth == deepest) {
      add_line_to(meet, low);
    } else {
      add_tangents(a, between, depth + 1);
      add_tangents(between, b, depth + 1);
    }
  }

  const SegmentLimits& limits_;
  double steepest_rise_;
  double steepest_fall_;
  double s_;
  std::vector<Cap>& caps_;
  SpeedBound bound_ = SpeedBound::max_speed;
  double from_ = 0.0;   // begin of the next line, from the start of the segment [m]
  double value_ = 0.0;  // speed^2 at the begin of the next line [m^2/s^2]
};

/// The part of a cap between two places of it.
Cap part_of(const Cap& cap, double begin, double end) {
  const auto at = [&](double s) {
    return s == cap.begin ? cap.first
           : s == cap.end ? cap.last
                          : cap.first + (s - cap.begin) * cap.slope();
  };
  return {begin, end, at(begin), at(end), cap.bound};
}

/// Appends a cap, lowered to `top` [m^2/s^2].
void add_lowered(const Cap& cap, double top, std::vector<Cap>& caps) {
  const Cap flat{cap.begin, cap.end, top, top, SpeedBound::max_speed};
  if (cap.first >= top && cap.last >= top) {
    caps.push_back(flat);
    return;
  }
  if (cap.first <= top && cap.last <= top) {
    caps.push_back(cap);
    return;
  }
  const double cut = std::clamp(cap.begin + (top - cap.first) / cap.slope(), cap.begin, cap.end);
  for (const auto& [begin, end] : {std::pair{cap.begin, cut}, std::pair{cut, cap.end}}) {
    if (!(begin < end)) continue;
    Cap part = part_of(cap, begin, end);
    if (std::max(part.first, part.last) > top * (1 + 1e-12)) {
      part = {begin, end, top, top, SpeedBound::max_speed};
    }
    part.first = std::min(part.first, top);
    part.last = std::min(part.last, top);
    caps.push_back(part);
  }
}

}  // namespace

void keep_limits(std::span<const SpeedLimit> limits, double origin, std::size_t first,
                 std::vector<Cap>& caps) {
  std::vector<Cap> given;
  for (const auto& [from, to, max_speed] : limits) {
    const double begin = from - origin, end = to - origin;
    given.assign(caps.begin() + static_cast<std::ptrdiff_t>(first), caps.end());
    caps.resize(first);
    for (const Cap& cap : given) {
      const double enters = std::clamp(begin, cap.begin, cap.end);
      const double leaves = std::clamp(end, enters, cap.end);
      if (cap.begin < enters) caps.push_back(part_of(cap, cap.begin, enters));
      if (enters < leaves) add_lowered(part_of(cap, enters, leaves), max_speed * max_speed, caps);
      if (leaves < cap.end) caps.push_back(part_of(cap, leaves, cap.end));
    }
  }
}

void add_caps(const Segment& segment, double s, const Vehicle& vehicle, std::vector<Cap>& caps) {
  const double length = std::abs(segment.length);
  const SegmentLimits limits(segment, vehicle);
  if (segment.curvature_rate == 0.0) {
    const SpeedBound bound = limits.bound_at(0.0);
    const double value = limits.tangent(bound, 0.0).value;
    caps.push_back({s, s + length, value, value, bound});
    return;
  }
  // 1. Places where another limit may become the lowest, or the curvature changes its sign.
  std::array<double, 10> places = {0.0, length};
  std::size_t count = 2;
  for (const double curvature : limits.turning_points()) {
    for (const double sign : {-1.0, 1.0}) {
      const double place = (sign * curvature - segment.curvature) / segment.curvature_rate;
      if (place > 0.0 && place < length) places[count++] = place;
    }
  }
  std::sort(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count));
  // 2. Lines below the lowest limit between these places.
  Builder builder(limits, vehicle.limits, s, caps);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    if (places[i] < places[i + 1]) builder.add_part(places[i], places[i + 1]);
  }
}

}  // namespace vandplan::speed
