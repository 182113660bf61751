// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/commands/closer.h"

#include <algorithm>
#include <cmath>

#include "base/trigonometry.h"
#include "path/clothoid.h"

namespace vandplan::commands {
namespace {

constexpr int most_iterations = 15;        // steps of Newton's method
constexpr double close_enough = 1e-10;     // largest error of the end [m, rad]
constexpr int iterations_to_get_near = 6;  // steps until the end should be near
constexpr double near_enough = 0.2;        // largest error of an end that is near [`length_unit_`]
constexpr double most_turn = 4.0;    // largest turn for the formula of a segment's mean place [rad]
constexpr double difference = 1e-7;  // step of numerical derivatives [rad]

/// A vector turned to the left by 90 degrees: how the point (x, y) moves when it turns about the
/// origin.
Point turned(double x, double y) { return {-y, x}; }

std::array<double, 4> sum(const std::array<double, 4>& a, double factor,
                          const std::array<double, 4>& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2], a[3] + factor * b[3]};
}

/// Makes a command long enough for the wheels to reach its curvature.
void lengthen(const Wheels& wheels, const search::Driven& before, Command& command) {
  const bool rolls_on = command.length == 0.0 && before.gear != 0;
  const search::GearSign gear = rolls_on ? before.gear : gear_of(command);
  if (wheels.may_jump(before, gear)) return;
  const double least = wheels.way(before.curvature, command.curvature);
  if (std::abs(command.length) < least) command.length = gear * least;
}

double largest(const std::array<double, 4>& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2]), std::abs(v[3])});
}

}  // namespace

Closer::Closer(const Vehicle& vehicle, Steering steering)
    : vehicle_(vehicle),
      wheels_(vehicle, steering),
      most_curvature_(1 / vehicle.min_turning_radius),
      curvature_unit_(0.3 * most_curvature_),
      length_unit_(0.3 * std::sqrt(vehicle.min_turning_radius *
                                   (vehicle.trailer ? vehicle.trailer->wheelbase
                                                    : vehicle.min_turning_radius))),
      conditions_(vehicle.trailer ? 4 : 3) {}

Closer::Place Closer::place_after(const Place& from, const Segment& segment) const {
  const auto& [curvature, length, rate] = segment;
  const double hitch_angle = hitch_angle_after(vehicle_, from.hitch_angle, segment);
  path::Displacement way;
  base::SinCos turn;
  if (rate == 0.0) {
    const double half = curvature * length / 2;
    const auto [sin, cos] = base::sin_cos(half);
    const double chord =
        std::abs(half) < 1e-4 ? length * (1 - half * half / 6) : length * sin / half;
    way = {chord * cos, chord * sin, 2 * half};
    turn = {2 * sin * cos, (cos - sin) * (cos + sin)};
  } else {
    way = path::along_clothoid(segment);
    turn = base::sin_cos(way.turn);
  }
  return {
      {from.pose.x + way.x * from.cos - way.y * from.sin,
       from.pose.y + way.x * from.sin + way.y * from.cos, wrap_angle(from.pose.heading + way.turn)},
      from.sin * turn.cos + from.cos * turn.sin,
      from.cos * turn.cos - from.sin * turn.sin,
      hitch_angle};
}

void Closer::drive(const State& from, std::span<Command> commands,
                   const search::DrivenBeside& ends) {
  const auto [sin, cos] = base::sin_cos(from.pose.heading);
  places_.assign(1, {from.pose, sin, cos, from.hitch_angle});
  obeyed_.clear();
  between_.clear();
  search::Driven driven = ends.before;
  for (Command& command : commands) {
    if (ends.after.is_known() && &command == &commands.back()) {
      command.curvature = ends.after.curvature;
      lengthen(wheels_, driven, command);
    }
    const Obeyed obeyed = wheels_.obey(command, driven);
    Place place = places_.back();
    between_.push_back(place);
    for (const Segment& segment : obeyed.view()) {
      between_.back() = place;
      place = place_after(place, segment);
    }
    obeyed_.push_back(obeyed);
    places_.push_back(place);
  }
}

