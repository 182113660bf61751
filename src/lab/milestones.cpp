// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/milestones.h"

#include <utility>

namespace vandplan::search {

Milestones::Milestones(std::shared_ptr<const CollisionChecker> checker, double radius,
                       const MilestoneOptions& options)
    : checker_(std::move(checker)),
      radius_(radius),
      options_(options),
      rng_(options.seed),
      nearest_(radius) {}

void Milestones::sample() {
  const LocalPose pose = uniform_pose(options_.region, rng_);
  ++samples_;
  if (!checker_->is_free(pose)) return;
  const NearWanted wanted{.count = static_cast<std::size_t>(options_.neighbours)};
  const std::vector<NearNode> near = nearest_.nearest(pose, wanted);
  edges_.insert(edges_.end(), near.begin(), near.end());
  first_edge_.push_back(static_cast<std::int32_t>(edges_.size()));
  poses_.push_back(pose);
  nearest_.add(pose);
}

}  // namespace vandplan::search
