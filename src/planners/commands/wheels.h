// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a vehicle drive whose wheels turn no faster than they can?
//
// A drive is a chain of commands: segments without a rate. At each of them the wheels turn to its
// curvature, as fast as they may, and stay there; its length counts the metres of both. So every
// chain of commands is a drive, and its curvature is as continuous as it has to be.
//
// Method: docs/algorithms/trailers.md.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::commands {

/// How the wheels are before the first command of a chain and after the last one.
struct WheelEnds {
  search::Driven before = {};
  std::optional<double> after = {};  ///< curvature [1/m]; none: any
};

/// What is driven at one command.
struct Obeyed {
  std::array<Segment, 2> segments = {};  ///< the first `count` are there: a clothoid, an arc
  std::uint8_t count = 0;
  bool turns_at_once = false;    ///< what was before the command does not matter
  bool reaches_command = false;  ///< the wheels get as far as they should

  [[nodiscard]] std::span<const Segment> view() const { return {segments.data(), count}; }
};

/// Where and how fast the wheels of a vehicle may turn.
class Wheels {
 public:
  Wheels(const Vehicle& vehicle, Steering steering);

  /// Whether the curvature may jump somewhere else than at stops.
  [[nodiscard]] bool are_free() const { return steering_ == Steering::reeds_shepp; }

  /// Whether they may turn at once between what is driven before and next.
  [[nodiscard]] bool may_jump(const search::Driven& before, search::GearSign next) const;

  /// What is driven after `before`, which becomes how that ends. Nothing if the command has no
  /// length, or next to none: nobody stops for a stroke of less than 1e-10 m.
  [[nodiscard]] Obeyed obey(const Segment& command, search::Driven& before) const;

  /// What is driven along the whole chain.
  [[nodiscard]] std::vector<Segment> driven(std::span<const Segment> commands,
                                            search::Driven before) const;

  /// Commands that lead along the segments, whose curvature may jump: there half of what it takes
  /// to turn the wheels is driven before the jump, if there is room for it.
  [[nodiscard]] std::vector<Segment> commands(std::span<const Segment> segments,
                                              const WheelEnds& ends) const;

  /// Commands of nearly no length left out, and alike ones joined; what the wheels did not get to
  /// becomes what they got to.
  [[nodiscard]] std::vector<Segment> tidied(std::span<const Segment> commands,
                                            search::Driven before) const;

  /// The wheels at both ends of a part of a chain, from command `first` to the one before `last`,
  /// which is about to change. Where the vehicle rolls on they stay as they are, for the sake of
  /// what comes next. `driven`: before each command, and at the end; `ends`: of the whole chain.
  [[nodiscard]] WheelEnds ends_of_part(std::span<const Segment> chain,
                                       std::span<const search::Driven> driven, std::size_t first,
                                       std::size_t last, const WheelEnds& ends) const;

  /// What is driven from one curvature to another [m].
  [[nodiscard]] double way(double from, double to) const;

 private:
  Steering steering_;
  double rate_;  // change of curvature for each metre [1/m^2]
};

/// Segments shorter than this are crumbs, which no driver drives: a seventieth of the turning
/// radius, 0.1 m for a truck [m].
[[nodiscard]] constexpr double crumb_length(double turning_radius) { return turning_radius / 70; }

/// Leaves no command sharper than the vehicle turns.
void hold_curvatures(std::span<Segment> commands, double turning_radius);

/// How the wheels of the task are at its start and at its goal.
[[nodiscard]] WheelEnds wheel_ends(const Task& task);

}  // namespace vandplan::commands
