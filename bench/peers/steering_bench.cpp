// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How much faster are our lengths than OMPL's? Both in turns, on the same pairs of poses; the ratio
// is the median over the rounds, for absolute times drift with the machine.
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "support/pose_pairs.h"
#include "vandplan/dubins.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan {
namespace {

constexpr double radius = 7;
constexpr int rounds = 15;

/// Pairs as OMPL wants them.
template <typename Space>
class Peer {
 public:
  explicit Peer(const std::vector<PosePair>& pairs) {
    for (const auto& [from, to] : pairs) {
      for (const Pose& pose : {from, to}) {
        auto& state = states_.emplace_back(space_);
        state->setXY(pose.x, pose.y);
        state->setYaw(pose.heading);
      }
    }
  }
  double distance(std::size_t pair) const {
    return space_->distance(states_[2 * pair].get(), states_[2 * pair + 1].get());
  }

 private:
  ompl::base::StateSpacePtr space_ = std::make_shared<Space>(radius);
  std::vector<ompl::base::ScopedState<Space>> states_;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + rounds / 2, values.end());
  return values[rounds / 2];
}

/// Nanoseconds per call of `work`, which does `count` of them.
template <typename Work>
double nanoseconds(std::size_t count, Work work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
  return time.count() / static_cast<double>(count);
}

template <typename Space, typename Length>
void compare(const char* name, double reach, Length length) {
  Rng rng(1);
  std::vector<PosePair> pairs(4096);
  for (PosePair& pair : pairs) pair = near_pair(reach, rng);
  const Peer<Space> peer(pairs);

  double worst = 0;
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double theirs = peer.distance(i);
    worst = std::max(worst, std::abs(length(pairs[i].from, pairs[i].to, radius) - theirs) / theirs);
  }
  std::vector<double> ours_ns(rounds), theirs_ns(rounds), ratios(rounds);
  for (int round = 0; round < rounds; ++round) {
    theirs_ns[round] = nanoseconds(pairs.size(), [&] {
      for (std::size_t i = 0; i < pairs.size(); ++i) sum += peer.distance(i);
    });
    constexpr int repeats = 20;
    ours_ns[round] = nanoseconds(pairs.size() * repeats, [&] {
      for (int i = 0; i < repeats; ++i) {
        for (const auto& [from, to] : pairs) sum += length(from, to, radius);
      }
    });
    ratios[round] = theirs_ns[round] / ours_ns[round];
  }
  std::printf("%-12s %5.0f m %9.0f ns %9.1f ns %7.1f times %12.1e %10s\n", name, reach,
              median(theirs_ns), median(ours_ns), median(ratios), worst, sum > 0 ? "" : "?");
}

}  // namespace
}  // namespace vandplan

int main() {
  using namespace vandplan;
  std::printf("%-12s %7s %12s %12s %13s %12s\n", "length", "within", "OMPL", "ours", "ratio",
              "difference");
  for (const double reach : {10.0, 200.0}) {
    compare<ompl::base::ReedsSheppStateSpace>("Reeds-Shepp", reach, reeds_shepp_length);
    compare<ompl::base::DubinsStateSpace>("Dubins", reach, dubins_length);
  }
}
