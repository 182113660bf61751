// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/commands/wheels.h"

#include <algorithm>
#include <cmath>

#include "vandplan/steering.h"

namespace vandplan::commands {
namespace {

using search::Driven, search::GearSign, search::gear_of;

constexpr double crumb = 1e-10;  // length that counts as none [m]
/// Length of the arc between a stop and a clothoid, times the root of the curvature rate.
constexpr double first_arc = 5e-3;

/// Makes room for the first half of turning the wheels to a curvature, which takes `half` metres.
/// The room is taken from the last command, or driven in addition before the gear changes.
void turn_ahead(std::vector<Command>& commands, double curvature, double half, GearSign next) {
  Command& last = commands.back();
  const GearSign gear = gear_of(last);
  if (gear == next) {
    last.length -= gear * std::min(half, std::abs(last.length) / 2);
  } else {
    commands.push_back({(last.curvature + curvature) / 2, gear * half});
  }
}

}  // namespace

Wheels::Wheels(const Vehicle& vehicle, Steering steering)
    : steering_(steering), rate_(max_curvature_rate(vehicle)) {}

double Wheels::way(double from, double to) const { return std::abs(to - from) / rate_; }

Obeyed Wheels::obey(const Command& command, Driven& before) const {
  if (std::abs(command.length) < crumb) return {};
  const GearSign gear = gear_of(command);
  Obeyed result;
  result.reaches_command = true;
  result.turns_at_once = may_jump(before, gear);
  const double turning = result.turns_at_once ? 0.0 : way(before.curvature, command.curvature);
  if (turning <= crumb) {
    result.segments[result.count++] = command.at_once();
    before = {gear, command.curvature};
    return result;
  }
  const double size = std::abs(command.length);
  const double rate = std::copysign(rate_, command.curvature - before.curvature);
  result.segments[result.count++] = {before.curvature, gear * std::min(turning, size), rate};
  result.reaches_command = turning <= size + crumb;
  if (turning < size - crumb) {
    result.segments[result.count++] = {command.curvature, gear * (size - turning)};
  }
  before = result.reaches_command ? Driven{gear, command.curvature}
                                  : search::last_driven(result.segments[0]);
  return result;
}

std::vector<Segment> Wheels::driven(std::span<const Command> commands, Driven before) const {
  std::vector<Segment> result;
  result.reserve(commands.size());
  for (const Command& command : commands) {
    const Obeyed obeyed = obey(command, before);
    result.insert(result.end(), obeyed.view().begin(), obeyed.view().end());
  }
  return result;
}

std::vector<Command> Wheels::commands(std::span<const Segment> segments,
                                      const search::DrivenBeside& ends) const {
  std::vector<Command> result;
  result.reserve(segments.size());
  Driven before = ends.before;
  for (const Segment& segment : segments) {
    const Driven after = search::last_driven(segment);
    Command command{after.curvature, segment.length};
    const bool is_free = result.empty() || may_jump(before, after.gear);
    if (may_jump(before, after.gear) && segment.curvature_rate != 0.0) {
      const double length = std::min(first_arc / std::sqrt(rate_), std::abs(segment.length) / 2);
      result.push_back({segment.curvature, after.gear * length});
    }
    const double half = is_free ? 0.0 : way(before.curvature, segment.curvature) / 2;
    if (half > crumb) {
      turn_ahead(result, segment.curvature, half, after.gear);
      command.length += after.gear * half;
    } else if (!is_free && before.gear == after.gear && segment.curvature_rate == 0.0) {
      command.length += result.back().length;  // the wheels do not turn: one command is enough
      result.pop_back();
    }
    result.push_back(command);
    before = after;
  }
  const double last = ends.after.curvature;
  if (ends.after.is_known() && !result.empty() && last != result.back().curvature) {
    const GearSign gear = gear_of(result.back());
    result.push_back({last, gear * way(result.back().curvature, last)});
  }
  return result;
}

std::vector<Command> Wheels::tidied(std::span<const Command> commands, Driven before) const {
  std::vector<Command> result;
  for (Command command : commands) {
    if (std::abs(command.length) < crumb) continue;
    if (!are_free()) {
      (void)obey(command, before);
      command.curvature = before.curvature;
    }
    const bool goes_on = !result.empty() && result.back().curvature == command.curvature &&
                         gear_of(result.back()) == gear_of(command);
    if (goes_on) {
      result.back().length += command.length;
    } else {
      result.push_back(command);
    }
  }
  return result;
}

search::DrivenBeside Wheels::ends_of_part(std::span<const Command> chain,
                                          std::span<const Driven> driven, std::size_t first,
                                          std::size_t last,
                                          const search::DrivenBeside& ends) const {
  if (last == chain.size()) return {driven[first], ends.after};
  const GearSign next = gear_of(chain[last]);
  const bool is_any = may_jump(driven[last], next);
  return {driven[first], {next, is_any ? Driven::any : driven[last].curvature}};
}

void hold_curvatures(std::span<Command> commands, double turning_radius) {
  const double sharpest = 1 / turning_radius;
  for (Command& command : commands) {
    command.curvature = std::clamp(command.curvature, -sharpest, sharpest);
  }
}

}  // namespace vandplan::commands
