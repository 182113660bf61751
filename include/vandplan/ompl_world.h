// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do OMPL's planners check poses and edges exactly?
//
// States are in the scenario's frame.

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include <memory>
#include <utility>

#include "vandplan/problem.h"

namespace ompl::geometric {
class SimpleSetup;
}

namespace vandplan::ompl {

class Curves;

/// Whether the vehicle of a problem is free at a state: clear of everything, by a margin if there
/// is one, with its rear axle in the bounds of the scenario. The bounds of the space are where
/// samples are drawn and do not count.
class StateValidityChecker : public ::ompl::base::StateValidityChecker {
 public:
  StateValidityChecker(const ::ompl::base::SpaceInformationPtr& si, const Problem& problem,
                       const ClearanceOptions& clearance = {});

  bool isValid(const ::ompl::base::State* state) const override;

  /// The distance of the body from the nearest thing, of the wheels from kerbs [m].
  double clearance(const ::ompl::base::State* state) const override;

  [[nodiscard]] const Problem& problem() const noexcept { return problem_; }
  [[nodiscard]] const ClearanceOptions& clearance_options() const noexcept { return clearance_; }

 private:
  Problem problem_;
  ClearanceOptions clearance_;
  std::shared_ptr<const CollisionChecker> checker_;
};

/// Whether the vehicle of a problem is free everywhere on the shortest path between two states:
/// exact, without a step size. The space is a Reeds-Shepp or Dubins space, ours or OMPL's.
class MotionValidator : public ::ompl::base::MotionValidator {
 public:
  /// Throws ompl::Exception for another space, or one that turns more sharply than the vehicle can.
  MotionValidator(const ::ompl::base::SpaceInformationPtr& si, const Problem& problem,
                  const ClearanceOptions& clearance = {});
  ~MotionValidator() override;

  bool checkMotion(const ::ompl::base::State* from, const ::ompl::base::State* to) const override;

  /// On the way to the first contact `last_valid` is free: less than a micrometre before the place
  /// up to which the way is known to be free.
  bool checkMotion(const ::ompl::base::State* from, const ::ompl::base::State* to,
                   std::pair<::ompl::base::State*, double>& last_valid) const override;

 private:
  std::unique_ptr<const Curves> curves_;
  Point origin_;  // of the world in the scenario's frame [m]
  std::shared_ptr<const CollisionChecker> checker_;
};

/// Gives a set-up over a Reeds-Shepp or Dubins space the validity checker, the motion validator,
/// start and goal of a problem, and the bounds of the space: those of the region.
void set_problem(::ompl::geometric::SimpleSetup& setup, const Problem& problem,
                 Region region = Region::bounds, const ClearanceOptions& clearance = {});

}  // namespace vandplan::ompl
