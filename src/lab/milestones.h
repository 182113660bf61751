// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which free poses does a roadmap have, and which of them are near to each other?

#include <cstdint>
#include <memory>
#include <vector>

#include "vandplan/nearest.h"
#include "vandplan/problem.h"
#include "vandplan/random.h"

namespace vandplan::search {

/// What says which poses are drawn and joined.
struct MilestoneOptions {
  Local<Bounds> region = {};  ///< where poses are drawn, in the frame of the world [m]
  int neighbours = 1;         ///< older ones that each is joined to; >= 1
  std::uint64_t seed = 1;
  bool operator==(const MilestoneOptions&) const = default;
};

/// A roadmap that grows. The first n samples are always the same, whatever comes after them, and so
/// are the milestones that they become and the edges between these.
class Milestones {
 public:
  /// None yet, for a vehicle by its checker and its turning radius [m].
  Milestones(std::shared_ptr<const CollisionChecker> checker, double radius,
             const MilestoneOptions& options);

  /// Draws one pose. If it is free it becomes a milestone and is joined to the nearest older ones
  /// by exact length.
  void sample();

  [[nodiscard]] const std::shared_ptr<const CollisionChecker>& checker() const { return checker_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] const MilestoneOptions& options() const { return options_; }
  [[nodiscard]] std::int64_t samples() const { return samples_; }
  [[nodiscard]] std::size_t size() const { return poses_.size(); }
  [[nodiscard]] const std::vector<LocalPose>& poses() const { return poses_; }
  /// To older ones: those of the first milestone, of the second one, ...
  [[nodiscard]] const std::vector<NearNode>& edges() const { return edges_; }
  /// Where those of each milestone begin, and where the last ones end.
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
