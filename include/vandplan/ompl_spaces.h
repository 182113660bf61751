// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do OMPL's planners steer as ours do?
//
// These spaces take the place of OMPL's spaces of the same names. Distances and states are equal,
// and are computed faster. docs/ompl.md says what is equal. The owner of a space chooses the frame
// of its states.

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <functional>

#include "vandplan/path.h"

namespace vandplan::ompl {

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
