// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does OMPL steer, check and plan with this library?

#include <ompl/base/MotionValidator.h>
#include <ompl/base/Planner.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace ompl::geometric {
class SimpleSetup;
}

namespace vandplan::ompl {

// ---- How do OMPL's planners steer as ours do? ----
//
// These spaces take the place of OMPL's spaces of the same names. Distances and states are equal,
// and are computed faster. docs/ompl.md says what is equal. The owner of a space chooses the frame
// of its states.

/// The pose of a state of SE(2), in the frame of the state.
[[nodiscard]] Pose pose_of(const ::ompl::base::State* state) noexcept;

/// Sets a state of SE(2) to that pose, in the frame of the state. Its heading is wrapped into
/// [-pi, pi).
void set_pose(::ompl::base::State* state, const Pose& pose) noexcept;

/// Space of poses whose distance is the length of the shortest path driven in both gears.
class ReedsSheppStateSpace : public ::ompl::base::ReedsSheppStateSpace {
 public:
  using State = ::ompl::base::State;

  /// A space for a turning radius > 0 [m].
  explicit ReedsSheppStateSpace(double turning_radius = 1.0);

  /// The turning radius [m].
  [[nodiscard]] double turning_radius() const { return rho_; }

  /// A new state whose numbers lie in one block of memory: an SE2StateSpace::StateType like any
  /// other.
  State* allocState() const override;
  void freeState(State* state) const override;

  /// Length of the shortest path [m], `reeds_shepp_length` of the poses.
  double distance(const State* from, const State* to) const override;

  /// Sets `state` to the state at the share `t` of the shortest path; 0 is `from`, 1 is `to`.
  void interpolate(const State* from, const State* to, double t, State* state) const override;

  /// Sets `state` to the state at the share `t` of the shortest path. The first call finds the path
  /// and keeps it in `path`, so that it is found once for many `t`.
  void interpolate(const State* from, const State* to, double t, bool& first_time,
                   ReedsSheppPath& path, State* state) const override;

  /// The shortest path in OMPL's form: lengths in turning radii.
  [[nodiscard]] ReedsSheppPath reedsShepp(const State* from, const State* to) const;

 protected:
  void interpolate(const State* from, const ReedsSheppPath& path, double t,
                   State* state) const override;
};

/// Space of poses whose distance is the length of the shortest path driven forward. If the space is
/// symmetric, it is the shorter one of the paths there and back, and the path back is driven in
/// reverse.
class DubinsStateSpace : public ::ompl::base::DubinsStateSpace {
 public:
  using State = ::ompl::base::State;

  /// A space for a turning radius > 0 [m].
  explicit DubinsStateSpace(double turning_radius = 1.0, bool is_symmetric = false);

  /// The turning radius [m].
  [[nodiscard]] double turning_radius() const { return rho_; }

  /// A new state whose numbers lie in one block of memory: an SE2StateSpace::StateType like any
  /// other.
  State* allocState() const override;
  void freeState(State* state) const override;

  /// Length of the shortest path [m], `dubins_length` of the poses.
  double distance(const State* from, const State* to) const override;

  /// Sets `state` to the state at the share `t` of the shortest path; 0 is `from`, 1 is `to`.
  void interpolate(const State* from, const State* to, double t, State* state) const override;

  /// Sets `state` to the state at the share `t` of the shortest path. The first call finds the path
  /// and keeps it in `path`, so that it is found once for many `t`.
  void interpolate(const State* from, const State* to, double t, bool& first_time, DubinsPath& path,
                   State* state) const override;

  /// The shortest path in OMPL's form: lengths in turning radii.
  [[nodiscard]] DubinsPath dubins(const State* from, const State* to) const;

 protected:
  void interpolate(const State* from, const DubinsPath& path, double t,
                   State* state) const override;
};

/// The Reeds-Shepp space of this library that `ask` uses to measure the distance of a state from
/// itself; null if it uses none.
[[nodiscard]] const ReedsSheppStateSpace* space_behind(const std::function<void()>& ask);

}  // namespace vandplan::ompl

// With `namespace ob = vandplan::ompl::base;` in place of `namespace ob = ompl::base;` the spaces
// of a program are ours, and every other name is OMPL's.
namespace vandplan::ompl::base {
using namespace ::ompl::base;
using ompl::DubinsStateSpace;
using ompl::ReedsSheppStateSpace;
}  // namespace vandplan::ompl::base

namespace vandplan::ompl {

// ---- How do OMPL's planners check poses and edges exactly? ----
//
// States are in the scenario's frame.

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

// ---- How does OMPL run the planners of this library? ----

/// One of our planners, or yours, as a planner of OMPL.
///
/// The space must be a Reeds-Shepp space, and the validity checker ours: it gives the world, the
/// vehicle and the margin. Start and goal are those of the problem definition; with several, the
/// first valid ones. Every call of `solve` begins anew.
///
/// The planner ends when `options.budget` is spent or the termination condition holds. A thread of
/// its own asks the condition about every millisecond.
class Planner : public ::ompl::base::Planner {
 public:
  /// The planner of that name, with its defaults, planning by length. Throws InputError naming
  /// "planner" for an unknown name.
  explicit Planner(const ::ompl::base::SpaceInformationPtr& si,
                   const std::string& name = "anytime");
  /// A planner with options. If the cost is not the length, OMPL still compares lengths. Throws
  /// InputError naming an option that the planner does not honour, or "steering" for a steering
  /// other than `reeds_shepp`.
  Planner(const ::ompl::base::SpaceInformationPtr& si, vandplan::Planner planner,
          const PlanOptions& options);
  ~Planner() override;

  /// Checks space and validity checker. Throws ompl::Exception if they do not fit.
  void setup() override;
  ::ompl::base::PlannerStatus solve(const ::ompl::base::PlannerTerminationCondition& ptc) override;
  void clear() override;
  /// Gives the search tree, if the planner was asked to keep it (`keep_tree`), or the path.
  void getPlannerData(::ompl::base::PlannerData& data) const override;

  /// Result of the last call of `solve`, which has the exact path, in the frame of the states.
  [[nodiscard]] const std::optional<PlanResult>& result() const noexcept { return result_; }

 private:
  void declare_options();
  void keep_nodes(const std::vector<Pose>& path);
  ::ompl::base::PlannerStatus report(const Problem& problem);

  vandplan::Planner planner_;
  PlanOptions options_;
  std::optional<PlanResult> result_ = {};
  std::vector<::ompl::base::ScopedState<>> nodes_ = {};  // nodes of `getPlannerData`
  std::vector<std::int32_t> parents_ = {};
};

/// Poses from the start of a path to its end, in its frame. The shortest paths from each pose to
/// the next are the path itself: arcs are cut into quarter turns. The segments must be arcs and
/// lines.
[[nodiscard]] std::vector<Pose> way_points(const Path& path);

}  // namespace vandplan::ompl
