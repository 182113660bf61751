// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/leads.h"
#include "support/pose_pairs.h"
#include "vandplan/dubins.h"
#include "vandplan/reeds_shepp.h"

#if __has_include(<ompl/base/spaces/ReedsSheppStateSpace.h>)

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

namespace vandplan {
namespace {

constexpr double radius = 7;
constexpr int million = 1'000'000;

/// The distance that one of OMPL's spaces gives for two poses.
template <typename Space>
class Peer {
 public:
  double distance(const PosePair& pair) {
    set(from_, pair.from);
    set(to_, pair.to);
    return space_->distance(from_.get(), to_.get());
  }

 private:
  using State = ompl::base::ScopedState<Space>;
  static void set(State& state, const Pose& pose) {
    state->setXY(pose.x, pose.y);
    state->setYaw(pose.heading);
  }

  ompl::base::StateSpacePtr space_ = std::make_shared<Space>(radius);
  State from_{space_};
  State to_{space_};
};

TEST(Ompl, ReedsSheppLengthsAreTheSameForStartsAnywhere) {
  Peer<ompl::base::ReedsSheppStateSpace> peer;
  for_each_case(1, million / 100, [&](Rng& rng) {
    for (int i = 0; i < 100; ++i) {
      const PosePair pair = near_pair(i % 2 == 0 ? 10 : 200, rng);
      const double expected = peer.distance(pair);
      EXPECT_NEAR(reeds_shepp_length(pair.from, pair.to, radius), expected, 1e-9 * expected)
          << as_code(pair);
    }
  });
}

TEST(Ompl, DubinsLengthsAreTheSameForStartsAnywhere) {
  Peer<ompl::base::DubinsStateSpace> peer;
  for_each_case(2, million / 100, [&](Rng& rng) {
    for (int i = 0; i < 100; ++i) {
      const PosePair pair = near_pair(i % 2 == 0 ? 10 : 200, rng);
      const double expected = peer.distance(pair);
      EXPECT_NEAR(dubins_length(pair.from, pair.to, radius), expected, 1e-9 * expected)
          << as_code(pair);
    }
  });
}

}  // namespace
}  // namespace vandplan

#else

TEST(Ompl, LengthsAreTheSame) { GTEST_SKIP() << "needs OMPL (Debian: libompl-dev)"; }

#endif
