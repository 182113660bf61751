// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which way does a site table know from a pose?

#include <optional>
#include <span>
#include <vector>

#include "sites/data.h"
#include "sites/tails.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/site_table.h"

namespace vandplan::sites {

/// The state of a pose of the scenario's frame, in the gear forward. It may lie outside of the
/// table.
[[nodiscard]] SiteState state_at(const SiteGrid& grid, const SiteLayer& layer,
                                 const Pose& pose) noexcept;

/// Number of the pose among some that is equal to a goal; none if there is no such one.
[[nodiscard]] std::optional<std::size_t> number_of(std::span<const Pose> poses, const Pose& goal);

/// Number of the goal of a table that is the task's; none if the table lacks it.
[[nodiscard]] std::optional<std::size_t> goal_in(const SiteTable& table, const Task& task);

/// Throws InputError naming "site" if a table does not hold for a task under complete options, or
/// lacks its goal. Sets of goals are not looked for.
void expect_serves(const SiteTable& table, const Task& task, const PlanOptions& options);

/// Finds ways of one layer to its goal from many starts.
class Ways {
 public:
  /// A way: a piece from the start, and a tail.
  struct Found {
    Piece piece = {};
    Tails::Id tail = Tails::none;
    double cost = 0.0;  ///< [m]
  };

  /// The goal of the task is that of the layer, its steering `reeds_shepp`. Its start counts only
  /// for ramps of the margin. Data, layer and task must outlive this.
  Ways(const SiteData& data, const SiteLayer& layer, const Task& task,
       const search::CostRule& rule);

  /// The cheapest free way that is found.
  [[nodiscard]] std::optional<Found> find(const LocalPose& start);
  [[nodiscard]] std::vector<Segment> segments(const Found& way) const;

 private:
  /// Tail that the way from a start may join.
  struct Joint {
    Tails::Id tail;
    double bound;  // Least cost by way of the tail, approximately [m].
  };

  void find_joints(const LocalPose& start);
  void follow(Tails::Id tail);
  void rank(const LocalPose& start);

  const SiteData& data_;
  const SiteLayer& layer_;
  const Task& task_;
  search::Connector connector_;
  Tails tails_;
  std::vector<Joint> joints_;
  std::vector<std::int32_t> met_by_;  // Number of the start that met each tail last.
  std::int32_t starts_ = 0;
  std::vector<float> x_, y_, heading_, lengths_;  // Poses of the joints, and how far they are.
};

/// The way from the start of a task to its goal, in the world's frame, of arcs and lines whatever
/// the task's steering. None also if the table lacks the goal. The table holds for the task under
/// these prices.
[[nodiscard]] std::optional<SiteWay> way_in_world(const SiteTable& table, const Task& task,
                                                  const CostOptions& cost);

}  // namespace vandplan::sites
