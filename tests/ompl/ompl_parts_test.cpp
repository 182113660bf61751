// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// OMPL's planners with our parts.

#include <gtest/gtest.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>

#include <algorithm>
#include <memory>

#include "support/cases.h"
#include "support/ompl_query.h"
#include "vandplan/input_error.h"
#include "vandplan/ompl.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

// ---- poses and edges ----

TEST(OmplWorld, StatesAreInTheFrameOfTheScenario) {
  for (const double away : {0.0, 4e6}) {
    Query query(yard_scenario(away, -away));
    const auto is_valid = [&](double x, double y) {
      return query.si->isValid(query.state({x + away, y - away, 0}).get());
    };
    EXPECT_TRUE(is_valid(0, 0));
    EXPECT_FALSE(is_valid(10, 0));
    EXPECT_TRUE(is_valid(10, 20));
    EXPECT_TRUE(is_valid(49, 0));
    EXPECT_FALSE(is_valid(51, 0));  // out of the bounds
    EXPECT_NEAR(
        query.si->getStateValidityChecker()->clearance(query.state({0 + away, 0 - away, 0}).get()),
        12 - 5.9, 1e-8);
  }
}

TEST(OmplWorld, AMarginIsKept) {
  Query near(yard_scenario());
  Query far(yard_scenario(), nullptr, {.margin = 1.0});
  const Pose close{5.5, 0, 0};  // 0.6 m from the wall
  EXPECT_TRUE(near.si->isValid(near.state(close).get()));
  EXPECT_FALSE(far.si->isValid(far.state(close).get()));
  const Pose start{0, 0, 0};
  EXPECT_TRUE(near.si->checkMotion(near.state(start).get(), near.state(close).get()));
  EXPECT_FALSE(far.si->checkMotion(far.state(start).get(), far.state(close).get()));
}

TEST(OmplWorld, AVehicleWithATrailerIsRefused) {
  Query query(yard_scenario());
  Scenario scenario = yard_scenario();
  scenario.vehicle = semitrailer();
  const Problem rig = make_problem(scenario);
  EXPECT_THROW(ompl::StateValidityChecker(query.si, rig), InputError);
  EXPECT_THROW(ompl::MotionValidator(query.si, rig), InputError);
}

/// Whether the vehicle is free at many poses of the motion.
bool is_free_at_many_poses(Query& query, const ob::State* from, const ob::State* to, double until) {
  ob::ScopedState<> at(query.space);
  for (int i = 0; i <= 300; ++i) {
    query.space->interpolate(from, to, until * i / 300, at.get());
    if (!query.si->isValid(at.get())) return false;
  }
  return true;
}

void expect_exact_edges(Query query, std::uint64_t seed) {
  int blocked = 0, free = 0;
  for_each_case(seed, 100, [&](Rng& rng) {
    const auto draw = [&] { return query.state(uniform_pose({-20, 40, -20, 20}, rng)); };
    const ob::ScopedState<> from = draw(), to = draw();
    if (!query.si->isValid(from.get())) return;
    const bool is_free = query.si->checkMotion(from.get(), to.get());
    ob::ScopedState<> last(query.space);
    std::pair<ob::State*, double> last_valid{last.get(), -1.0};
    EXPECT_EQ(query.si->checkMotion(from.get(), to.get(), last_valid), is_free);
    if (is_free) {
      ++free;
      EXPECT_EQ(last_valid.second, -1.0);
      EXPECT_TRUE(is_free_at_many_poses(query, from.get(), to.get(), 1.0));
      return;
    }
    ++blocked;
    const double t = last_valid.second;
    ASSERT_GE(t, 0.0);
    ASSERT_LE(t, 1.0);
    EXPECT_TRUE(query.si->isValid(last.get()));
    EXPECT_TRUE(is_free_at_many_poses(query, from.get(), to.get(), t));
    ob::ScopedState<> expected(query.space), beyond(query.space);
    query.space->interpolate(from.get(), to.get(), t, expected.get());
    EXPECT_EQ(ompl::pose_of(last.get()), ompl::pose_of(expected.get()));
    // What is not known to be free begins at once: the checker's tolerance and no more.
    const double length = query.space->distance(from.get(), to.get());
    EXPECT_FALSE(
        is_free_at_many_poses(query, from.get(), to.get(), std::min(1.0, t + 1e-5 / length)) &&
        t * length > length - 1e-5);
    last_valid = {nullptr, 0.0};
    EXPECT_FALSE(query.si->checkMotion(from.get(), to.get(), last_valid));
    EXPECT_EQ(last_valid.second, t);
  });
  EXPECT_GE(blocked, cases(100) / 5);
  EXPECT_GE(free, cases(100) / 10);
}

