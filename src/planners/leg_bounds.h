// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much do paths past the vias cost at least? A proven lower bound, leg by leg.
//
// A path is a chain of legs, each from a part of a via to a part of the next. The bound is the cost
// of the cheapest chain, if each leg costs no more than is proven of it. Proof:
// docs/proofs/anytime_bounds.md.

#include <array>
#include <cstdint>
#include <vector>

#include "planners/goal_poses.h"
#include "planners/path_search.h"
#include "planners/pricing.h"
#include "search/open_ground.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// Lower bound of the cost of all paths past the vias of a task, to its goal or to the continuous
/// regions of its set. Single poses of vias that are not free are left out. The bound only rises.
class LegBounds {
 public:
  /// Task and pricing outlive the bounds. Chains are refined until `work` pairs of parts were
  /// looked at, each in some 50 ns.
  LegBounds(const Task& task, const Pricing& pricing, std::int64_t work);

  /// Takes what is proven of paths between two poses: leg `leg` leads to via `leg`, or to the goal.
  /// A bound around obstacles may hold for other headings at the same places, too.
  void raise(std::size_t leg, const Pose& from, const Pose& to, const Proven& proven);

  /// The bound [m or s].
  [[nodiscard]] double least();
  /// The bound [m or s], or what is known of it once the budget is interrupted.
  [[nodiscard]] double least(const search::Budget& budget);

 private:
  /// What is known of a leg from one part to another.
  struct Leg {
    search::OpenGround ground;
    double around = 0.0;    // lower bound of its length around obstacles [m]
    double added = 0.0;     // what zones and masks add at least to its cost
    double in_zones = 0.0;  // lower bound of its cost by zones and masks alone
    bool is_sharp = false;  // whether `ground` tells headings
  };
  /// Start, goal, or a part of a via.
  struct Stop {
    PlacedPart place;
    RegionPart part = {};
    const GoalRegion* region = nullptr;  // null: the one pose of `place`
  };
  /// The cheapest chain up to a stop that is reached in one gear.
  struct Reached {
    double cost;
    std::size_t from = 0, gear = 0;  // stop before, and index of its gear
  };
  using Gears = std::array<Reached, 2>;

  void add_stops(const Task& task, const std::vector<GoalRegion>& regions, bool is_goal);
  [[nodiscard]] Leg blunt_leg(const Stop& from, const Stop& to) const;
  void sharpen(Leg& leg, const Stop& from, const Stop& to) const;
  [[nodiscard]] double length(const Leg& leg) const;
  [[nodiscard]] double run(const Leg& leg, std::size_t first, std::size_t last) const;
  void go_on(const Leg& leg, const Gears& before, std::size_t from, Gears& reached) const;
  std::int64_t find_chain();
  bool improve_chain();
  void halve(std::size_t stage, std::size_t stop);
  [[nodiscard]] std::vector<double> moves() const;
  [[nodiscard]] double sum_of_least(double Leg::*known) const;

  const Pricing& pricing_;
  const Vehicle& vehicle_;
  const std::vector<Via>& via_;
  search::CostRule rule_;
  std::vector<std::vector<Stop>> stages_;            // start, vias, goal
  std::vector<std::vector<std::vector<Leg>>> legs_;  // between a stage and the next, of each pair
  std::vector<std::size_t> chain_;                   // stop of each stage on the cheapest chain
  double least_ = 0.0;                               // cost of that chain
  std::int64_t work_;                                // pairs that may still be looked at
  bool is_settled_ = false;  // whether the bound is that of all that is known
};

}  // namespace vandplan::planning
