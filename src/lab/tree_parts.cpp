// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/tree_parts.h"

#include "lab/estimate_options.h"

namespace vandplan::planning {

using namespace search;

namespace {

constexpr double least_part = 0.1;  // least length of a cut way [ranges]

}  // namespace

Sampler::Sampler(const Task& task, const PlanOptions& options)
    : goal_(goal_state(task)),
      most_hitch_angle_(task.vehicle.trailer ? task.vehicle.max_hitch_angle : 0.0),
      region_(sampling_region(task, region_of(options))),
      goal_bias_(options.planner.number("goal_bias")),
      rng_(options.budget.seed) {}

Sample Sampler::next(const Bounds& box) {
  if (uniform01(rng_) < goal_bias_) return {goal_, true};
  State state{uniform_pose(box, rng_)};
  if (most_hitch_angle_ > 0.0) {
    const double share = uniform(-1.0, 1.0, rng_);
    state.hitch_angle = most_hitch_angle_ * share * share * share;
  }
  return {state, false};
}

std::optional<Connection> edge_between(Connector& connector, const LocalPose& from,
                                       const LocalPose& to, double cost_so_far, double cutoff) {
  // Each edge is steered again at the end of a run. Where a piece is chosen among several words, a
  // cutoff could change the choice, so there is none.
  const bool is_shortest = connector.continuous() == nullptr && connector.rule().is_length();
  const double limit = is_shortest ? cutoff : std::numeric_limits<double>::infinity();
  std::optional<Connection> edge = connector.connect(from, to, {cost_so_far, limit, {}});
  if (edge && edge->cost >= cutoff) edge.reset();
  return edge;
}

std::optional<LocalPose> part_way(Connector& connector, const LocalPose& from, const LocalPose& to,
                                  double range) {
  const std::optional<Piece> piece = connector.steer(from, to);
  if (!piece) return std::nullopt;
  if (piece->length <= range) return to;
  if (connector.continuous() == nullptr) return end_of(from, prefix(*piece, range));
  const double cut = nearest_cut(*piece, range, connector.radius());
  if (cut < least_part * range) return std::nullopt;
  return cut >= piece->length ? to : end_of(from, prefix(*piece, cut));
}

std::vector<Segment> segments_along(Connector& connector, const std::vector<LocalPose>& poses) {
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const std::optional<Piece> piece = connector.steer(poses[i - 1], poses[i]);
    segments.insert(segments.end(), piece->view().begin(), piece->view().end());
  }
  return merged(segments);
}

std::vector<Counter> counters_of(std::size_t nodes, std::int64_t solves, std::int64_t checks) {
  return {{"nodes", static_cast<std::int64_t>(nodes)},
          {"exact_solves", solves},
          {"edge_checks", checks}};
}

OptionInfo goal_bias_option() {
  return {.name = "goal_bias",
          .summary = "share of samples that are the goal",
          .default_value = 0.05,
          .least = 0,
          .most = 1};
}

OptionInfo max_nodes_option(std::int64_t default_value) {
  return {.name = "max_nodes",
          .summary = "largest search tree [nodes]",
          .default_value = default_value,
          .least = 1,
          .most = 10'000'000};
}

OptionInfo try_goal_option(bool default_value) {
  return {.name = "try_goal",
          .summary = "try the goal from every new node",
          .default_value = default_value};
}

OptionInfo range_option(double default_value) {
  return {.name = "range",
          .summary = "longest step towards a sample [turning radii]",
          .default_value = default_value,
          .least = 0.1,
          .most = 1e6};
}

OptionInfo keep_tree_option() {
  return {.name = "keep_tree", .summary = "return the search tree", .default_value = false};
}

OptionInfo profile_option() {
  return {.name = "profile", .summary = "measure time per phase", .default_value = false};
}

}  // namespace vandplan::planning
