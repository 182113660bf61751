// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is the path from each node of a tree to a sample, estimated for ranking?

#include <array>
#include <span>
#include <string_view>

#include "vandplan/geometry.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// Estimates of the length of the path from a node to a sample. `site` is `bound`, which
/// `GrownTree` raises by the table of a site.
enum class Estimate { euclid, hlut_1, hlut_2, hlut_3, hlut_4, bound, reeds_shepp, site };

/// Names of the estimates that need no table of a site, in the order of the enum.
inline constexpr std::array<std::string_view, 7> estimate_names = {
    "euclid", "hlut-1", "hlut-2", "hlut-3", "hlut-4", "bound", "reeds-shepp"};

/// The estimate of that name, which is one of `estimate_names`.
[[nodiscard]] Estimate estimate_named(std::string_view name);

/// Writes the estimated length from each node to the sample to `lengths`, one per node [m].
/// `radius`: turning radius [m].
void estimate_lengths(Estimate estimate, const Tree& tree, const Pose& sample, double radius,
                      std::span<float> lengths);

/// Writes the estimated length of a path in one gear, 1 or -1, from each node to the sample [m].
/// "reeds-shepp" then gives exact Dubins lengths, and tables hold Dubins lengths. A table is
/// computed at its first use; the largest takes a tenth of a second.
void estimate_lengths_in(GearSign gear, Estimate estimate, const Tree& tree, const Pose& sample,
                         double radius, std::span<float> lengths);

}  // namespace vandplan::search
