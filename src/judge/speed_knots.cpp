// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/speed_knots.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "judge/text.h"

namespace vandplan::judge {
namespace {

constexpr Real jump_slack = 1e-6;  // jumps of the acceleration up to this are rounding [m/s^2]

bool is_finite(const SpeedKnot& knot) {
  return std::isfinite(knot.t) && std::isfinite(knot.s) && std::isfinite(knot.v) &&
         std::isfinite(knot.a) && std::isfinite(knot.jerk);
}

/// Index of the first stop with a number that is not finite.
std::optional<std::size_t> infinite_stop(const SpeedProfile& speeds) {
  for (std::size_t i = 0; i < speeds.stops.size(); ++i) {
    const auto& [t, s, pause, before, after] = speeds.stops[i];
    for (const double number : {t, s, pause, before, after}) {
      if (!std::isfinite(number)) return i;
    }
  }
  return std::nullopt;
}

DriveFault knot_fault(std::size_t i, const std::string& what) {
  return {"knots[" + std::to_string(i) + "] " + what, {}, {}};
}

}  // namespace

Reached after_knot(const SpeedKnot& knot, Real d) {
  return {knot.s + d * (knot.v + d * (knot.a / Real{2} + d * knot.jerk / 6)),
          knot.v + d * (knot.a + d * knot.jerk / 2), knot.a + d * knot.jerk};
}

std::optional<DriveFault> false_knots(const SpeedProfile& speeds, Real length, Real start_speed) {
  const std::vector<SpeedKnot>& knots = speeds.knots;
  if (knots.empty()) return DriveFault{"the drive has no knots", {}, {}};
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!is_finite(knots[i])) return knot_fault(i, "is not finite");
  }
  if (const auto i = infinite_stop(speeds)) {
    return DriveFault{"stops[" + std::to_string(*i) + "] is not finite", {}, {}};
  }
  if (!std::isfinite(speeds.duration) || !std::isfinite(speeds.standing)) {
    return DriveFault{"the stated duration or standing is not finite", {}, {}};
  }
  if (!std::isfinite(static_cast<double>(start_speed))) {
    return DriveFault{"the speed at the start is not finite", {}, {}};
  }
  const SpeedKnot& first = knots.front();
  const SpeedKnot& last = knots.back();
  if (first.t != 0 || std::abs(first.s) > distance_slack) {
    return DriveFault{"the drive does not begin at the start at 0 s", {}, {}};
  }
  if (start_speed == 0 && (first.v > speed_slack || last.v > speed_slack)) {
    return DriveFault{"the vehicle does not stand at both ends of the drive", {}, {}};
  }
  if (std::abs(first.v - start_speed) > speed_slack) {
    return DriveFault{text("the drive begins at %.6g m/s, the vehicle comes at %.6g m/s", first.v,
                           static_cast<double>(start_speed)),
                      {},
                      {}};
  }
  if (last.v > speed_slack) {
    return DriveFault{"the vehicle does not stand at the end of the drive", {}, {}};
  }
  if (std::abs(last.s - length) > distance_slack) {
    return DriveFault{text("the drive ends after %.9g m, the path is %.9g m long", last.s,
                           static_cast<double>(length)),
                      {},
                      {}};
  }
  if (std::abs(last.t - speeds.duration) > time_slack) {
    return DriveFault{
        text("the last knot is at %.9g s, the stated duration is %.9g s", last.t, speeds.duration),
        {},
        {}};
  }
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Real lasts = static_cast<Real>(knots[i + 1].t) - knots[i].t;
    if (lasts < 0) return knot_fault(i + 1, "is earlier than the one before");
    const Reached end = after_knot(knots[i], lasts);
    if (std::abs(end.s - knots[i + 1].s) > distance_slack ||
        std::abs(end.v - knots[i + 1].v) > speed_slack) {
      return knot_fault(i + 1, "does not follow from the one before");
    }
  }
  return std::nullopt;
}

std::optional<DriveFault> acceleration_jump(const SpeedProfile& speeds, double start_speed) {
  Real before = start_speed == 0.0 ? 0 : speeds.knots.front().a;
  for (std::size_t i = 0; i < speeds.knots.size(); ++i) {
    const SpeedKnot& knot = speeds.knots[i];
    const bool is_last = i + 1 == speeds.knots.size();
    const Real next = is_last ? 0 : static_cast<Real>(knot.a);
    if (std::abs(next - before) > jump_slack) {
      return DriveFault{text("the acceleration jumps from %.6g to %.6g, the jerk is limited",
                             static_cast<double>(before), static_cast<double>(next)),
                        knot.t,
                        {}};
    }
    if (!is_last) before = after_knot(knot, static_cast<Real>(speeds.knots[i + 1].t) - knot.t).a;
  }
  return std::nullopt;
}

}  // namespace vandplan::judge
