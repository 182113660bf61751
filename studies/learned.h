// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a network that learned a site's table know of the costs of driving to its goals?

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "studies/network.h"
#include "vandplan/problem.h"
#include "vandplan/site_table.h"

namespace vandplan::studies {

/// What a network is told of a pose beside the pose as seen from the goal and its exact length on
/// open ground.
enum class Told : std::uint8_t {
  place,  ///< The place on the site: of use on the site that the network learned.
  map     ///< The way around obstacles, `any-angle`: of use on any site.
};

/// What a network is told of poses, and what it shall answer: how much larger the cost is than all
/// lengths that it is told.
struct CostSamples {
  std::vector<float> inputs = {};   ///< of one pose after the other
  std::vector<float> targets = {};  ///< [turning radii]
};

/// Samples of a table: `count` random poses that have a cost, shared by the goals in turn. The
/// table serves the problem with each of its goals.
[[nodiscard]] CostSamples cost_samples(const SiteTable& table, const Problem& problem, Told told,
                                       std::size_t count, std::uint64_t seed);

/// A network that was trained by `steps` steps on random ones of the samples, which are not empty.
[[nodiscard]] std::shared_ptr<const Network> trained_on(const CostSamples& samples, int steps,
                                                        std::uint64_t seed);

/// The table with costs that a network estimates, in place of the costs of its cells. Without a
/// network, a cost is the largest length that a network would be told. Each run takes a table of
/// its own, as the table looks at the map on demand.
[[nodiscard]] SiteTable with_learned_costs(const SiteTable& table, const Problem& problem,
                                           Told told, std::shared_ptr<const Network> network);

/// How far the costs of a table are off those of another one, at random poses that this one knows.
struct CostErrors {
  double mean = 0.0, percent_95 = 0.0;  ///< absolute error [m]
  double relative = 0.0;                ///< sum of the errors over that of the costs
  double nanoseconds = 0.0;             ///< processor time of one look-up, mean [ns]
};

/// Errors of costs against those of a table to the same goals.
[[nodiscard]] CostErrors cost_errors(const SiteTable& costs, const SiteTable& table,
                                     std::uint64_t seed);

}  // namespace vandplan::studies
