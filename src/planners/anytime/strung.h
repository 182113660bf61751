// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a way over a whole site driven?
//
// The way is pulled straight, like a string around obstacles. The vehicle drives exactly from
// corner to corner.

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "planners/anytime/lattice.h"
#include "search/guide.h"
#include "search/route.h"

namespace vandplan::anytime {

/// Guide of straight distances to the target [m], as if there were no obstacles.
class Beeline final : public Guide {
 public:
  explicit Beeline(const LocalPose& target) : target_(target) {}
  bool step() override { return false; }
  [[nodiscard]] bool is_connected() const noexcept override { return true; }
  [[nodiscard]] double at(double x, double y) const noexcept override {
    return std::hypot(x - target_.x, y - target_.y);
  }

 private:
  LocalPose target_;
};

/// Makes a route along a way of points from the task's start to its goal. Work grows with the
/// length of the way.
class Strung {
 public:
  /// `way` has both ends, and its steps are about equally long. Task and connector outlive the
  /// object.
  Strung(const Task& task, std::vector<Point> way, Connector& connector);

  /// Works for some microseconds. False when nothing is left to do.
  [[nodiscard]] bool step();

  /// Whether the goal was reached.
  [[nodiscard]] bool is_complete() const { return !corners_.empty() && next_ == corners_.size(); }
  /// The route from the start as far as it is found. Its cost is not set.
  [[nodiscard]] const Route& route() const { return route_; }

 private:
  [[nodiscard]] double heading_along(double direction) const;
  [[nodiscard]] bool sees(std::size_t from, std::size_t to);
  [[nodiscard]] std::size_t farthest_seen(std::size_t from);
  void pull();
  void turn_corners();
  void begin_leg();
  bool search_leg();
  void reach_corner();
  [[nodiscard]] double dearest_leg(const LocalPose& corner) const;
  [[nodiscard]] DrivenBeside driven_beside_leg() const;
  [[nodiscard]] const LocalPose& here() const;

  const Task& task_;
  Connector& connector_;
  GearSign gear_;  // gear for the straight parts of the way
  std::vector<Point> way_;
  std::size_t least_places_;              // least number of steps of the way between two bends
  std::vector<std::size_t> bends_ = {0};  // indices of the places of the way where the string bends
  std::vector<LocalPose> corners_;        // poses at the bends, without the start
  std::size_t next_ = 0;                  // index of the corner that the current leg leads to
  int left_out_ = 0;                      // corners left out in a row
  std::optional<Beeline> guide_;    // guide of the leg: a straight line, as its ends see each other
  std::optional<Lattice> lattice_;  // search for the leg, if it is not driven directly
  int expansions_ = 0;              // expansions of this search
  Route route_;
};

}  // namespace vandplan::anytime
