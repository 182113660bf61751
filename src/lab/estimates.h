// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is every node of a tree from a sample, as far as ranking goes?

#include <array>
#include <span>
#include <string_view>

#include "vandplan/geometry.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// How the distance from a node to a sample is estimated.
enum class Estimate { euclid, hlut_1, hlut_2, hlut_3, hlut_4, bound, reeds_shepp };

/// Their names, in order.
inline constexpr std::array<std::string_view, 7> estimate_names = {
    "euclid", "hlut-1", "hlut-2", "hlut-3", "hlut-4", "bound", "reeds-shepp"};

/// The estimate of that name, which is one of `estimate_names`.
[[nodiscard]] Estimate estimate_named(std::string_view name);

/// Estimated length from each node to the sample [m]; `lengths.size()` is the number of nodes.
void estimate_lengths(Estimate estimate, const Tree& tree, const Pose& sample, double radius,
                      std::span<float> lengths);

/// Estimated length of a path in one gear, 1 or -1, from each node to the sample [m]. "reeds-shepp"
/// is the exact length of Dubins then, and tables hold such lengths. A table is computed when it is
/// first asked for; the largest takes a tenth of a second.
void estimate_lengths_in(GearSign gear, Estimate estimate, const Tree& tree, const Pose& sample,
                         double radius, std::span<float> lengths);

}  // namespace vandplan::search
