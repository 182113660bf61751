// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/ompl_spaces.h"

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Exception.h>

#include <cmath>

#include "ompl/curves.h"
#include "vandplan/input_error.h"

namespace vandplan::ompl {
namespace {

namespace ob = ::ompl::base;

/// Pose of a state in the frame of the world. Subtracting is faster than moving the decimal text,
/// and the rounding is as small as that of the state's numbers.
LocalPose local_pose(const ob::State* state, const Point& origin) noexcept {
  const Pose pose = pose_of(state);
  return Local(Pose{pose.x - origin.x, pose.y - origin.y, pose.heading});
}

/// The checker of a problem. Throws InputError for a trailer, which states say nothing of.
std::shared_ptr<const CollisionChecker> checker_of(const Problem& problem,
                                                   const ClearanceOptions& clearance) {
  if (problem.vehicle().trailer) {
    throw InputError("vehicle.trailers", "are not honoured by OMPL's planners, expected none");
  }
  return task_of(problem, clearance).checker;
}

/// Length of the piece that is known to be free [m].
double free_length(const CollisionChecker& checker, LocalPose pose, const Piece& piece) noexcept {
  constexpr double fine = 0.5e-6;  // Error of the result [m].
  double driven = 0.0;
  for (const Segment& segment : piece.view()) {
    const double length = std::abs(segment.length);
    if (checker.is_free(pose, segment)) {
      driven += length;
      pose = advance(pose, segment);
      continue;
    }
    double free = 0.0;
    double blocked = length;
    while (blocked - free > fine) {
      const double middle = free + (blocked - free) / 2;
      (checker.is_free(pose, part_of(segment, 0.0, middle)) ? free : blocked) = middle;
    }
    return driven + std::max(free - fine, 0.0);
  }
  return driven;
}

}  // namespace

StateValidityChecker::StateValidityChecker(const ob::SpaceInformationPtr& si,
                                           const Problem& problem,
                                           const ClearanceOptions& clearance)
    : ob::StateValidityChecker(si),
      problem_(problem),
      clearance_(clearance),
      checker_(checker_of(problem, clearance)) {
  specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
}

bool StateValidityChecker::isValid(const ob::State* state) const {
  return checker_->is_free(local_pose(state, problem_.world()->origin()));
}

double StateValidityChecker::clearance(const ob::State* state) const {
  constexpr double furthest = 1e7;  // [m]; larger than any world.
  return checker_->clearance(local_pose(state, problem_.world()->origin()), furthest);
}

MotionValidator::MotionValidator(const ob::SpaceInformationPtr& si, const Problem& problem,
                                 const ClearanceOptions& clearance)
    : ob::MotionValidator(si),
      curves_(std::make_unique<const Curves>(*si->getStateSpace())),
      origin_(problem.world()->origin()),
      checker_(checker_of(problem, clearance)) {
  if (curves_->radius() < problem.vehicle().min_turning_radius * (1 - 1e-9)) {
    throw ::ompl::Exception("vandplan", "the space turns more sharply than the vehicle can");
  }
}

MotionValidator::~MotionValidator() = default;

bool MotionValidator::checkMotion(const ob::State* from, const ob::State* to) const {
  const LocalPose start = local_pose(from, origin_);
  const Piece piece = curves_->piece(start, local_pose(to, origin_));
  const bool is_free = checker_->is_free(start, piece.view());
  ++(is_free ? valid_ : invalid_);
  return is_free;
}

bool MotionValidator::checkMotion(const ob::State* from, const ob::State* to,
                                  std::pair<ob::State*, double>& last_valid) const {
  if (checkMotion(from, to)) return true;
  const LocalPose start = local_pose(from, origin_);
  const Piece piece = curves_->piece(start, local_pose(to, origin_));
  last_valid.second =
      piece.length > 0.0 ? free_length(*checker_, start, piece) / piece.length : 0.0;
  if (last_valid.first != nullptr) {
    si_->getStateSpace()->interpolate(from, to, last_valid.second, last_valid.first);
  }
  return false;
}

void set_problem(::ompl::geometric::SimpleSetup& setup, const Problem& problem, Region region,
                 const ClearanceOptions& clearance) {
  const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
  const Bounds local = sampling_region(problem.task(), region);
  const Point& origin = problem.world()->origin();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0, local.x_min + origin.x);
  bounds.setHigh(0, local.x_max + origin.x);
  bounds.setLow(1, local.y_min + origin.y);
  bounds.setHigh(1, local.y_max + origin.y);
  setup.getStateSpace()->as<ob::SE2StateSpace>()->setBounds(bounds);
  setup.setStateValidityChecker(std::make_shared<StateValidityChecker>(si, problem, clearance));
  si->setMotionValidator(std::make_shared<MotionValidator>(si, problem, clearance));
  ob::ScopedState<> start(setup.getStateSpace());
  ob::ScopedState<> goal(setup.getStateSpace());
  set_pose(start.get(), problem.start());
  set_pose(goal.get(), problem.goal());
  setup.setStartAndGoalStates(start, goal);
}

}  // namespace vandplan::ompl
