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
#include "search/clearance_raster.h"
#include "search/drive_field.h"
#include "search/grid_distance.h"
#include "search/route.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

using namespace search;

/// Searches everywhere for routes of other kinds. Two fields hold the cost of driving from each
/// pose to the goal, and from the start to each pose. Where both add up to little more than the
/// least cost, a way leads through. Ways of different kinds become routes of arcs and lines.
class Survey final : public Source {
 public:
  /// The task and the rule outlive the survey.
  Survey(const Task& task, const CostRule& rule);

  /// Works for some ten microseconds. True when a route was found: `route`.
  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override { return route_; }
  /// Sets the cost of the best route; much dearer ways are ignored. Must be called before `step`.
  void set_cutoff(double cost) override { cutoff_ = cost; }
  /// Number of passes done. The first one has the coarsest cells.
  [[nodiscard]] std::int64_t stage() const override { return static_cast<std::int64_t>(passes_); }
  [[nodiscard]] Counts counts() const override { return counts_of(forth_) += counts_of(back_); }

 private:
  /// Steps of a field from its root to one of its nodes.
  struct Branch {
    std::vector<DriveField::Node> nodes;
    std::vector<LocalPose> poses;  // exact poses: the root, and after each step
  };

  [[nodiscard]] bool prepare();
  void begin_pass();
  [[nodiscard]] bool meet(std::int32_t id);
  [[nodiscard]] bool go_back();
  void go_forth();
  [[nodiscard]] bool go_on();
  [[nodiscard]] bool lead_through(std::int32_t node);
  [[nodiscard]] static Branch branch(const DriveField& field, const LocalPose& root,
                                     std::int32_t node);
  [[nodiscard]] bool join(const Branch& head, const Branch& tail);
  [[nodiscard]] DrivenBeside driven_around(const Branch& head, std::size_t heads,
                                           const Branch& tail, std::size_t tails) const;
  void put_together(const Branch& head, std::size_t heads, const Piece& joint, const Branch& tail,
                    std::size_t tails);
  [[nodiscard]] bool is_free() const;
  [[nodiscard]] std::size_t bin_of(const LocalPose& pose, GearSign gear) const;
  void end();

  const Task& task_;
  Connector forth_, back_;  // steer from the start, and from the goal backwards
  Bounds box_;
  double cutoff_ = std::numeric_limits<double>::infinity();
  std::unique_ptr<GridDistance> guide_;
  std::unique_ptr<ClearanceRaster> raster_;
  bool is_prepared_ = false;
  std::size_t passes_ = 0;  // passes so far
  double most_ = 0.0;       // largest cost of a way in this pass [m]
  FieldOptions options_;    // cells of this pass
  Bounds cells_ = {};       // area that the cells cover, shifted in later passes
  std::unique_ptr<DriveField> from_goal_, from_start_;
  bool has_met_ = false;                 // whether the field from the goal has reached the start
  std::int64_t poses_ = 0;               // poses expanded by the field from the goal
  std::vector<bool> covered_;            // bins that routes of this pass lead through
  double bin_ = 1.0;                     // side of a bin [m]
  std::int64_t columns_ = 0, rows_ = 0;  // bins along x and y
  Kinds kinds_;
  Route route_;
};

}  // namespace vandplan::anytime