Closer::Vector Closer::gap(const State& to) const {
  const auto& [pose, sin, cos, hitch_angle] = places_.back();
  return {to.pose.x - pose.x, to.pose.y - pose.y, wrap_angle(to.pose.heading - pose.heading),
          to.hitch_angle - hitch_angle};
}

/// Step A: derivatives of the end by one segment. Bending a segment turns all later segments about
/// each of its points. The hitch angle follows its own formula. `passed_on`: derivative of the last
/// hitch angle by the hitch angle after the segment. The call sets it to that by the hitch angle
/// before.
Closer::Change Closer::change(const Place& first, const Segment& segment, const Place& last,
                              double& passed_on) const {
  const auto& [curvature, length, rate] = segment;
  const auto& [last_pose, sin, cos, angle_after] = last;
  const double angle = first.hitch_angle;
  const Pose& end = places_.back().pose;
  const Point swing = turned(end.x - last_pose.x, end.y - last_pose.y);
  // Approximates the mean position of a segment by that of the cubic with the same ends and
  // directions, with more bulge where the segment turns far.
  const double mean_curvature = curvature + rate * std::abs(length) / 2;
  const double half = std::min(std::abs(mean_curvature * length), most_turn) / 2;
  const double bulge = length * (1 + half * half * (1.0 / 15 + half * half * (2.0 / 315))) / 12;
  const Point bend = turned(end.x - (first.pose.x + last_pose.x) / 2 - bulge * (first.cos - cos),
                            end.y - (first.pose.y + last_pose.y) / 2 - bulge * (first.sin - sin));
  const double there = curvature_at(segment, std::abs(length));
  Change result = {{length * bend.x, length * bend.y, length, 0.0},
                   {cos + there * swing.x, sin + there * swing.y, there, 0.0}};
  if (!vehicle_.trailer) return result;
  const double tick = difference * most_curvature_;
  const double bent = hitch_angle_after(vehicle_, angle, {curvature + tick, length, rate});
  const double folded = hitch_angle_after(vehicle_, angle + difference, segment);
  result.bend[3] = passed_on * ((bent - angle_after) / tick);
  result.stretch[3] = passed_on * hitch_rate(vehicle_, angle_after, there);
  passed_on *= (folded - angle_after) / difference;
  return result;
}

/// Step B: derivatives of the end by each command. The curvature of a command bends its arc and the
/// clothoid of the next command. If the wheels do not reach the curvature, the length of the
/// command decides how far they turn.
void Closer::differentiate(std::span<const Command> commands, const search::DrivenBeside& ends) {
  columns_.assign(commands.size(), {});
  double passed_on = 1.0;  // derivative of the last hitch angle by that after the command
  Vector by_wheels = {};   // derivative of the end by the curvature after the command
  for (std::size_t i = commands.size(); i-- > 0;) {
    const Obeyed& obeyed = obeyed_[i];
    Column& column = columns_[i];
    const bool is_gone = obeyed.count == 0;
    const Segment last = is_gone ? commands[i].at_once() : obeyed.segments[obeyed.count - 1U];
    const Change at_end = change(between_[i], last, places_[i + 1], passed_on);
    column.length = at_end.stretch;
    if (is_gone) continue;
    const bool is_turning = last.curvature_rate != 0.0;
    // Derivative of the curvature after the segment by its length [1/m^2].
    const double turning = search::gear_of(last) * last.curvature_rate;
    if (!is_turning) column.curvature = sum(at_end.bend, 1.0, by_wheels);
    if (is_turning && obeyed.reaches_command) column.curvature = by_wheels;
    if (is_turning && !obeyed.reaches_command) {
      column.length = sum(column.length, turning, by_wheels);
    }
    const bool is_arc = !is_turning && obeyed.count == 1;  // the wheels do not turn
    if (obeyed.turns_at_once || is_arc) {
      by_wheels = {};
    } else if (!is_turning) {
      by_wheels = change(places_[i], obeyed.segments[0], between_[i], passed_on).bend;
    } else if (obeyed.reaches_command) {
      by_wheels = at_end.bend;
    } else {
      by_wheels = sum(at_end.bend, 1.0, by_wheels);
    }
    if (ends.after.is_known() && i + 1 == commands.size()) {
      column.curvature_is_fixed = true;
      if (is_turning) by_wheels = sum(by_wheels, -1 / turning, at_end.stretch);
      column.is_shortest = is_turning;
    }
  }
}

