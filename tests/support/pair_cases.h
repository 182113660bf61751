// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How many pairs of poses does a law of steering run through?

#include "support/cases.h"
#include "support/pose_pairs.h"

namespace vandplan {

/// Calls `law(draw(rng), rng)` for `n` pairs, a hundred to each case of `for_each_case`.
template <typename Draw, typename Law>
void for_each_pair(std::uint64_t seed, int n, Draw draw, Law law) {
  constexpr int pairs_per_case = 100;
  for_each_case(seed, n / pairs_per_case, [&](Rng& rng) {
    for (int i = 0; i < pairs_per_case; ++i) law(draw(rng), rng);
  });
}

/// The second pose near the first, or far away.
inline DrawnPair near_or_far_pair(Rng& rng) { return near_pair(rng() % 2 == 0 ? 10 : 200, rng); }

}  // namespace vandplan
