// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How much faster are our lengths than OMPL's? Both in turns, on the same pairs of poses; the ratio
// is the median over the rounds, for absolute times drift with the machine.
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "support/ompl_poses.h"
#include "support/pose_pairs.h"
#include "support/rounds.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr double radius = 7;
constexpr int rounds = 15;

template <typename Space, typename Length>
void compare(const char* name, double reach, Length length) {
  Rng rng(1);
  std::vector<DrawnPair> pairs(4096);
  for (DrawnPair& pair : pairs) pair = near_pair(reach, rng);
  OmplPoses<Space> peer(radius);
  for (const auto& [from, to] : pairs) {
    peer.add(from);
    peer.add(to);
  }
  const auto their_length = [&](std::size_t pair) {
    return peer.distance(peer[2 * pair], peer[2 * pair + 1]);
  };

  double worst = 0;
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double theirs = their_length(i);
    worst = std::max(worst, std::abs(length(pairs[i].from, pairs[i].to, radius) - theirs) / theirs);
  }
  std::vector<double> ours_ns(rounds), theirs_ns(rounds), ratios(rounds);
  for (int round = 0; round < rounds; ++round) {
    theirs_ns[round] = nanoseconds(pairs.size(), [&] {
      for (std::size_t i = 0; i < pairs.size(); ++i) sum += their_length(i);
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
