// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do the planners share that grow trees, sample by sample?

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/random.h"
#include "vandplan/search.h"
#include "vandplan/vehicle.h"

namespace vandplan::planning {

/// A random state to reach, or the goal; its hitch angle is 0 without a trailer.
struct Sample {
  State state;
  bool is_goal;
};

/// Draws samples by the options "region" and "goal_bias", with the run's seed. Poses are uniform. A
/// hitch angle is the limit times the cube of a uniform number from -1 to 1. So half of the hitch
/// angles are below an eighth of the limit.
class Sampler {
 public:
  Sampler(const Task& task, const PlanOptions& options);
  /// The next sample, from the region of the options.
  Sample next() { return next(region_); }
  /// The next sample, from a box instead of the region.
  Sample next(const Bounds& box);

  [[nodiscard]] const Bounds& region() const { return region_; }
  [[nodiscard]] Rng& rng() { return rng_; }

 private:
  State goal_;
  double most_hitch_angle_;  // limit of hitch angles [rad]; 0 without a trailer
  Bounds region_;
  double goal_bias_;
  Rng rng_;
};

/// The edge from `from` to `to`. None if it is not free, or the cost at `to` is not below `cutoff`
/// [m]. `cost_so_far`: cost at `from` [m].
[[nodiscard]] std::optional<search::Connection> edge_between(
    search::Connector& connector, const LocalPose& from, const LocalPose& to,
    double cost_so_far = 0.0, double cutoff = std::numeric_limits<double>::infinity());

/// A pose on the way from `from` to `to`, about `range` metres along it; `to` if the way is
/// shorter. A continuous way is cut at its nearest place where it may be cut. None if there is no
/// way, or the cut leaves less than a tenth of `range`.
[[nodiscard]] std::optional<LocalPose> part_way(search::Connector& connector, const LocalPose& from,
                                                const LocalPose& to, double range);

/// Segments along poses, merged; `Connector::steer` joins each pose to the next.
[[nodiscard]] std::vector<Segment> segments_along(search::Connector& connector,
                                                  const std::vector<LocalPose>& poses);

/// Counters of a run: nodes, computed exact lengths, checked edges.
[[nodiscard]] std::vector<Counter> counters_of(std::size_t nodes, std::int64_t solves,
                                               std::int64_t checks);

// ---- Options ----

/// "goal_bias": share of samples that are the goal.
[[nodiscard]] OptionInfo goal_bias_option();
/// "max_nodes": size of the tree.
[[nodiscard]] OptionInfo max_nodes_option(std::int64_t default_value);
/// "try_goal": whether the goal is tried from every new node.
[[nodiscard]] OptionInfo try_goal_option(bool default_value);
/// "range": longest step towards a sample [turning radii].
[[nodiscard]] OptionInfo range_option(double default_value);
/// "keep_tree": whether the tree is part of the answer.
[[nodiscard]] OptionInfo keep_tree_option();
/// "profile": whether phases are measured.
[[nodiscard]] OptionInfo profile_option();

}  // namespace vandplan::planning
