// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does OMPL see our poses?

#include <ompl/base/ScopedState.h>

#include <memory>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// Poses as states of one of OMPL's spaces of curves with that turning radius [m].
template <typename Space>
class OmplPoses {
 public:
  explicit OmplPoses(double radius) : space_(std::make_shared<Space>(radius)) {}

  void add(const Pose& pose) {
    auto& state = states_.emplace_back(space_);
    state->setXY(pose.x, pose.y);
    state->setYaw(pose.heading);
  }

  [[nodiscard]] const ompl::base::State* operator[](std::size_t i) const {
    return states_[i].get();
  }

  /// Of two states of equal spaces [m].
  [[nodiscard]] double distance(const ompl::base::State* from, const ompl::base::State* to) const {
    return space_->distance(from, to);
  }

 private:
  ompl::base::StateSpacePtr space_;
  std::vector<ompl::base::ScopedState<Space>> states_;
};

}  // namespace vandplan
