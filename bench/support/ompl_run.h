// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does OMPL plan for a problem of ours, with an ordinary checker or with ours?

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "vandplan/judge.h"
#include "vandplan/ompl_spaces.h"
#include "vandplan/steering.h"

namespace vandplan {

inline constexpr double check_distance = 0.1;  // [m] between two tests of the ordinary checker

// ---- the ordinary checker: sides of footprint and polygon cross, or one holds the other ----

inline double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline bool sides_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return cross(a, b, c) * cross(a, b, d) <= 0 && cross(c, d, a) * cross(c, d, b) <= 0;
}

template <typename Corners>
bool holds(const Corners& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point& a = polygon[i];
    const Point& b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
      inside = !inside;
    }
  }
  return inside;
}

inline bool overlap(const std::array<Point, 4>& body, const Polygon& polygon) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < polygon.size(); ++j) {
      const Point& next = polygon[(j + 1) % polygon.size()];
      if (sides_cross(body[i], body[(i + 1) % 4], polygon[j], next)) return true;
    }
  }
  return holds(polygon, body[0]) || holds(body, polygon[0]);
}

class SampledChecker : public ::ompl::base::StateValidityChecker {
 public:
  SampledChecker(const ::ompl::base::SpaceInformationPtr& si, const Problem& problem)
      : StateValidityChecker(si), body_(footprint(problem.vehicle())) {
    const Point& origin = problem.world()->origin();
    for (Polygon polygon : problem.world()->local().obstacles) {
      for (Point& corner : polygon) corner = {corner.x + origin.x, corner.y + origin.y};
      obstacles_.push_back({polygon, bounding_box(polygon)});
    }
  }
  bool isValid(const ::ompl::base::State* state) const override {
    if (!si_->satisfiesBounds(state)) return false;
    const std::array<Point, 4> body = corners(body_, ompl::pose_of(state));
    const Bounds box = bounding_box(body);
    return std::none_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& o) {
      const bool apart = o.box.x_min > box.x_max || o.box.x_max < box.x_min ||
                         o.box.y_min > box.y_max || o.box.y_max < box.y_min;
      return !apart && overlap(body, o.polygon);
    });
  }

 private:
  struct Obstacle {
    Polygon polygon;
    Bounds box;
  };
  Footprint body_;
  std::vector<Obstacle> obstacles_;
};

// ---- a query ----

/// Sets up a run that minimises the length, with our checkers or with the ordinary one and OMPL's
/// way to check edges.
inline void set_up(::ompl::geometric::SimpleSetup& setup, const Problem& problem, Region region,
                   bool our_checkers) {
  namespace ob = ::ompl::base;
  const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
  const ob::MotionValidatorPtr usual = si->getMotionValidator();
  ompl::set_problem(setup, problem, region);
  if (!our_checkers) {
    setup.setStateValidityChecker(std::make_shared<SampledChecker>(si, problem));
    si->setMotionValidator(usual);
  }
  const ob::StateSpacePtr& space = setup.getStateSpace();
  si->setStateValidityCheckingResolution(check_distance / space->getMaximumExtent());
  setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
}

/// The path that joins OMPL's states.
inline Path path_of(const ::ompl::geometric::PathGeometric& found, const Problem& problem) {
  Path path{problem.start(), {}};
  for (unsigned i = 1; i < found.getStateCount(); ++i) {
    const Piece piece =
        reeds_shepp(ompl::pose_of(found.getState(i - 1)), ompl::pose_of(found.getState(i)),
                    problem.vehicle().min_turning_radius);
    path.segments.insert(path.segments.end(), piece.view().begin(), piece.view().end());
  }
  return path;
}

}  // namespace vandplan
