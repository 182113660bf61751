// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which commands follow a way whose curvature jumps?
//
// Method: docs/algorithms/anytime.md, "Following".

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "planners/commands/closer.h"
#include "planners/commands/wheels.h"
#include "vandplan/random.h"

namespace vandplan::anytime {

/// Follows a way part by part. A part ends where the wheels may well be as the way says: in the
/// middle of a long segment, or where the gear changes. There the drive is on the way again, so
/// what it takes to turn the wheels in one place moves nothing elsewhere. What runs into something
/// is then changed at random.
class Follower {
 public:
  /// The task, which is without a trailer, and the closer outlive the follower.
  Follower(const Task& task, const commands::WheelEnds& ends, commands::Closer& closer,
           std::uint64_t seed);

  /// Begins to follow another way.
  void follow(std::span<const Segment> way);
  /// A few ten microseconds of work; false when there is no more to do.
  bool step();
  /// A free drive from the start of the task to its goal; nothing if none was found.
  [[nodiscard]] std::optional<std::vector<Segment>> drive() const;
  /// Drives that were checked.
  [[nodiscard]] std::int64_t checks() const { return checks_; }

 private:
  /// Where a part of the way may end.
  struct Cut {
    std::size_t segment;  // the first one behind it
    LocalPose pose;
    std::optional<double> curvature;  // of the wheels there; none: any
  };
  /// How far the drive has come.
  struct Stage {
    std::size_t segment;   // of the way: the next one
    std::size_t commands;  // of the drive
    LocalPose pose;
    search::Driven driven;
  };
  /// A drive from a stage to a cut.
  struct Part {
    Stage from;
    std::size_t cut = 0;
    std::vector<Segment> commands;
    double blocked = 0.0;  // how much of it runs into something [m]
  };

  /// Commands of the drive.
  struct Window {
    std::size_t first, last;  // the one after them
  };

  void cut(std::span<const Segment> way);
  bool go_on();
  [[nodiscard]] bool lead(Part& part);
  void take(const Part& part);
  void measure(std::size_t first, std::size_t last);
  [[nodiscard]] Window any_window();
  [[nodiscard]] double blocked(std::span<const Segment> commands, LocalPose pose,
                               search::Driven driven, double most);
  void shake();

  const Task& task_;
  commands::WheelEnds ends_;
  commands::Wheels wheels_;
  commands::Closer& closer_;
  Rng rng_;
  std::int64_t checks_ = 0;
  std::vector<Segment> way_;  // with a joint at each cut
  std::vector<Cut> cuts_;
  std::size_t next_ = 0;        // cut
  std::size_t tried_ = 0;       // cuts in vain since then
  std::optional<Part> nearly_;  // free: that with the least in its way
  std::vector<Stage> stages_;
  std::vector<Segment> drive_;
  // Of the whole drive: before each command and at the end, and how much of each runs into
  // something.
  std::vector<LocalPose> poses_;
  std::vector<search::Driven> driven_;
  std::vector<double> blocked_;
  double left_ = 0.0;  // in all
  int idle_ = 0;       // trials since there was more
};

}  // namespace vandplan::anytime
