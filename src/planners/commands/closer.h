// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a drive bent so that it ends exactly where it should?
//
// Method: docs/algorithms/trailers.md.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "planners/commands/wheels.h"
#include "vandplan/problem.h"
#include "vandplan/rig.h"

namespace vandplan::commands {

/// Changes curvatures and lengths of commands, as little as possible, until they lead from one
/// state to another. One for each thread: it holds its buffers.
class Closer {
 public:
  /// The vehicle outlives the closer. Without a trailer hitch angles do not count.
  explicit Closer(const Vehicle& vehicle, Steering steering = Steering::reeds_shepp);

  /// Whether the commands now lead from `from` to `to` within 1e-10 m and rad, with every curvature
  /// and hitch angle in its limit, every gear as it was, the wheels as they should be at the ends,
  /// and no rounding of a hitch angle growing on the way by more than 10^4; else they are of no
  /// use. A command may be left without length.
  [[nodiscard]] bool close(const RigState& from, std::span<Segment> commands, const RigState& to,
                           const WheelEnds& ends = {});

  /// Before command `i` of those that were closed last.
  [[nodiscard]] RigState state_before(std::size_t i) const {
    return {places_[i].pose, places_[i].hitch_angle};
  }

 private:
  using Vector = std::array<double, 4>;

  /// How the end changes with the curvature and with the length of one command.
  struct Column {
    Vector curvature = {}, length = {};
    bool curvature_is_fixed = false, length_is_fixed = false;
    bool is_shortest = false;  // all of the length is needed to turn the wheels
  };
  /// Where the axle is and where it heads.
  struct Place {
    Pose pose;
    double sin, cos;  // of the heading
    double hitch_angle;
  };
  /// How the end changes when a segment is bent or goes on at its end.
  struct Change {
    Vector bend, stretch;
  };

  void drive(const RigState& from, std::span<Segment> commands, const WheelEnds& ends);
  [[nodiscard]] Vector gap(const RigState& to) const;
  [[nodiscard]] Place place_after(const Place& from, const Segment& segment) const;
  [[nodiscard]] Change change(const Place& first, const Segment& segment, const Place& last,
                              double& passed_on) const;
  void differentiate(std::span<const Segment> commands, const WheelEnds& ends);
  [[nodiscard]] bool solve(const Vector& gap, Vector& multipliers) const;
  [[nodiscard]] bool step(std::span<Segment> commands, const Vector& gap);
  [[nodiscard]] bool is_held() const;
  [[nodiscard]] bool is_steady() const;

  const Vehicle& vehicle_;
  Wheels wheels_;
  double most_curvature_;
  double curvature_unit_, length_unit_;  // changes of these sizes count alike
  std::size_t conditions_;               // on the end: its pose, and the hitch angle
  std::vector<Place> places_;            // before each command, and at the end
  std::vector<Obeyed> obeyed_;           // at each command
  std::vector<Place> between_;           // its segments
  std::vector<Column> columns_;
};

/// Commands of a free drive of the task, near those given; nothing if none are found.
[[nodiscard]] std::optional<std::vector<Segment>> obeyed(const Task& task,
                                                         std::vector<Segment> commands);

/// Commands of a free drive of the task along the segments; nothing if none are found.
[[nodiscard]] std::optional<std::vector<Segment>> commands_along(const Task& task,
                                                                 std::span<const Segment> segments);

}  // namespace vandplan::commands
