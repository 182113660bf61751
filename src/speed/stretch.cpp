// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "speed/stretch.h"

#include <algorithm>
#include <cmath>

namespace vandplan::speed {
namespace {

/// Lowers caps, met in the order in which they are added, so that speed^2 rises by no more than
/// `rise` for each metre, from 0 on.
class RisePass {
 public:
  RisePass(double rise, SpeedBound bound, std::vector<Cap>& lowered)
      : rise_(rise), bound_(bound), lowered_(lowered) {}

  void add(const Cap& cap) {
    value_ = std::min(value_, cap.first);
    const double slope = cap.slope();
    const double gap = cap.first - value_;
    const double length = cap.end - cap.begin;
    // How far it takes to reach the cap.
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
  double value_ = 0.0;
};

/// The caps as they are met on the way back, places counted backwards.
void turn_round(std::vector<Cap>& caps) {
  std::ranges::reverse(caps);
  for (Cap& cap : caps) {
    cap = {-cap.end, -cap.begin, cap.last, cap.first, cap.bound};
  }
}

}  // namespace

double drive_stretch(std::vector<Cap>& caps, const DrivingLimits& limits,
                     std::vector<SpeedKnot>& knots) {
  const double braking = limits.max_braking.value_or(limits.max_acceleration);
  // 1. Forward: no faster than it can have become since the last stop.
  std::vector<Cap> risen;
  risen.reserve(2 * caps.size());
  RisePass forward(2 * limits.max_acceleration, SpeedBound::acceleration, risen);
  for (const Cap& cap : caps) forward.add(cap);
  // 2. Backward: no faster than it can still brake.
  turn_round(risen);
  caps.clear();
  RisePass backward(2 * braking, SpeedBound::braking, caps);
  for (const Cap& cap : risen) backward.add(cap);
  turn_round(caps);
  // 3. Times: exact under constant acceleration.
  double t = 0.0;
  for (const Cap& cap : caps) {
    const double v = std::sqrt(cap.first);
    const double next = std::sqrt(cap.last);
    const double duration = 2 * (cap.end - cap.begin) / (v + next);
    const double a = std::clamp((next - v) / duration, -braking, limits.max_acceleration);
    knots.push_back({.t = t, .s = cap.begin, .v = v, .a = a, .jerk = 0.0, .bound = cap.bound});
    t += duration;
  }
  return t;
}

}  // namespace vandplan::speed
