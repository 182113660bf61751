// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a driven vehicle touch?
//
// The whole swept area is checked. The collision checker accepts arcs that are surely free. The
// judge decides about all others.

#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "vandplan/collision.h"
#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan::driving {

/// Checks a drive for contacts, step by step, in the world's frame.
class Watch {
 public:
  /// The hitch angle may exceed `max_hitch_angle` by the share `spare`.
  explicit Watch(const Problem& problem, double spare = 0.0);

  /// Checks an arc that is driven from `from` to `to`. Returns the contact if this is the first
  /// one, such as "the footprint hits obstacles[3]". A hitch angle beyond its limit counts as a
  /// contact.
  std::optional<std::string> look(const State& from, const Segment& arc, const State& to);

  /// Least clearance at the poses so far [m]; 0 after a contact, infinite without obstacles.
  [[nodiscard]] double clearance() const noexcept { return least_; }
  /// Largest distance of the rear axle outside of the bounds [m].
  [[nodiscard]] double out_of_bounds() const noexcept { return outside_; }

 private:
  void look_at(const State& state);
  [[nodiscard]] double most_moved(const Segment& arc) const noexcept;
  [[nodiscard]] std::string touched(const State& from, const Segment& arc, const State& to) const;

  std::shared_ptr<const World> world_;  // world with bounds that the vehicle cannot reach
  std::shared_ptr<const CollisionChecker> checker_;
  Vehicle vehicle_;
  Bounds bounds_;
  double most_hitch_angle_ = 0.0;
  // Distance of the furthest point of footprint and wheels from the rear axle [m].
  double reach_ = 0.0;
  double trailer_reach_ = 0.0;  // distance of the furthest point of the trailer from its hitch [m]
  double least_ = std::numeric_limits<double>::infinity();
  double free_ = 0.0;  // distance that any point of the vehicle may move without a contact [m]
  // Distance that any point may move before the least clearance can decrease [m].
  double nothing_ = 0.0;
  double outside_ = 0.0;
  bool has_touched_ = false;
};

}  // namespace vandplan::driving
