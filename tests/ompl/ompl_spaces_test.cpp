// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Our spaces in the place of OMPL's: what a program sees is the same.

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>

#include "support/leads.h"
#include "support/pair_cases.h"
#include "support/radius.h"
#include "vandplan/ompl_spaces.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

namespace ob = ::ompl::base;

/// Ours and OMPL's, with a few states of each.
template <typename Ours, typename Theirs>
struct Twins {
  std::shared_ptr<Ours> ours;
  std::shared_ptr<Theirs> theirs;
  ob::ScopedState<> from{ours}, to{ours}, at{ours}, their_at{theirs};

  template <typename... Symmetric>
  explicit Twins(Symmetric... symmetric)
      : ours(std::make_shared<Ours>(default_radius, symmetric...)),
        theirs(std::make_shared<Theirs>(default_radius, symmetric...)) {}

  void set(const DrawnPair& pair) {
    ompl::set_pose(from.get(), pair.from);
    ompl::set_pose(to.get(), pair.to);
  }
  Pose their_pose(double t) {
    theirs->interpolate(from.get(), to.get(), t, their_at.get());
    return ompl::pose_of(their_at.get());
  }
  Pose our_pose(double t) {
    ours->interpolate(from.get(), to.get(), t, at.get());
    return ompl::pose_of(at.get());
  }
};

using ReedsSheppTwins = Twins<ompl::ReedsSheppStateSpace, ob::ReedsSheppStateSpace>;
using DubinsTwins = Twins<ompl::DubinsStateSpace, ob::DubinsStateSpace>;

void expect_near(const Pose& a, const Pose& b, const DrawnPair& pair, double t) {
  EXPECT_NEAR(a.x, b.x, 1e-9 * (1 + std::abs(b.x))) << as_code(pair) << " at " << t;
  EXPECT_NEAR(a.y, b.y, 1e-9 * (1 + std::abs(b.y))) << as_code(pair) << " at " << t;
  EXPECT_NEAR(wrap_angle(a.heading - b.heading), 0, 1e-9) << as_code(pair) << " at " << t;
}

/// Whether no other word is about as long as the shortest one.
bool is_unique(std::vector<Piece> words) {
  std::ranges::sort(words, {}, &Piece::length);
  return words.size() < 2 || words[1].length > words[0].length + 1e-4;
}

template <typename AnyTwins, typename Unique>
void expect_same_poses(AnyTwins& twins, std::uint64_t seed, Unique unique) {
  int compared = 0;
  constexpr int pairs = 4000;
  for_each_pair(seed, pairs, near_or_far_pair, [&](const DrawnPair& pair, Rng& rng) {
    twins.set(pair);
    const double expected = twins.theirs->distance(twins.from.get(), twins.to.get());
    EXPECT_NEAR(twins.ours->distance(twins.from.get(), twins.to.get()), expected,
                1e-9 * (1 + expected))
        << as_code(pair);
    if (!unique(pair)) return;
    ++compared;
    for (const double t : {uniform01(rng), uniform01(rng), 1e-3, 0.0, 1.0, 1.5, -0.5}) {
      expect_near(twins.our_pose(t), twins.their_pose(t), pair, t);
    }
  });
  EXPECT_GT(compared, cases(pairs / 100) * 100 / 2);
}

TEST(OmplSpaces, ReedsSheppStatesAreThoseOfOmpl) {
  ReedsSheppTwins twins;
  expect_same_poses(twins, 1, [](const DrawnPair& pair) {
    return is_unique(reeds_shepp_words(pair.from, pair.to, default_radius));
  });
}

TEST(OmplSpaces, DubinsStatesAreThoseOfOmpl) {
  DubinsTwins twins;
  expect_same_poses(twins, 2, [](const DrawnPair& pair) {
    return is_unique(dubins_words(pair.from, pair.to, default_radius));
  });
}

TEST(OmplSpaces, SymmetricDubinsStatesAreThoseOfOmpl) {
  DubinsTwins twins(true);
  expect_same_poses(twins, 3, [](const DrawnPair& pair) {
    std::vector<Piece> words = dubins_words(pair.from, pair.to, default_radius);
    const std::vector<Piece> back = dubins_words(pair.to, pair.from, default_radius);
    words.insert(words.end(), back.begin(), back.end());
    return is_unique(words);
  });
  EXPECT_TRUE(twins.ours->hasSymmetricDistance());
  EXPECT_FALSE(ompl::DubinsStateSpace().hasSymmetricDistance());
}

// OMPL's own validators keep the path between their calls.
template <typename Path, typename AnyTwins>
void expect_same_with_kept_path(AnyTwins& twins) {
  for_each_pair(
      4, 1000, [](Rng& rng) { return any_pair(default_radius, rng); },
      [&](const DrawnPair& pair, Rng& rng) {
        twins.set(pair);
        bool first_time = true;
        Path path;
        const auto kept = [&](double t) {
          twins.ours->interpolate(twins.from.get(), twins.to.get(), t, first_time, path,
                                  twins.at.get());
          return ompl::pose_of(twins.at.get());
        };
        expect_near(kept(0.0), ompl::pose_of(twins.from.get()), pair, 0);
        EXPECT_TRUE(first_time);
        for (int i = 0; i < 3; ++i) {
          const double t = uniform01(rng);
          const Pose expected = twins.our_pose(t);
          expect_near(kept(t), expected, pair, t);
          EXPECT_FALSE(first_time);
        }
        expect_near(kept(1.0), ompl::pose_of(twins.to.get()), pair, 1);
      });
}

