// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which commands follow a way whose curvature jumps?
//
// Method: docs/algorithms/anytime.md, "Following".

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "planners/commands/closer.h"
#include "planners/commands/wheels.h"
#include "vandplan/random.h"

namespace vandplan::anytime {

/// Follows a way part by part. A part ends where the wheels can be as the way says: in the middle
/// of a long segment, or where the gear changes. There the drive is on the way again, so turning
/// the wheels in one place moves nothing elsewhere. Blocked commands are then changed at random.
class Follower {
 public:
  /// The task has no trailer. Task and closer outlive the follower.
  Follower(const Task& task, const search::DrivenBeside& ends, commands::Closer& closer,
           std::uint64_t seed);

  /// Begins to follow another way.
  void follow(std::span<const Segment> way);
  /// Works for some ten microseconds; false when nothing is left to do.
  bool step();
  /// Commands of a free drive from the start of the task to its goal; none if none was found.
  [[nodiscard]] std::optional<std::vector<commands::Command>> drive() const;
  /// Segments checked for collisions.
  [[nodiscard]] std::int64_t checks() const { return checks_; }

 private:
  /// Place where a part of the way may end.
  struct Cut {
    std::size_t segment;  // index of the first segment behind the cut
    LocalPose pose;
    double curvature;  // curvature of the wheels there [1/m]; `Driven::any`: any
  };
  /// How far the drive has come.
  struct Stage {
    std::size_t segment;   // index of the next segment of the way
    std::size_t commands;  // number of commands so far
    LocalPose pose;
    search::Driven driven;
  };

  void cut(std::span<const Segment> way);
  bool go_on();
  [[nodiscard]] std::vector<commands::Command> part_between(const Stage& from, const Cut& to);
  void take(const Stage& from, std::size_t cut, std::span<const commands::Command> part);
  void measure(std::size_t first, std::size_t last);
  [[nodiscard]] std::pair<std::size_t, std::size_t> any_window();
  [[nodiscard]] double blocked(std::span<const commands::Command> commands, LocalPose pose,
                               search::Driven driven,
                               double most = std::numeric_limits<double>::infinity());
  void shake();

  const Task& task_;
  search::DrivenBeside ends_;
  commands::Wheels wheels_;
  commands::Closer& closer_;
  Rng rng_;
  std::int64_t checks_ = 0;
  std::vector<Segment> way_;  // the way, with a joint at each cut
  std::vector<Cut> cuts_;
  std::size_t next_ = 0;                  // index of the next cut
  std::size_t tried_ = 0;                 // cuts tried in vain, from `next_` on
  std::vector<Stage> stages_;             // stages where the parts of the drive begin
  std::vector<commands::Command> drive_;  // commands of the drive
  /// Poses before each command of the drive, and at its end.
  std::vector<LocalPose> poses_;
  /// Gears and curvatures before each command of the drive, and at its end.
  std::vector<search::Driven> driven_;
  /// Blocked length of each command of the drive [m].
  std::vector<double> blocked_;
  double left_ = 0.0;  // blocked length of the whole drive [m]
  int idle_ = 0;       // trials since `left_` last fell
};

}  // namespace vandplan::anytime
