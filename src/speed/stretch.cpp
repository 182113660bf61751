// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "speed/stretch.h"

#include <algorithm>
#include <cmath>

namespace vandplan::speed {
namespace {

/// Lowers caps so that speed^2 rises by at most `rise` per metre, beginning with `first`. Caps are
/// added in the order of the drive.
class RisePass {
 public:
  RisePass(double rise, SpeedBound bound, double first, std::vector<Cap>& lowered)
      : rise_(rise), bound_(bound), lowered_(lowered), value_(first) {}

  void add(const Cap& cap) {
    value_ = std::min(value_, cap.first);
    const double slope = cap.slope();
    const double gap = cap.first - value_;
    const double length = cap.end - cap.begin;
    // Distance after which the rising line reaches the cap [m].
    const double reach = slope < rise_ ? gap / (rise_ - slope) : length;
    if (!(reach < length)) {
      push(cap.begin, cap.end, std::min(value_ + rise_ * length, cap.last), bound_);
      return;
    }
    const double meet = cap.begin + reach;
    if (cap.begin < meet && meet < cap.end) {
      push(cap.begin, meet, std::max(value_, cap.first + slope * reach), bound_);
      push(meet, cap.end, cap.last, cap.bound);
    } else if (meet < cap.end) {
      push(cap.begin, cap.end, cap.last, cap.bound);
    } else {
      push(cap.begin, cap.end, cap.last, bound_);
    }
  }

 private:
  void push(double begin, double end, double last, SpeedBound bound) {
    lowered_.push_back({begin, end, value_, last, bound});
    value_ = last;
  }

  double rise_;
  SpeedBound bound_;
  std::vector<Cap>& lowered_;
  double value_;
};

/// Reverses caps: their order, and the signs of their places.
void turn_round(std::vector<Cap>& caps) {
  std::ranges::reverse(caps);
  for (Cap& cap : caps) {
    cap = {-cap.end, -cap.begin, cap.last, cap.first, cap.bound};
  }
}

/// Lowers caps to the largest squared speeds that acceleration and braking allow, from `first` at
/// the begin to 0 at the end [m^2/s^2].
void lower(std::vector<Cap>& caps, double first, const DrivingLimits& limits) {
  const double braking = limits.max_braking.value_or(limits.max_acceleration);
  // 1. Forward: the speed is limited by acceleration since the last stop.
  std::vector<Cap> risen;
  risen.reserve(2 * caps.size());
  RisePass forward(2 * limits.max_acceleration, SpeedBound::acceleration, first, risen);
  for (const Cap& cap : caps) forward.add(cap);
  // 2. Backward: the speed is limited by braking before the next stop.
  turn_round(risen);
  caps.clear();
  RisePass backward(2 * braking, SpeedBound::braking, 0.0, caps);
  for (const Cap& cap : risen) backward.add(cap);
  turn_round(caps);
}

/// Raises caps to the squared speed of braking: it begins with `square` and falls by `fall` per
/// metre. Returns whether it comes down to the caps.
bool brake_down(double square, double fall, std::vector<Cap>& caps) {
  const double begin = caps.front().begin;
  const auto line = [&](double s) { return square - fall * (s - begin); };
  for (std::size_t i = 0; i < caps.size(); ++i) {
    Cap& cap = caps[i];
    const double above = line(cap.begin) - cap.first;
    if (above <= 0.0) return true;
    const double above_end = line(cap.end) - cap.last;
    if (above_end <= 0.0) {
      const double meet = cap.begin + (cap.end - cap.begin) * (above / (above - above_end));
      Cap rest = cap;
      cap = {cap.begin, meet, line(cap.begin), line(meet), SpeedBound::braking};
      rest.begin = meet;
      rest.first = cap.last;
      if (meet >= rest.end) return true;
      if (cap.end <= cap.begin) {
        cap = rest;
      } else {
        caps.insert(caps.begin() + static_cast<std::ptrdiff_t>(i) + 1, rest);
      }
      return true;
    }
    cap = {cap.begin, cap.end, line(cap.begin), line(cap.end), SpeedBound::braking};
  }
  return false;
}

/// Appends a knot for each cap and returns the duration [s]; exact under constant acceleration.
double timed(const std::vector<Cap>& caps, double hardest, const DrivingLimits& limits,
             std::vector<SpeedKnot>& knots) {
  double t = 0.0;
  for (const Cap& cap : caps) {
    const double v = std::sqrt(cap.first);
    const double next = std::sqrt(cap.last);
    const double duration = 2 * (cap.end - cap.begin) / (v + next);
    const double a = std::clamp((next - v) / duration, -hardest, limits.max_acceleration);
    knots.push_back({.t = t, .s = cap.begin, .v = v, .a = a, .jerk = 0.0, .bound = cap.bound});
    t += duration;
  }
  return t;
}

}  // namespace

double drive_stretch(std::vector<Cap>& caps, const DrivingLimits& limits,
                     std::vector<SpeedKnot>& knots) {
  lower(caps, 0.0, limits);
  return timed(caps, limits.max_braking.value_or(limits.max_acceleration), limits, knots);
}

std::optional<double> drive_stretch_from(double square, std::vector<Cap>& caps,
                                         const DrivingLimits& limits,
                                         std::vector<SpeedKnot>& knots) {
  // Slightly harder, so that a speed at the limit surely comes down.
  constexpr double harder = 1 + 1e-3;
  const double braking = harder * limits.max_braking.value_or(limits.max_acceleration);
  lower(caps, square, limits);
  if (!brake_down(square, 2 * braking, caps)) return std::nullopt;
  return timed(caps, braking, limits, knots);
}

}  // namespace vandplan::speed
