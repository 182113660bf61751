// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are the claims about a path true?

#include <optional>
#include <span>
#include <string>

#include "judge/body.h"
#include "judge/track.h"
#include "judge/trailing.h"
#include "vandplan/judge.h"

namespace vandplan::judge {

/// Parts of a path's cost that the judge has computed.
struct Found {
  /// Least and largest cost of being near obstacles and in zones [m]: at the edge of a zone either
  /// is right.
  double least_surcharge = 0.0;
  double most_surcharge = 0.0;
  /// Least and largest duration of the fastest drive without jerk limit [s], if the cost is the
  /// time: at the edge of a zone either is right.
  double least_time = 0.0;
  double most_time = 0.0;
  bool has_priced_ground = false;  ///< whether zones or masks have prices or limits
  bool has_jerk_limit = false;
};

/// Computes the cost of being near obstacles and in zones.
void find_surcharges(const Task& task, std::span<const Body> bodies, const Trailing* trailing,
                     const CostOptions& rule, Found& found);

/// Computes the durations of the fastest drive, with the edges of zones inside and outside of them.
/// `stops`: places in order at which the vehicle stands besides.
void find_times(const Task& task, const Track& track, const Trailing* trailing,
                const std::vector<Place>& stops, Found& found);

/// One line about the first false claim, with the true value; none if all claims are true.
/// `trailing` is null without a trailer.
[[nodiscard]] std::optional<std::string> false_claim(const Track& track, const Trailing* trailing,
                                                     const Found& found, const PathClaims& claims);

}  // namespace vandplan::judge