TEST(OmplWorld, EdgesAreCheckedExactlyInEverySpace) {
  expect_exact_edges(Query(yard_scenario()), 1);
  expect_exact_edges(Query(yard_scenario(), std::make_shared<ompl::DubinsStateSpace>(query_radius)),
                     2);
  expect_exact_edges(
      Query(yard_scenario(), std::make_shared<ompl::DubinsStateSpace>(query_radius, true)), 3);
  expect_exact_edges(
      Query(yard_scenario(), std::make_shared<ob::ReedsSheppStateSpace>(query_radius)), 4);
  expect_exact_edges(
      Query(yard_scenario(), std::make_shared<ob::DubinsStateSpace>(query_radius, true)), 5);
  expect_exact_edges(Query(yard_scenario(), std::make_shared<ompl::ReedsSheppStateSpace>(12.0)), 6);
}

TEST(OmplWorld, TheLastValidStateIsAtTheWall) {
  Query query(yard_scenario());
  const ob::ScopedState<> from = query.state({0, 0, 0}), to = query.state({30, 0, 0});
  std::pair<ob::State*, double> last_valid{nullptr, 0.0};
  EXPECT_FALSE(query.si->checkMotion(from.get(), to.get(), last_valid));
  EXPECT_LT(30 * last_valid.second, 12 - 5.9);
  EXPECT_GT(30 * last_valid.second, 12 - 5.9 - CollisionChecker::tolerance - 2e-6);
}

TEST(OmplWorld, SpacesThatDoNotFitAreRefused) {
  EXPECT_THROW(Query(yard_scenario(), std::make_shared<ob::SE2StateSpace>()), ::ompl::Exception);
  EXPECT_THROW(Query(yard_scenario(), std::make_shared<ompl::ReedsSheppStateSpace>(6.9)),
               ::ompl::Exception);
  EXPECT_THROW(Query(yard_scenario(), std::make_shared<ob::DubinsStateSpace>(6.9)),
               ::ompl::Exception);
}

// ---- nearest nodes ----

struct Node {
  ob::State* state;
};

TEST(OmplNearest, IsWhatComparingAllLengthsGives) {
  const auto space = std::make_shared<ompl::ReedsSheppStateSpace>(query_radius);
  const auto length = [&](Node* const& a, Node* const& b) {
    return space->distance(a->state, b->state);
  };
  for_each_case(7, 10, [&](Rng& rng) {
    ompl::NearestByLength<Node*> ours;
    ::ompl::NearestNeighborsLinear<Node*> all;
    ours.setDistanceFunction(length);
    all.setDistanceFunction(length);
    std::vector<ob::ScopedState<>> states;
    states.reserve(400);
    std::vector<Node> nodes(400);
    for (Node& node : nodes) {
      ompl::set_pose(states.emplace_back(space).get(), uniform_pose({-30, 30, -30, 30}, rng));
      node.state = states.back().get();
    }
    ob::ScopedState<> sample(space);
    Node wanted{sample.get()};
    const auto expect_same = [&] {
      ompl::set_pose(sample.get(), uniform_pose({-40, 40, -40, 40}, rng));
      std::vector<Node*> found, expected;
      EXPECT_EQ(ours.size(), all.size());
      if (all.size() == 0) return;
      EXPECT_EQ(ours.nearest(&wanted), all.nearest(&wanted));
      ours.nearestK(&wanted, 12, found);
      all.nearestK(&wanted, 12, expected);
      EXPECT_EQ(found, expected);
      ours.nearestR(&wanted, 15.0, found);
      all.nearestR(&wanted, 15.0, expected);
      EXPECT_EQ(found, expected);
      ours.list(found);
      all.list(expected);
      EXPECT_EQ(found, expected);
    };
    ours.add(std::vector<Node*>{nodes.data(), &nodes[1]});
    all.add(std::vector<Node*>{nodes.data(), &nodes[1]});
    for (std::size_t i = 2; i < nodes.size(); ++i) {
      ours.add(&nodes[i]);
      all.add(&nodes[i]);
      if (i % 20 == 0) expect_same();
    }
    std::shuffle(nodes.begin(), nodes.end(), rng);  // other nodes at the same addresses
    ours.clear();
    all.clear();
    expect_same();
    for (Node& node : nodes) {
      ours.add(&node);
      all.add(&node);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_TRUE(ours.remove(&nodes[i]));
      EXPECT_TRUE(all.remove(&nodes[i]));
      EXPECT_FALSE(ours.remove(&nodes[i]));
      if (i % 20 == 0) expect_same();
    }
  });
}