TEST(OmplSpaces, APathThatIsKeptGivesTheSameStates) {
  ReedsSheppTwins reeds_shepp;
  expect_same_with_kept_path<ob::ReedsSheppStateSpace::ReedsSheppPath>(reeds_shepp);
  DubinsTwins dubins;
  expect_same_with_kept_path<ob::DubinsStateSpace::DubinsPath>(dubins);
  DubinsTwins symmetric(true);
  expect_same_with_kept_path<ob::DubinsStateSpace::DubinsPath>(symmetric);
}

TEST(OmplSpaces, PathsHaveTheLengthsThatOmplGives) {
  ReedsSheppTwins twins;
  DubinsTwins dubins;
  for_each_pair(5, 1000, near_or_far_pair, [&](const DrawnPair& pair, Rng&) {
    twins.set(pair);
    dubins.set(pair);
    EXPECT_NEAR(twins.ours->reedsShepp(twins.from.get(), twins.to.get()).length(),
                twins.theirs->reedsShepp(twins.from.get(), twins.to.get()).length(), 1e-8);
    EXPECT_NEAR(dubins.ours->dubins(dubins.from.get(), dubins.to.get()).length(),
                dubins.theirs->dubins(dubins.from.get(), dubins.to.get()).length(), 1e-8);
  });
}

template <typename Space>
void expect_sane(const std::shared_ptr<Space>& space) {
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-100);
  bounds.setHigh(100);
  space->setBounds(bounds);
  space->setup();
  EXPECT_NO_THROW(space->sanityChecks());
}

TEST(OmplSpaces, TheyPassOmplsOwnChecks) {
  ::ompl::RNG::setSeed(1);
  expect_sane(std::make_shared<ompl::ReedsSheppStateSpace>(default_radius));
  expect_sane(std::make_shared<ompl::DubinsStateSpace>(default_radius));
  expect_sane(std::make_shared<ompl::DubinsStateSpace>(default_radius, true));
}

// OMPL looks for its own classes, and then checks edges along the curves: ours are such.
template <typename Validator>
void expect_curves_are_checked(const ob::StateSpacePtr& space) {
  const auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker([](const ob::State* state) {
    const Pose pose = ompl::pose_of(state);
    return std::hypot(pose.x, pose.y - 2 * default_radius) > 1;
  });
  space->as<ob::SE2StateSpace>()->setBounds(ob::RealVectorBounds(2));
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-100);
  bounds.setHigh(100);
  space->as<ob::SE2StateSpace>()->setBounds(bounds);
  si->setup();
  EXPECT_NE(dynamic_cast<const Validator*>(si->getMotionValidator().get()), nullptr);
  ob::ScopedState<> from(space), to(space);
  ompl::set_pose(from.get(), {0, 0, 0});
  ompl::set_pose(to.get(), {-default_radius, default_radius,
                            -1.5707963267948966});  // three quarters to the left
  EXPECT_TRUE(si->isValid(from.get()) && si->isValid(to.get()));
  const bool is_dubins = std::is_same_v<Validator, ob::DubinsMotionValidator>;
  EXPECT_EQ(si->checkMotion(from.get(), to.get()), !is_dubins);
}

TEST(OmplSpaces, OmplChecksEdgesAlongTheCurves) {
  expect_curves_are_checked<ob::ReedsSheppMotionValidator>(
      std::make_shared<ompl::ReedsSheppStateSpace>(default_radius));
  expect_curves_are_checked<ob::DubinsMotionValidator>(
      std::make_shared<ompl::DubinsStateSpace>(default_radius));
}

TEST(OmplSpaces, TheSpaceBehindAQuestionIsFound) {
  ompl::ReedsSheppStateSpace ours(default_radius), other(default_radius);
  ob::ReedsSheppStateSpace theirs(default_radius);
  const ob::State* const state = ours.allocState();
  EXPECT_EQ(ompl::space_behind([&] { (void)ours.distance(state, state); }), &ours);
  EXPECT_EQ(ompl::space_behind([&] { (void)other.distance(state, state); }), &other);
  EXPECT_EQ(ompl::space_behind([&] { (void)theirs.distance(state, state); }), nullptr);
  EXPECT_EQ(ompl::space_behind([] {}), nullptr);
  ours.freeState(const_cast<ob::State*>(state));
}

// A program of OMPL's with another line of namespaces.
TEST(OmplSpaces, TheirNamesMayBeThoseOfOmpl) {
  namespace mine = ompl::base;
  const mine::StateSpacePtr space = std::make_shared<mine::ReedsSheppStateSpace>(default_radius);
  EXPECT_NE(dynamic_cast<const ompl::ReedsSheppStateSpace*>(space.get()), nullptr);
  static_assert(std::is_same_v<mine::DubinsStateSpace, ompl::DubinsStateSpace>);
  static_assert(std::is_same_v<mine::SE2StateSpace, ob::SE2StateSpace>);
}

}  // namespace
}  // namespace vandplan