/// Step C: Lagrange multipliers of the conditions on the end, which minimise the sum of squared
/// changes. Cholesky's method without roots. False if the conditions are linearly dependent.
bool Closer::solve(const Vector& gap, Vector& multipliers) const {
  std::array<Vector, 4> m{};
  const auto add = [&](const Vector& column, double unit) {
    const Vector scaled = sum({}, unit * unit, column);
    for (std::size_t r = 0; r < m.size(); ++r) m[r] = sum(m[r], column[r], scaled);
  };
  for (const Column& column : columns_) {
    if (!column.curvature_is_fixed) add(column.curvature, curvature_unit_);
    if (!column.length_is_fixed) add(column.length, length_unit_);
  }
  std::array<Vector, 4> factors{};
  Vector inverse{};
  Vector y = gap;
  for (std::size_t r = 0; r < conditions_; ++r) {
    double pivot = m[r][r];
    for (std::size_t c = 0; c < r; ++c) {
      for (std::size_t k = 0; k < c; ++k) m[r][c] -= m[r][k] * factors[c][k];
      factors[r][c] = m[r][c] * inverse[c];
      pivot -= m[r][c] * factors[r][c];
      y[r] -= factors[r][c] * y[c];
    }
    if (!(pivot > 1e-18 * (1 + m[r][r]))) return false;
    inverse[r] = 1 / pivot;
  }
  for (std::size_t r = conditions_; r-- > 0;) {
    y[r] *= inverse[r];
    for (std::size_t k = r + 1; k < conditions_; ++k) y[r] -= factors[k][r] * y[k];
  }
  multipliers = y;
  return true;
}

