// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include "support/leads.h"
#include "support/pair_cases.h"
#include "support/radius.h"
#include "vandplan/steering.h"

#if __has_include(<ompl/base/spaces/ReedsSheppStateSpace.h>)

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

namespace vandplan {
namespace {

constexpr int ompl_pairs = 400'000;

/// The distance that one of OMPL's spaces gives for two poses.
template <typename Space>
class Peer {
 public:
  double distance(const DrawnPair& pair) {
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

  ompl::base::StateSpacePtr space_ = std::make_shared<Space>(default_radius);
  State from_{space_};
  State to_{space_};
};

template <typename Space, typename Length>
void expect_same_lengths(std::uint64_t seed, Length length) {
  Peer<Space> peer;
  for_each_pair(seed, ompl_pairs, near_or_far_pair, [&](const DrawnPair& pair, Rng&) {
    const double expected = peer.distance(pair);
    EXPECT_NEAR(length(pair.from, pair.to, default_radius), expected, 1e-9 * expected)
        << as_code(pair);
  });
}

TEST(Ompl, ReedsSheppLengthsAreTheSameForStartsAnywhere) {
  expect_same_lengths<ompl::base::ReedsSheppStateSpace>(1, reeds_shepp_length);
}

TEST(Ompl, DubinsLengthsAreTheSameForStartsAnywhere) {
  expect_same_lengths<ompl::base::DubinsStateSpace>(2, dubins_length);
}

}  // namespace
}  // namespace vandplan

#else

TEST(Ompl, LengthsAreTheSame) { GTEST_SKIP() << "needs OMPL (Debian: libompl-dev)"; }

#endif
