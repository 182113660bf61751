// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which free poses does a roadmap have, and which of them are near to each other?

#include <cstdint>
#include <memory>
#include <vector>

#include "vandplan/problem.h"
#include "vandplan/random.h"
#include "vandplan/tables.h"

namespace vandplan::search {

/// Settings that decide which poses are drawn and joined.
struct MilestoneOptions {
  Local<Bounds> region = {};  ///< region of the poses, in the frame of the world [m]
  int neighbours = 1;         ///< older milestones that each one is joined to; >= 1
  std::uint64_t seed = 1;     ///< seed of the random poses
  bool operator==(const MilestoneOptions&) const = default;
};

/// A growing roadmap. Its first n samples are always the same, and so are their milestones and the
/// edges between them.
class Milestones {
 public:
  /// A roadmap without milestones, for a vehicle with that checker and turning radius [m].
  Milestones(std::shared_ptr<const CollisionChecker> checker, double radius,
             const MilestoneOptions& options);

  /// Draws one pose. A free pose becomes a milestone, and is joined to the milestones that are
  /// nearest by exact length.
  void sample();

  [[nodiscard]] const std::shared_ptr<const CollisionChecker>& checker() const { return checker_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] const MilestoneOptions& options() const { return options_; }
  /// Number of drawn poses, free or not.
  [[nodiscard]] std::int64_t samples() const { return samples_; }
  [[nodiscard]] std::size_t size() const { return poses_.size(); }
  [[nodiscard]] const std::vector<LocalPose>& poses() const { return poses_; }
  /// Edges from each milestone to older ones, in the order of the milestones.
  [[nodiscard]] const std::vector<NearNode>& edges() const { return edges_; }
  /// Position in `edges` of the first edge of each milestone, then the number of edges.
  [[nodiscard]] const std::vector<std::int32_t>& first_edge() const { return first_edge_; }
  [[nodiscard]] const NearestNodes& nearest() const { return nearest_; }

 private:
  std::shared_ptr<const CollisionChecker> checker_;
  double radius_;
  MilestoneOptions options_;
  Rng rng_;
  std::int64_t samples_ = 0;
  std::vector<LocalPose> poses_;
  std::vector<NearNode> edges_;
  std::vector<std::int32_t> first_edge_ = {0};
  NearestNodes nearest_;
};

}  // namespace vandplan::search
