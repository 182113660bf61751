// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ompl/curves.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/util/Exception.h>

#include <cmath>
#include <numbers>

#include "vandplan/ompl_spaces.h"
#include "vandplan/steering.h"

namespace vandplan::ompl {
namespace {

namespace ob = ::ompl::base;

/// Turning radius, measured by the length of turning round on the spot, which is proportional to
/// it.
double measured_radius(const ob::StateSpace& space, double length_at_radius_one) {
  ob::State* const from = space.allocState();
  ob::State* const to = space.allocState();
  set_pose(from, {});
  set_pose(to, {0, 0, -std::numbers::pi});
  const double length = space.distance(from, to);
  space.freeState(from);
  space.freeState(to);
  return length / length_at_radius_one;
}

}  // namespace

bool is_shorter_back(const Pose& from, const Pose& to, double radius) noexcept {
  return dubins_length(to, from, radius) < dubins_length(from, to, radius);
}

Piece symmetric_dubins(const Pose& from, const Pose& to, double radius) noexcept {
  return is_shorter_back(from, to, radius) ? reversed(dubins(to, from, radius))
                                           : dubins(from, to, radius);
}

Curves::Curves(const ob::StateSpace& space) {
  const Pose round{0, 0, -std::numbers::pi};
  if (dynamic_cast<const ob::ReedsSheppStateSpace*>(&space) != nullptr) {
    kind_ = Kind::reeds_shepp;
    const auto* const ours = dynamic_cast<const ReedsSheppStateSpace*>(&space);
    radius_ = ours != nullptr ? ours->turning_radius()
                              : measured_radius(space, reeds_shepp_length({}, round, 1.0));
  } else if (dynamic_cast<const ob::DubinsStateSpace*>(&space) != nullptr) {
    kind_ = space.hasSymmetricDistance() ? Kind::symmetric_dubins : Kind::dubins;
    const auto* const ours = dynamic_cast<const DubinsStateSpace*>(&space);
    radius_ = ours != nullptr ? ours->turning_radius()
                              : measured_radius(space, dubins_length({}, round, 1.0));
  } else {
    throw ::ompl::Exception("vandplan", "needs a Reeds-Shepp or Dubins state space");
  }
}

Piece Curves::piece(const Pose& from, const Pose& to) const noexcept {
  switch (kind_) {
    case Kind::reeds_shepp:
      return reeds_shepp(from, to, radius_);
    case Kind::dubins:
      return dubins(from, to, radius_);
    case Kind::symmetric_dubins:
      break;
  }
  return symmetric_dubins(from, to, radius_);
}

}  // namespace vandplan::ompl
