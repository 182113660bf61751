// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/closer.h"

#include <algorithm>
#include <cmath>

#include "base/trigonometry.h"

namespace vandplan::rig {
namespace {

constexpr int most_iterations = 15;
constexpr double close_enough = 1e-10;  // [m, rad]
constexpr double difference = 1e-7;     // for derivatives [rad]

/// A vector turned by a quarter to the left: how a point moves when all turns about the origin.
Point turned(double x, double y) { return {-y, x}; }

double largest(const std::array<double, 4>& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2]), std::abs(v[3])});
}

}  // namespace

Closer::Closer(const Vehicle& vehicle)
    : vehicle_(vehicle),
      most_curvature_(1 / vehicle.min_turning_radius),
      curvature_unit_(0.3 * most_curvature_),
      length_unit_(0.3 * std::sqrt(vehicle.min_turning_radius * vehicle.trailer->wheelbase)) {}

void Closer::drive(const RigState& from, std::span<const Segment> segments) {
  states_.assign(1, from);
  for (const Segment& segment : segments) {
    const RigState& last = states_.back();
    states_.push_back(
        {advance(last.pose, segment), hitch_angle_after(vehicle_, last.hitch_angle, segment)});
  }
}

Closer::Vector Closer::gap(const RigState& to) const {
  const auto& [pose, angle] = states_.back();
  return {to.pose.x - pose.x, to.pose.y - pose.y, wrap_angle(to.pose.heading - pose.heading),
          to.hitch_angle - angle};
}

/// [1] The end turns with a segment about each of its points; the hitch angle goes its own way.
void Closer::differentiate(std::span<const Segment> segments) {
  columns_.assign(segments.size(), {});
  const Pose& end = states_.back().pose;
  double passed_on = 1.0;  // of a change of the hitch angle after the segment
  for (std::size_t i = segments.size(); i-- > 0;) {
    const double curvature = segments[i].curvature;
    const double length = segments[i].length;
    const Pose& first = states_[i].pose;
    const double angle = states_[i].hitch_angle;
    const auto& [last, angle_after] = states_[i + 1];
    const Pose middle = advance(first, {curvature, length / 2});
    const auto [sin, cos] = base::sin_cos(last.heading);
    const Point swing = turned(end.x - last.x, end.y - last.y);
    const Point bend = turned(end.x - (first.x + 4 * middle.x + last.x) / 6,
                              end.y - (first.y + 4 * middle.y + last.y) / 6);
    const double tick = difference * most_curvature_;
    const double bent = hitch_angle_after(vehicle_, angle, {curvature + tick, length});
    const double folded = hitch_angle_after(vehicle_, angle + difference, segments[i]);
    const double by_curvature = (bent - angle_after) / tick;
    const double by_angle = (folded - angle_after) / difference;
    const double by_length = hitch_rate(vehicle_, angle_after, curvature);
    columns_[i] = {
        {length * bend.x, length * bend.y, length, passed_on * by_curvature},
        {cos + curvature * swing.x, sin + curvature * swing.y, curvature, passed_on * by_length},
        false,
        false};
    passed_on *= by_angle;
  }
}

/// [2] Least squares of the changes: multipliers of the four conditions, by Cholesky's method.
bool Closer::solve(const Vector& gap, Vector& multipliers) const {
  std::array<Vector, 4> m{};
  const auto add = [&](const Vector& column, double unit) {
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c <= r; ++c) m[r][c] += unit * unit * column[r] * column[c];
    }
  };
  for (const Column& column : columns_) {
    if (!column.curvature_is_fixed) add(column.curvature, curvature_unit_);
    if (!column.length_is_fixed) add(column.length, length_unit_);
  }
  Vector y = gap;
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t c = 0; c <= r; ++c) {
      double sum = m[r][c];
      for (std::size_t k = 0; k < c; ++k) sum -= m[r][k] * m[c][k];
      if (r != c) {
        m[r][c] = sum / m[c][c];
        continue;
      }
      if (!(sum > 1e-18 * (1 + m[r][r]))) return false;
      m[r][r] = std::sqrt(sum);
    }
    for (std::size_t k = 0; k < r; ++k) y[r] -= m[r][k] * y[k];
    y[r] /= m[r][r];
  }
  for (std::size_t r = 4; r-- > 0;) {
    for (std::size_t k = r + 1; k < 4; ++k) y[r] -= m[k][r] * y[k];
    y[r] /= m[r][r];
  }
  multipliers = y;
  return true;
}

/// [3] Changes all segments at once; what would leave its limits is held there.
bool Closer::step(std::span<Segment> segments, const Vector& gap) {
  const auto dot = [](const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  };
  Vector multipliers{};
  for (int pass = 0; pass < 3; ++pass) {
    if (!solve(gap, multipliers)) return false;
    bool is_final = true;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      Column& column = columns_[i];
      const auto& [curvature, length, rate] = segments[i];
      const double bent = dot(column.curvature, multipliers);
      const bool is_sharp = std::abs(curvature) >= most_curvature_ && bent * curvature > 0.0;
      const bool is_gone = length == 0.0;
      is_final &= column.curvature_is_fixed || !(is_sharp || is_gone);
      is_final &= column.length_is_fixed || !is_gone;
      column.curvature_is_fixed |= is_sharp || is_gone;
      column.length_is_fixed |= is_gone;
    }
    if (is_final) break;
  }
  double most = 1.0;  // steps are cut to a few units
  for (const Column& column : columns_) {
    if (!column.curvature_is_fixed) {
      most = std::max(most, std::abs(dot(column.curvature, multipliers)) * curvature_unit_ / 2);
    }
    if (!column.length_is_fixed) {
      most = std::max(most, std::abs(dot(column.length, multipliers)) * length_unit_ / 2);
    }
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Column& column = columns_[i];
    auto& [curvature, length, rate] = segments[i];
    if (!column.curvature_is_fixed) {
      curvature += curvature_unit_ * curvature_unit_ * dot(column.curvature, multipliers) / most;
      curvature = std::clamp(curvature, -most_curvature_, most_curvature_);
    }
    if (!column.length_is_fixed) {
      const double longer =
          length + length_unit_ * length_unit_ * dot(column.length, multipliers) / most;
      length = longer * length > 0.0 ? longer : 0.0;  // the gear stays
    }
  }
  return true;
}

bool Closer::close(const RigState& from, std::span<Segment> segments, const RigState& to) {
  for (int i = 0; i < most_iterations; ++i) {
    drive(from, segments);
    const Vector open = gap(to);
    if (largest(open) <= close_enough) {
      return std::ranges::all_of(states_, [&](const RigState& state) {
        return std::abs(state.hitch_angle) <= vehicle_.max_hitch_angle;
      });
    }
    if (!(largest(open) < 1e3)) return false;
    differentiate(segments);
    if (!step(segments, open)) return false;
  }
  return false;
}

}  // namespace vandplan::rig
