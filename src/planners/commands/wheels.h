// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a vehicle drive whose wheels turn no faster than they can?
//
// A drive is a chain of commands. At each command the wheels turn to its curvature as fast as they
// may, and stay there. So every chain of commands can be driven, and the curvature is as continuous
// as it must be.
//
// Method: docs/algorithms/trailers.md.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "search/wheels.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::commands {

/// What wheels are told: to turn to a curvature as fast as they may, and to stay there.
struct Command {
  double curvature = 0.0;  ///< curvature to which the wheels turn [1/m]
  double length = 0.0;     ///< way driven while they turn and stay [m]; negative in reverse
  bool operator==(const Command&) const = default;

  /// What is driven if the wheels turn at once.
  [[nodiscard]] Segment at_once() const { return {curvature, length}; }
};

[[nodiscard]] inline search::GearSign gear_of(const Command& command) {
  return command.length < 0.0 ? -1 : 1;
}

/// Segments that are driven for one command.
struct Obeyed {
  /// A clothoid, an arc or line, or both in this order; the first `count` are used.
  std::array<Segment, 2> segments = {};
  std::uint8_t count = 0;
  bool turns_at_once = false;    ///< whether the curvature jumps, whatever was driven before
  bool reaches_command = false;  ///< whether the wheels reach the command's curvature

  [[nodiscard]] std::span<const Segment> view() const { return {segments.data(), count}; }
};

/// Where and how fast the wheels of a vehicle may turn.
class Wheels {
 public:
  Wheels(const Vehicle& vehicle, Steering steering);

  /// Whether the curvature may jump anywhere, not only at stops.
  [[nodiscard]] bool are_free() const { return steering_ == Steering::reeds_shepp; }

  /// `search::may_jump` for these wheels.
  [[nodiscard]] bool may_jump(const search::Driven& before, search::GearSign next) const {
    return search::may_jump(steering_, before, next);
  }

  /// Segments that are driven for a command. `before`: gear and curvature before the command; the
  /// call sets it to those after the command. No segments, and `before` stays, if the command is
  /// shorter than 1e-10 m: nobody stops for such a stroke.
  [[nodiscard]] Obeyed obey(const Command& command, search::Driven& before) const;

  /// The segments of a whole chain of commands.
  [[nodiscard]] std::vector<Segment> driven(std::span<const Command> commands,
                                            search::Driven before) const;

  /// Commands along segments whose curvature may jump. At a jump, the wheels turn half before and
  /// half after it, if there is room.
  [[nodiscard]] std::vector<Command> commands(std::span<const Segment> segments,
                                              const search::DrivenBeside& ends) const;

  /// The commands without those shorter than 1e-10 m; equal neighbours are joined. A curvature that
  /// the wheels do not reach is replaced by the curvature that they reach.
  [[nodiscard]] std::vector<Command> tidied(std::span<const Command> commands,
                                            search::Driven before) const;

  /// Gears and curvatures around the commands [first, last) of a chain, which are about to change.
  /// Where the vehicle rolls on after command last - 1, the curvature there must stay for the next
  /// command. `driven`: gear and curvature before each command, and at the end. `ends`: those
  /// around the whole chain.
  [[nodiscard]] search::DrivenBeside ends_of_part(std::span<const Command> chain,
                                                  std::span<const search::Driven> driven,
                                                  std::size_t first, std::size_t last,
                                                  const search::DrivenBeside& ends) const;

  /// Distance driven while the wheels turn from one curvature to another [m].
  [[nodiscard]] double way(double from, double to) const;

 private:
  Steering steering_;
  double rate_;  // largest change of curvature for each metre [1/m^2]
};

/// Length below which a segment is a crumb, which no driver drives [m]: a seventieth of the turning
/// radius, 0.1 m for a truck.
[[nodiscard]] constexpr double crumb_length(double turning_radius) { return turning_radius / 70; }

/// Largest cost of leaving out all crumbs of a drive, relative: 1 cm of 100 m, less than any search
/// leaves.
inline constexpr double crumb_slack = 1e-4;

/// Limits the curvatures of commands to the turning radius.
void hold_curvatures(std::span<Command> commands, double turning_radius);

}  // namespace vandplan::commands
