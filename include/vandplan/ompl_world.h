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

/// Validity of states for the vehicle of a problem. At a valid state the vehicle is clear of all
/// obstacles, by a margin if there is one. Its rear axle is in the bounds of the scenario. The
/// bounds of the space do not count; samples are drawn in them.
class StateValidityChecker : public ::ompl::base::StateValidityChecker {
 public:
  /// A checker for a problem and a margin. Throws InputError naming "margin" or "margin_ramp" if it
  /// is out of range, "vehicle.trailers" if there is a trailer, as states have no hitch angle.
  StateValidityChecker(const ::ompl::base::SpaceInformationPtr& si, const Problem& problem,
                       const ClearanceOptions& clearance = {});

  /// Whether the vehicle is free at the state.
  bool isValid(const ::ompl::base::State* state) const override;

  /// Least distance of the body from obstacles, and of the wheels from kerbs [m]; 0 if they touch.
  double clearance(const ::ompl::base::State* state) const override;

  [[nodiscard]] const Problem& problem() const noexcept { return problem_; }
  [[nodiscard]] const ClearanceOptions& clearance_options() const noexcept { return clearance_; }

 private:
  Problem problem_;
  ClearanceOptions clearance_;
  std::shared_ptr<const CollisionChecker> checker_;
};

/// Validity of motions for the vehicle of a problem. A motion is valid if the vehicle is free
/// everywhere on the shortest path between its states: exact, without a step size. The space is a
/// Reeds-Shepp or Dubins space, ours or OMPL's.
class MotionValidator : public ::ompl::base::MotionValidator {
 public:
  /// A validator for a problem and a margin. Throws ompl::Exception for another space, or one that
  /// turns more sharply than the vehicle can, and InputError as `StateValidityChecker` does.
  MotionValidator(const ::ompl::base::SpaceInformationPtr& si, const Problem& problem,
                  const ClearanceOptions& clearance = {});
  ~MotionValidator() override;

  /// Whether the vehicle is free on the shortest path between the states.
  bool checkMotion(const ::ompl::base::State* from, const ::ompl::base::State* to) const override;

  /// Whether the vehicle is free on the shortest path between the states. If not, `last_valid` gets
  /// a state before the first contact and its share of the path. It lies less than a micrometre
  /// before the place up to which the path is known to be free.
  bool checkMotion(const ::ompl::base::State* from, const ::ompl::base::State* to,
                   std::pair<::ompl::base::State*, double>& last_valid) const override;

 private:
  std::unique_ptr<const Curves> curves_;
  Point origin_;  // origin of the world in the scenario's frame [m]
  std::shared_ptr<const CollisionChecker> checker_;
};

/// Gives a set-up over a Reeds-Shepp or Dubins space what a problem needs: validity checker, motion
/// validator, start and goal. The bounds of `region` become the bounds of the space.
void set_problem(::ompl::geometric::SimpleSetup& setup, const Problem& problem,
                 Region region = Region::bounds, const ClearanceOptions& clearance = {});

}  // namespace vandplan::ompl
