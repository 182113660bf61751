// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which kinds of way are there at all?
//
// Method: docs/algorithms/anytime.md, "Survey".

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "planners/anytime/kinds.h"
#include "planners/anytime/source.h"
#include "search/drive_field.h"
#include "search/grid_distance.h"
#include "search/room.h"
#include "search/route.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

using namespace search;

/// Looks everywhere: what driving costs from the goal back to each place, and from the start to it.
/// Where both add up to little more than what the cheapest way costs, a way leads through; those of
/// different kinds become routes of arcs and lines. Cells are coarse at first. The very first way
/// that is found in a hurry becomes a route at once.
class Survey final : public Source {
 public:
  /// The task and the rule outlive the survey.
  Survey(const Task& task, const CostRule& rule);

  /// A few ten microseconds of work. True when there is a route: `route`.
  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override { return route_; }
  /// What the best route costs: ways that cost much more are of no interest. To be said first.
  void set_cutoff(double cost) override { cutoff_ = cost; }
  /// It looks for the first way alone yet,
  [[nodiscard]] bool is_glance() const { return looks_ == 0; }
  /// or for the first time around: the coarsest look.
  [[nodiscard]] bool is_first_look() const { return looks_ == 1; }

  [[nodiscard]] std::int64_t solves() const override { return forth_.solves() + back_.solves(); }
  [[nodiscard]] std::int64_t checks() const override { return forth_.checks() + back_.checks(); }

 private:
  /// The steps from a root to a node of its field.
  struct Branch {
    std::vector<DriveField::Node> nodes;
    std::vector<LocalPose> poses;  // exact: of the root, and after each step
  };

  [[nodiscard]] bool prepare();
  void look_back();
  [[nodiscard]] bool meet(std::int32_t id);
  [[nodiscard]] bool go_back();
  void go_forth();
  [[nodiscard]] bool go_on();
  [[nodiscard]] bool lead_through(std::int32_t node);
  [[nodiscard]] static Branch branch(const DriveField& field, const LocalPose& root,
                                     std::int32_t node);
  [[nodiscard]] bool join(const Branch& head, const Branch& tail);
  [[nodiscard]] Gears gears_around(const Branch& head, std::size_t heads, const Branch& tail,
                                   std::size_t tails) const;
  void put_together(const Branch& head, std::size_t heads, const Piece& joint, const Branch& tail,
                    std::size_t tails);
  [[nodiscard]] bool is_free() const;
  [[nodiscard]] std::size_t bin_of(const LocalPose& pose, GearSign gear) const;
  void end();

  const Task& task_;
  Connector forth_, back_;  // of ways from the start, and of ways driven from the goal backwards
  Bounds box_;
  double cutoff_ = std::numeric_limits<double>::infinity();
  std::unique_ptr<GridDistance> guide_;
  std::unique_ptr<Room> room_;
  bool is_prepared_ = false;
  std::size_t looks_ = 0;  // around, so far
  double most_ = 0.0;      // that ways cost in this one [m]
  FieldOptions options_;   // of this one,
  Bounds cells_ = {};      // and where its cells are
  std::unique_ptr<DriveField> from_goal_, from_start_;
  bool has_met_ = false;  // the field from the goal has come to the start
  std::int64_t poses_ = 0;
  int routes_ = 0;             // of this look
  std::vector<bool> covered_;  // where routes of this look lead through
  double bin_ = 1.0;           // side of a part of that [m]
  std::int64_t columns_ = 0, rows_ = 0;
  Kinds kinds_;
  Route route_;
};

}  // namespace vandplan::anytime
