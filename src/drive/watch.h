// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a driven vehicle touch?
//
// All that is swept is looked at: the collision checker answers for what it accepts, the judge
// decides about the rest.

#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "vandplan/collision.h"
#include "vandplan/problem.h"
#include "vandplan/rig.h"

namespace vandplan::driving {

/// Looks at a drive step by step, in the frame of the world.
class Watch {
 public:
  /// The rig may fold up further than `max_hitch_angle` by the share `spare`.
  explicit Watch(const Problem& problem, double spare = 0.0);

  /// Looks at an arc that is driven from `from` to `to`. What is touched, the first time that
  /// something is: "the footprint hits obstacles[3]". A trailer that folds up beyond its limit
  /// touches its tractor.
  std::optional<std::string> look(const RigState& from, const Segment& arc, const RigState& to);

  /// The least clearance at the poses so far, 0 after a contact; infinite without things [m].
  [[nodiscard]] double clearance() const noexcept { return least_; }
  /// How far the rear axle was outside of the bounds [m].
  [[nodiscard]] double out_of_bounds() const noexcept { return outside_; }

 private:
  void look_at(const RigState& state);
  [[nodiscard]] double most_moved(const Segment& arc) const noexcept;
  [[nodiscard]] std::string touched(const RigState& from, const Segment& arc,
                                    const RigState& to) const;

  std::shared_ptr<const World> world_;  // without bounds
  std::shared_ptr<const CollisionChecker> checker_;
  Vehicle vehicle_;
  Bounds bounds_;
  double most_hitch_angle_ = 0.0;
  double reach_ = 0.0;          // of footprint and wheels [m]
  double trailer_reach_ = 0.0;  // of the trailer from its hitch [m]
  double least_ = std::numeric_limits<double>::infinity();
  double free_ = 0.0;     // so far may any point of the vehicle move without touching [m]
  double nothing_ = 0.0;  // and so far without being nearer than ever [m]
  double outside_ = 0.0;
  bool has_touched_ = false;
};

}  // namespace vandplan::driving
