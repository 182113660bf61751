// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do OMPL's planners steer as ours do?
//
// Spaces that take the place of OMPL's of the same names: equal distances and states, sooner.
// docs/ompl.md says what is equal. States are in the frame of whoever owns the space.

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <functional>

#include "vandplan/path.h"

namespace vandplan::ompl {

/// The pose of a state of SE(2), in the frame of the state.
[[nodiscard]] Pose pose_of(const ::ompl::base::State* state) noexcept;

/// Makes a state of SE(2) that pose; its heading gets into [-pi, pi).
void set_pose(::ompl::base::State* state, const Pose& pose) noexcept;

/// Poses at the distance of the shortest path that a vehicle can drive in both gears.
class ReedsSheppStateSpace : public ::ompl::base::ReedsSheppStateSpace {
 public:
  using State = ::ompl::base::State;

  /// For a turning radius > 0 [m].
  explicit ReedsSheppStateSpace(double turning_radius = 1.0);

  /// The turning radius [m].
  [[nodiscard]] double turning_radius() const { return rho_; }

  /// A state whose numbers lie in one block of memory: SE2StateSpace::StateType like any other.
  State* allocState() const override;
  void freeState(State* state) const override;

  /// The length of the shortest path [m], `reeds_shepp_length` of the poses.
  double distance(const State* from, const State* to) const override;

  /// Makes `state` the one at the share `t` of the shortest path; 0 is `from`, 1 is `to`.
  void interpolate(const State* from, const State* to, double t, State* state) const override;

  /// Keeps the path from the first call on, so that it is found once for many `t`.
  void interpolate(const State* from, const State* to, double t, bool& first_time,
                   ReedsSheppPath& path, State* state) const override;

  /// The shortest path as OMPL writes it down: lengths in turning radii.
  [[nodiscard]] ReedsSheppPath reedsShepp(const State* from, const State* to) const;

 protected:
  void interpolate(const State* from, const ReedsSheppPath& path, double t,
                   State* state) const override;
};

/// Poses at the distance of the shortest path that a vehicle can drive forward. Symmetric: of the
/// shorter one of the paths there and back, which is then driven in reverse.
class DubinsStateSpace : public ::ompl::base::DubinsStateSpace {
 public:
  using State = ::ompl::base::State;

  /// For a turning radius > 0 [m].
  explicit DubinsStateSpace(double turning_radius = 1.0, bool is_symmetric = false);

  /// The turning radius [m].
  [[nodiscard]] double turning_radius() const { return rho_; }

  /// A state whose numbers lie in one block of memory: SE2StateSpace::StateType like any other.
  State* allocState() const override;
  void freeState(State* state) const override;

  /// The length of the shortest path [m], `dubins_length` of the poses.
  double distance(const State* from, const State* to) const override;

  /// Makes `state` the one at the share `t` of the shortest path; 0 is `from`, 1 is `to`.
  void interpolate(const State* from, const State* to, double t, State* state) const override;

  /// Keeps the path from the first call on, so that it is found once for many `t`.
  void interpolate(const State* from, const State* to, double t, bool& first_time, DubinsPath& path,
                   State* state) const override;

  /// The shortest path as OMPL writes it down: lengths in turning radii.
  [[nodiscard]] DubinsPath dubins(const State* from, const State* to) const;

 protected:
  void interpolate(const State* from, const DubinsPath& path, double t,
                   State* state) const override;
};

/// The Reeds-Shepp space of this library that `ask` calls to measure the distance of a state from
/// itself; null if it calls none.
[[nodiscard]] const ReedsSheppStateSpace* space_behind(const std::function<void()>& ask);

}  // namespace vandplan::ompl

// With `namespace ob = vandplan::ompl::base;` in place of `namespace ob = ompl::base;` the spaces
// of a program are ours and everything else of that name is OMPL's.
namespace vandplan::ompl::base {
using namespace ::ompl::base;
using ompl::DubinsStateSpace;
using ompl::ReedsSheppStateSpace;
}  // namespace vandplan::ompl::base
