// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How does my OMPL program get faster, and exact?

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/RandomNumbers.h>
#include <vandplan/ompl.h>  // instead of OMPL's ReedsSheppStateSpace.h and RRTConnect.h

#include <cmath>
#include <cstdio>
#include <memory>

// These replace ompl::base and ompl::geometric. Classes that the library does not have are OMPL's.
namespace ob = vandplan::ompl::base;
namespace og = vandplan::ompl::geometric;

// 1. The usual tutorial: a car that is a point, and a wall with a gap. The code below uses OMPL's
// names only.
bool is_in_the_gap_or_beside(const ob::State* state) {
  const auto* const car = state->as<ob::SE2StateSpace::StateType>();
  return std::abs(car->getX() - 5.0) > 0.5 || std::abs(car->getY() - 2.0) < 1.5;
}

bool plan_for_a_point() {
  const auto space = std::make_shared<ob::ReedsSheppStateSpace>(2.0);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-10);
  bounds.setHigh(20);
  space->setBounds(bounds);

  og::SimpleSetup setup(space);
  setup.setStateValidityChecker(is_in_the_gap_or_beside);
  ob::ScopedState<ob::SE2StateSpace> start(space), goal(space);
  start->setXY(0, 0);
  start->setYaw(0);
  goal->setXY(10, 0);
  goal->setYaw(3.0);
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  if (!setup.solve(10.0)) return false;
  std::printf("a point, through the gap: %.2f m\n", setup.getSolutionPath().length());
  return true;
}

// 2. A truck among polygons: poses and edges are checked exactly, by an OMPL planner and by ours.
bool plan_for_a_truck() {
  vandplan::Scenario yard;
  yard.bounds = {-50, 50, -50, 50};
  yard.goal = {20, 5, 0};
  yard.obstacles = {{{12, -9}, {13, -9}, {13, 9}, {12, 9}}};
  const vandplan::Problem problem = vandplan::make_problem(yard);

  og::SimpleSetup setup(
      std::make_shared<ob::ReedsSheppStateSpace>(yard.vehicle.min_turning_radius));
  vandplan::ompl::set_problem(setup, problem);
  const auto& information = setup.getSpaceInformation();
  const auto ours = std::make_shared<vandplan::ompl::Planner>(information, "anytime");
  ours->params().setParam("max_iterations", "20000");  // done before the 10 s below, everywhere
  for (const ob::PlannerPtr& planner :
       {ob::PlannerPtr(std::make_shared<og::RRTConnect>(information)), ob::PlannerPtr(ours)}) {
    setup.clear();
    setup.setPlanner(planner);
    if (!setup.solve(10.0) || !setup.getSolutionPath().check()) return false;
    std::printf("a truck, by %s: %.2f m\n", planner->getName().c_str(),
                setup.getSolutionPath().length());
  }
  return true;
}

int main() {
  ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
  ompl::RNG::setSeed(1);
  return plan_for_a_point() && plan_for_a_truck() ? 0 : 1;
}