TEST(OmplNearest, EqualStatesAreToldApart) {
  const auto space = std::make_shared<ompl::ReedsSheppStateSpace>(query_radius);
  ob::ScopedState<> state(space);
  ompl::set_pose(state.get(), {1, 2, 3});
  std::vector<Node> nodes(3, Node{state.get()});
  ompl::NearestByLength<Node*> ours(query_radius, [](Node* const& node) { return node->state; });
  for (Node& node : nodes) ours.add(&node);
  EXPECT_EQ(ours.nearest(&nodes[2]), &nodes[0]);
  EXPECT_TRUE(ours.remove(&nodes[1]));
  EXPECT_TRUE(ours.remove(&nodes[0]));
  EXPECT_EQ(ours.nearest(&nodes[0]), &nodes[2]);
}

TEST(OmplNearest, NoneAndWrongSpacesAreErrors) {
  const auto space = std::make_shared<ob::ReedsSheppStateSpace>(query_radius);
  ob::ScopedState<> state(space);
  Node node{state.get()};
  ompl::NearestByLength<Node*> ours;
  EXPECT_THROW((void)ours.nearest(&node), ::ompl::Exception);
  ours.setDistanceFunction(
      [&](Node* const& a, Node* const& b) { return space->distance(a->state, b->state); });
  EXPECT_THROW(ours.add(&node), ::ompl::Exception);
}

// ---- OMPL's planners with our parts ----

template <typename Planner>
void expect_plans() {
  Query query(yard_scenario());
  const auto planner = std::make_shared<Planner>(query.si);
  query.simple.setPlanner(planner);
  query.simple.setup();
  // Any path will do, so that they end with the first one.
  query.simple.getOptimizationObjective()->setCostThreshold(ob::Cost(1e9));
  for (int i = 0; i < 2; ++i) {  // a second run begins anew
    query.simple.solve(ob::plannerNonTerminatingCondition());
    expect_judged_good(query);
    query.simple.clear();
  }
}

TEST(OmplPlanners, FindGoodPathsWithOurParts) {
  namespace mine = ompl::geometric;
  expect_plans<mine::RRT>();
  expect_plans<mine::RRTConnect>();
  expect_plans<mine::RRTstar>();
  expect_plans<mine::InformedRRTstar>();
  expect_plans<mine::BITstar>();
  expect_plans<mine::PRM>();
}

/// Opens what holds the nodes of a planner.
struct OpenRrt : ompl::ByLength<og::RRTstar> {
  using ompl::ByLength<og::RRTstar>::ByLength;
  const ::ompl::NearestNeighbors<Motion*>* nodes() { return nn_.get(); }
  using Nodes = ompl::NearestByLength<Motion*>;
};

TEST(OmplPlanners, OursAreThereWhereTheSpaceIsOurs) {
  Query ours(yard_scenario());
  OpenRrt planner(ours.si);
  planner.setProblemDefinition(ours.simple.getProblemDefinition());
  planner.setup();
  EXPECT_NE(dynamic_cast<const OpenRrt::Nodes*>(planner.nodes()), nullptr);
  Query theirs(yard_scenario(), std::make_shared<ob::ReedsSheppStateSpace>(query_radius));
  OpenRrt other(theirs.si);
  other.setProblemDefinition(theirs.simple.getProblemDefinition());
  other.setup();
  EXPECT_EQ(dynamic_cast<const OpenRrt::Nodes*>(other.nodes()), nullptr);
}

}  // namespace
}  // namespace vandplan
