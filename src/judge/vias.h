// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where does a path pass its vias, in the eyes of the judge?

#include <optional>
#include <string>
#include <vector>

#include "judge/track.h"
#include "judge/trailing.h"
#include "vandplan/motion.h"
#include "vandplan/problem.h"

namespace vandplan::judge {

/// Places where a track passes vias, one after the other.
struct Passings {
  std::vector<Place> places;  ///< as many as the vias that are passed, in their order
  std::vector<Place> stops;   ///< those of vias where the vehicle stands
};

/// First places where a track passes vias of a task within the judge's tolerance of 1e-6 m and
/// 1e-6 rad, in their order, up to the first one that it misses. Half steps that a via cannot be in
/// are skipped, so no place is overlooked. `trailing` is null without a trailer.
///
/// At vias with a stop the vehicle stands so that its wheels turn there at once, though it keeps
/// its gear, in as many places as possible; else where it would stand anyway, else where a segment
/// begins, else as early as possible. As many vias are passed as can be.
[[nodiscard]] Passings passings(const Task& task, const Track& track, const Trailing* trailing);

/// Number of vias, from the first one on, that a drive along a track passes in their order. It
/// stands at those where it has to.
[[nodiscard]] std::size_t passed_by(const Task& task, const Track& track,
                                    const SpeedProfile& speeds);

/// What is wrong with stated places where a track passes vias; none if nothing is.
[[nodiscard]] std::optional<std::string> false_passings(const Task& task, const Track& track,
                                                        const Trailing* trailing,
                                                        const std::vector<PassedVia>& stated);

}  // namespace vandplan::judge
