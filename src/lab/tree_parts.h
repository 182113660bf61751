// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do planners share that grow trees, sample by sample?

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "vandplan/outcome.h"
#include "vandplan/plan_options.h"
#include "vandplan/random.h"
#include "vandplan/rig.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// A random state to reach, or the goal; its hitch angle is 0 without a trailer.
struct Sample {
  RigState state;
  bool is_goal;
};

/// Draws what the options "region" and "goal_bias" say, with the run's seed. Poses are drawn
/// evenly; hitch angles are the limit times the cube of an even number from -1 to 1: half of them
/// are below an eighth of the limit.
class Sampler {
 public:
  Sampler(const Task& task, const PlanOptions& options);
  Sample next() { return next(region_); }
  /// From a box instead of the region.
  Sample next(const Bounds& box);

  [[nodiscard]] const Bounds& region() const { return region_; }
  [[nodiscard]] Rng& rng() { return rng_; }

 private:
  RigState goal_;
  double most_hitch_angle_;  // 0 without a trailer
  Bounds region_;
  double goal_bias_;
  Rng rng_;
};

/// The edge between two poses, the first of which costs `cost_so_far` [m], if it is free and
/// reaches the second below the cutoff of cost.
[[nodiscard]] std::optional<search::Connection> edge_between(
    search::Connector& connector, const LocalPose& from, const LocalPose& to,
    double cost_so_far = 0.0, double cutoff = std::numeric_limits<double>::infinity());

/// A pose on the way from one to another, `range` metres along it or as near to that as the way may
/// be cut; none where that is hardly anywhere. The other pose itself if it is nearer.
[[nodiscard]] std::optional<LocalPose> part_way(search::Connector& connector, const LocalPose& from,
                                                const LocalPose& to, double range);

/// The segments along poses, joined as `Connector::steer` joins them.
[[nodiscard]] std::vector<Segment> segments_along(search::Connector& connector,
                                                  const std::vector<LocalPose>& poses);

/// What was counted in a run: nodes, exact lengths worked out, edges checked.
[[nodiscard]] std::vector<Counter> counters_of(std::size_t nodes, std::int64_t solves,
                                               std::int64_t checks);

// ---- Options ----

/// "goal_bias": share of samples that are the goal.
[[nodiscard]] OptionInfo goal_bias_option();
/// "max_nodes": size of the tree.
[[nodiscard]] OptionInfo max_nodes_option(std::int64_t standard);
/// "try_goal": whether the goal is tried from every new node.
[[nodiscard]] OptionInfo try_goal_option(bool standard);
/// "range": how long a step towards a sample may be [turning radii].
[[nodiscard]] OptionInfo range_option(double standard);
/// "keep_tree": whether the tree is part of the answer.
[[nodiscard]] OptionInfo keep_tree_option();
/// "profile": whether phases are measured.
[[nodiscard]] OptionInfo profile_option();

}  // namespace vandplan::planning