/// Step D: changes all commands at once. A curvature or length that would leave its limits is held
/// at the limit.
bool Closer::step(std::span<Command> commands, const Vector& gap) {
  const auto dot = [](const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  };
  Vector multipliers{};
  for (int pass = 0; pass < 3; ++pass) {
    if (!solve(gap, multipliers)) return false;
    bool is_final = true;
    for (std::size_t i = 0; i < commands.size(); ++i) {
      Column& column = columns_[i];
      const auto& [curvature, length] = commands[i];
      const double bent = dot(column.curvature, multipliers);
      const bool is_sharp = std::abs(curvature) >= most_curvature_ && bent * curvature > 0.0;
      const bool is_gone = length == 0.0;
      const bool is_short =
          is_gone || (column.is_shortest && dot(column.length, multipliers) * length < 0.0);
      is_final &= column.curvature_is_fixed || !(is_sharp || is_gone);
      is_final &= column.length_is_fixed || !is_short;
      column.curvature_is_fixed |= is_sharp || is_gone;
      column.length_is_fixed |= is_short;
    }
    if (is_final) break;
  }
  double most = 1.0;  // divisor that limits each change to two units
  for (const Column& column : columns_) {
    if (!column.curvature_is_fixed) {
      most = std::max(most, std::abs(dot(column.curvature, multipliers)) * curvature_unit_ / 2);
    }
    if (!column.length_is_fixed) {
      most = std::max(most, std::abs(dot(column.length, multipliers)) * length_unit_ / 2);
    }
  }
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const Column& column = columns_[i];
    auto& [curvature, length] = commands[i];
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

bool Closer::is_held() const {
  if (!vehicle_.trailer) return true;
  for (std::size_t i = 0; i < obeyed_.size(); ++i) {
    if (std::abs(places_[i + 1].hitch_angle) > vehicle_.max_hitch_angle) return false;
    const Segment& first = obeyed_[i].segments[0];
    if (obeyed_[i].count == 0 || first.curvature_rate == 0.0) continue;
    const double most = largest_hitch_angle(vehicle_, places_[i].hitch_angle, first);
    if (most > vehicle_.max_hitch_angle) return false;
  }
  return std::abs(places_.front().hitch_angle) <= vehicle_.max_hitch_angle;
}

double error_growth(const Vehicle& vehicle, double hitch_angle, const Segment& segment) {
  const double apart = hitch_angle_after(vehicle, hitch_angle + difference, segment) -
                       hitch_angle_after(vehicle, hitch_angle - difference, segment);
  return std::abs(apart) / (2 * difference);
}

/// Whether rounding errors of the hitch angle stay small. Where the rig is exactly straight from
/// the start on, there are none.
bool Closer::is_steady() const {
  if (!vehicle_.trailer) return true;
  double growth = 1.0;  // largest growth of an error made anywhere before
  bool is_straight = true;
  const auto grow = [&](double angle, const Segment& segment) {
    is_straight &= angle == 0.0 && segment.curvature == 0.0 && segment.curvature_rate == 0.0;
    if (is_straight) return true;
    growth = std::max(growth, 1.0) * error_growth(vehicle_, angle, segment);
    return growth < most_error_growth;
  };
  for (std::size_t i = 0; i < obeyed_.size(); ++i) {
    const auto& [segments, count, at_once, reaches] = obeyed_[i];
    if (count > 0 && !grow(places_[i].hitch_angle, segments[0])) return false;
    if (count > 1 && !grow(between_[i].hitch_angle, segments[1])) return false;
  }
  return true;
}

bool Closer::close(const State& from, std::span<Command> commands, const State& to,
                   const search::DrivenBeside& ends) {
  for (int i = 0; i < most_iterations; ++i) {
    drive(from, commands, ends);
    const Vector open = gap(to);
    if (largest(open) <= close_enough) return is_held() && is_steady();
    if (!(largest(open) < 1e3)) return false;
    const bool is_lost = i >= iterations_to_get_near && largest(open) > near_enough * length_unit_;
    if (is_lost && !wheels_.are_free()) return false;
    differentiate(commands, ends);
    if (!step(commands, open)) return false;
  }
  return false;
}

std::optional<std::vector<Command>> obeyed(const Task& task, std::vector<Command> commands) {
  const search::DrivenBeside ends = search::driven_at_ends(task);
  const LocalState from = start_state(task);
  const State to = goal_state(task);
  if (!Closer(task.vehicle, task.steering).close(from, commands, to, ends)) return std::nullopt;
  const Wheels wheels(task.vehicle, task.steering);
  const bool is_free = task.checker->is_free(from, wheels.driven(commands, ends.before));
  return is_free ? std::optional(std::move(commands)) : std::nullopt;
}

std::optional<std::vector<Command>> commands_along(const Task& task,
                                                   std::span<const Segment> segments) {
  const Wheels wheels(task.vehicle, task.steering);
  std::vector<Command> commands = wheels.commands(segments, search::driven_at_ends(task));
  hold_curvatures(commands, task.vehicle.min_turning_radius);
  if (commands.empty()) return std::nullopt;
  return obeyed(task, std::move(commands));
}

std::optional<std::vector<Command>> exact_commands(const Task& task,
                                                   std::span<const Segment> segments) {
  if (segments.empty()) return std::nullopt;
  const search::DrivenBeside ends = search::driven_at_ends(task);
  const Wheels wheels(task.vehicle, task.steering);
  std::vector<Command> commands = wheels.commands(segments, ends);
  Closer closer(task.vehicle, task.steering);
  if (!closer.close(start_state(task), commands, goal_state(task), ends)) return std::nullopt;
  return obeyed(task, wheels.tidied(commands, ends.before));
}

}  // namespace vandplan::commands
