// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a test ask OMPL for a path?

#include <gtest/gtest.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <memory>
#include <utility>

#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/ompl_spaces.h"
#include "vandplan/steering.h"

namespace vandplan {

namespace ob = ::ompl::base;
namespace og = ::ompl::geometric;

inline constexpr double query_radius = 7;  // [m]

/// A wall between start and goal; whole metres away from the origin if somebody wants that.
inline Scenario yard_scenario(double dx = 0, double dy = 0) {
  Scenario scenario;
  scenario.bounds = {-50, 50, -50, 50};
  scenario.goal = {20, 5, 0};
  scenario.obstacles = {box(12, -9, 13, 9)};
  return moved_by(scenario, dx, dy);
}

/// A problem for OMPL: over our Reeds-Shepp space, if no other one is given.
struct Query {
  Problem problem;
  ob::StateSpacePtr space;
  og::SimpleSetup simple;
  ob::SpaceInformationPtr si;

  explicit Query(const Scenario& scenario, ob::StateSpacePtr of = nullptr,
                 const ClearanceOptions& clearance = {})
      : problem(make_problem(scenario)),
        space(of ? std::move(of) : std::make_shared<ompl::ReedsSheppStateSpace>(query_radius)),
        simple(space),
        si(simple.getSpaceInformation()) {
    ::ompl::msg::setLogLevel(::ompl::msg::LOG_NONE);
    ::ompl::RNG::setSeed(1);
    ompl::set_problem(simple, problem, Region::scene, clearance);
    simple.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
  }

  ob::ScopedState<> state(const Pose& pose) {
    ob::ScopedState<> made(space);
    ompl::set_pose(made.get(), pose);
    return made;
  }
};

/// The path of OMPL's states, joined by the shortest paths.
inline Path path_of(og::PathGeometric& found, const Problem& problem) {
  Path path{problem.start(), {}};
  for (unsigned i = 1; i < found.getStateCount(); ++i) {
    const Piece piece = reeds_shepp(ompl::pose_of(found.getState(i - 1)),
                                    ompl::pose_of(found.getState(i)), query_radius);
    path.segments.insert(path.segments.end(), piece.view().begin(), piece.view().end());
  }
  return path;
}

inline void expect_judged_good(Query& query) {
  ASSERT_TRUE(query.simple.haveExactSolutionPath());
  og::PathGeometric& found = query.simple.getSolutionPath();
  const PathCheck check = check_path(query.problem, path_of(found, query.problem));
  EXPECT_TRUE(check.valid) << check.reason;
  EXPECT_NEAR(check.length, found.length(), 1e-6);
  EXPECT_TRUE(found.check());
  // More states on the same path. A checker may refuse one of them that is within its tolerance of
  // an obstacle, a judge does not.
  found.interpolate();
  EXPECT_TRUE(check_path(query.problem, path_of(found, query.problem)).valid);
}

}  // namespace vandplan
