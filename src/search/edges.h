// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which piece joins two poses, what does it cost, and may it be driven?

#include <cstdint>

#include "search/cost.h"
#include "vandplan/problem.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan {

/// What is driven before and after a piece.
struct Gears {
  GearSign before = 0;
  GearSign after = 0;
};

/// Steering, cost and collision checking of one problem; counts what it is asked. One per thread.
class Edges {
 public:
  Edges(const World& world, const CostRule& rule)
      : checker_(world.checker()), radius_(world.vehicle().min_turning_radius), rule_(rule) {}

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] const CostRule& rule() const { return rule_; }

  /// The Reeds-Shepp word of least cost; the shortest one under a neutral rule.
  [[nodiscard]] Piece steer(const Pose& from, const Pose& to, const Gears& gears);

  /// Length of the shortest path on open ground: no path between the poses costs less [m].
  [[nodiscard]] double least_cost(const Pose& from, const Pose& to);

  /// Of a piece between two others; the joint to the next one is its part, if there is one.
  [[nodiscard]] double cost(const Piece& piece, const Gears& gears) const;

  [[nodiscard]] bool is_free(const Pose& from, const Piece& piece);
  [[nodiscard]] bool is_free(const Pose& from, const Segment& segment);
  [[nodiscard]] bool is_free(const Pose& pose) const { return checker_.is_free(pose); }

  /// As much of the piece as is free, found by halving.
  [[nodiscard]] Piece free_prefix(const Pose& from, const Piece& piece);

  [[nodiscard]] std::int64_t solves() const { return solves_; }
  [[nodiscard]] std::int64_t checks() const { return checks_; }

 private:
  const CollisionChecker& checker_;
  double radius_;
  CostRule rule_;
  std::int64_t solves_ = 0;
  std::int64_t checks_ = 0;
};

/// The first `s` metres of a piece.
[[nodiscard]] Piece prefix(const Piece& piece, double s);

/// The piece without its first `s` metres.
[[nodiscard]] Piece suffix(const Piece& piece, double s);

/// The pose at the end of a piece.
[[nodiscard]] Pose end_of(const Pose& from, const Piece& piece);

}  // namespace vandplan
