// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where could a moving obstacle stand still for a path around it to be worth planning?
//
// A ghost is a moving obstacle during a part of its motion, treated as a standing one: a path that
// avoids the ghost is a path around the obstacle.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/motion.h"
#include "vandplan/problem.h"

namespace vandplan::in_time {

/// The outlines of one moving obstacle, or of all of them, in a span of time.
struct Ghost {
  std::optional<std::size_t> obstacle = {};  ///< index of the moving obstacle; none: all
  double begin = 0.0, end = 0.0;             ///< first and last time [s]; infinity: for ever
  double delay = 0.0;  ///< how much later it begins than the obstacle was met [s]
};

/// Ghosts that a search for paths goes around.
using Ghosts = std::vector<Ghost>;

/// Ghosts for a meeting; those that leave most room come first.
[[nodiscard]] Ghosts ghosts_at(const Meeting& meeting);

/// Which ghosts have been tried, and which leave no way?
class TriedGhosts {
 public:
  /// The moving obstacles are kept by reference.
  explicit TriedGhosts(std::span<const MovingObstacle> moving) : moving_(moving) {}

  /// The ghosts and one more; none if that was tried before. A ghost that lasts for ever begins
  /// later if it is known to leave no way.
  [[nodiscard]] std::optional<Ghosts> with(const Ghosts& ghosts, Ghost more);
  /// The ghosts, of which the last one begins later; none if it does not last for ever, or if its
  /// obstacle is at rest by then.
  [[nodiscard]] std::optional<Ghosts> begun_later(Ghosts ghosts);
  /// Notes that the ghosts leave no way.
  void add_blocked(const Ghosts& ghosts) { blocked_.push_back(ghosts); }

 private:
  [[nodiscard]] bool begin_later(Ghost& ghost) const;
  [[nodiscard]] bool is_blocked(const Ghosts& ghosts) const;

  std::span<const MovingObstacle> moving_;
  std::vector<Ghosts> tried_;
  std::vector<Ghosts> blocked_;
};

/// The task with the ghosts as standing obstacles, beside all that moves. Outlines that the vehicle
/// would touch at the start are left out: the vehicle is elsewhere then. None if the last
/// ghost adds no outline, or start or goal are not free then.
[[nodiscard]] std::optional<Task> task_around(const Task& task, const Ghosts& ghosts,
                                              const ClearanceOptions& clearance);

}  // namespace vandplan::in_time
