// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a drive end exactly where it should?
//
// Method: docs/algorithms/trailers.md.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "planners/commands/wheels.h"
#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan::commands {

/// Growth of an error of the hitch angle from which on a drive is refused: an end within 1e-10 rad
/// would be off by more than 1e-6 rad.
inline constexpr double most_error_growth = 1e4;

/// By how much a small error of the hitch angle grows along a segment that begins with the angle.
/// In reverse it is a factor of e in each length of the trailer.
[[nodiscard]] double error_growth(const Vehicle& vehicle, double hitch_angle,
                                  const Segment& segment);

/// Changes curvatures and lengths of commands as little as possible, until they lead from one state
/// to another. Each thread needs its own closer, which holds buffers.
class Closer {
 public:
  /// The vehicle outlives the closer. Without a trailer hitch angles are ignored.
  explicit Closer(const Vehicle& vehicle, Steering steering = Steering::reeds_shepp);

  /// Changes the commands until they lead from `from` to `to` within 1e-10 m and rad. True if that
  /// succeeded: curvatures and hitch angles are within their limits, gears are as before, the
  /// wheels are as `ends` says, and no rounding error of a hitch angle grows by more than 10^4 on
  /// the way. If false, the commands are of no use. A command may end up without length.
  [[nodiscard]] bool close(const State& from, std::span<Command> commands, const State& to,
                           const search::DrivenBeside& ends = {});

  /// State before command `i` of the commands that were closed last.
  [[nodiscard]] State state_before(std::size_t i) const {
    return {places_[i].pose, places_[i].hitch_angle};
  }

 private:
  using Vector = std::array<double, 4>;

  /// Derivatives of the end by the curvature and by the length of one command.
  struct Column {
    Vector curvature = {}, length = {};
    bool curvature_is_fixed = false, length_is_fixed = false;
    bool is_shortest = false;  // whether the wheels need the whole length to turn
  };
  /// Pose of the rear axle, sine and cosine of its heading, and hitch angle.
  struct Place {
    Pose pose;
    double sin, cos;
    double hitch_angle;
  };
  /// Derivatives of the end by the curvature and by the length of one segment.
  struct Change {
    Vector bend, stretch;
  };

  void drive(const State& from, std::span<Command> commands, const search::DrivenBeside& ends);
  [[nodiscard]] Vector gap(const State& to) const;
  [[nodiscard]] Place place_after(const Place& from, const Segment& segment) const;
  [[nodiscard]] Change change(const Place& first, const Segment& segment, const Place& last,
                              double& passed_on) const;
  void differentiate(std::span<const Command> commands, const search::DrivenBeside& ends);
  [[nodiscard]] bool solve(const Vector& gap, Vector& multipliers) const;
  [[nodiscard]] bool step(std::span<Command> commands, const Vector& gap);
  [[nodiscard]] bool is_held() const;
  [[nodiscard]] bool is_steady() const;

  const Vehicle& vehicle_;
  Wheels wheels_;
  double most_curvature_;                // largest curvature [1/m]
  double curvature_unit_, length_unit_;  // changes of these sizes count alike [1/m], [m]
  /// Number of conditions on the end: 3 for the pose, 1 for the hitch angle.
  std::size_t conditions_;
  std::vector<Place> places_;    // places before each command, and at the end
  std::vector<Obeyed> obeyed_;   // segments of each command
  std::vector<Place> between_;   // place before the last segment of each command
  std::vector<Column> columns_;  // derivatives by each command
};

/// Commands of a free drive of the task, near those given; none if none are found.
[[nodiscard]] std::optional<std::vector<Command>> obeyed(const Task& task,
                                                         std::vector<Command> commands);

/// Commands of a free drive of the task along the segments; none if none are found.
[[nodiscard]] std::optional<std::vector<Command>> commands_along(const Task& task,
                                                                 std::span<const Segment> segments);

/// Commands of a free drive of a rig along segments that nearly lead from the start of the task to
/// its goal; each command has a length. None if none are found.
[[nodiscard]] std::optional<std::vector<Command>> exact_commands(const Task& task,
                                                                 std::span<const Segment> segments);

}  // namespace vandplan::commands
