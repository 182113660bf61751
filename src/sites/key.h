// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// For which world, vehicle and prices was a site table made?

#include <cstdint>

#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::sites {

/// Fingerprints of what the costs of a table depend on. They do not depend on a problem's start and
/// goal, nor on the frame of its world. Coordinates count in whole micrometres.
struct SiteKey {
  std::uint64_t world = 0;    ///< bounds, obstacles, kerbs, areas of `inside`, maps, zones
  std::uint64_t vehicle = 0;  ///< body and turning radius, without a trailer
  std::uint64_t prices = 0;   ///< prices of the path, gears, margin
};

/// The key of a world and vehicle under complete options.
[[nodiscard]] SiteKey site_key(const World& world, const Vehicle& vehicle,
                               const PlanOptions& options);

/// Throws InputError naming "site" if the keys differ: it says in what.
void expect_equal(const SiteKey& made_for, const SiteKey& wanted);

}  // namespace vandplan::sites
