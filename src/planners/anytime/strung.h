// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a way over a whole site driven? It is pulled straight, like a string around what stands
// there, and driven exactly from corner to corner.

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "planners/anytime/lattice.h"
#include "search/guide.h"
#include "search/route.h"

namespace vandplan::anytime {

/// As far as it is on open ground.
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

/// A route along a way of points from the task's start to its goal. Work goes with its length.
class Strung {
 public:
  /// `way` has both ends, and its steps are about as long as each other.
  Strung(const Task& task, std::vector<Point> way, Connector& connector);

  /// Some microseconds of work. False when there is no more to do.
  [[nodiscard]] bool step();

  /// Whether the goal was reached.
  [[nodiscard]] bool is_complete() const { return !corners_.empty() && next_ == corners_.size(); }
  /// From the start on, without a cost.
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
  [[nodiscard]] Gears gears_of_leg() const;
  [[nodiscard]] const LocalPose& here() const;

  const Task& task_;
  Connector& connector_;
  GearSign gear_;  // in which the way is driven where it is straight
  std::vector<Point> way_;
  std::size_t least_places_;              // of the way from bend to bend
  std::vector<std::size_t> bends_ = {0};  // places on the way that are in sight of each other
  std::vector<LocalPose> corners_;        // the poses there, but for the start
  std::size_t next_ = 0;                  // of the corners: where the leg leads to
  int left_out_ = 0;                      // corners in a row
  std::optional<Beeline> guide_;          // the corners of a leg are in sight of each other
  std::optional<Lattice> lattice_;        // where the leg is not driven directly
  int expansions_ = 0;
  Route route_;
};

}  // namespace vandplan::anytime
