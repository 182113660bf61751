// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/estimates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vandplan/bound_table.h"
#include "vandplan/heuristic_table.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan::search {
namespace {

void euclid(const Tree& tree, const Pose& sample, std::span<float> lengths) {
  const auto x = static_cast<float>(sample.x);
  const auto y = static_cast<float>(sample.y);
  const float* const nodes_x = tree.x().data();
  const float* const nodes_y = tree.y().data();
  float* const out = lengths.data();
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const float dx = nodes_x[i] - x;
    const float dy = nodes_y[i] - y;
    out[i] = std::sqrt(dx * dx + dy * dy);
  }
}

PoseColumns columns(const Tree& tree) { return {tree.x(), tree.y(), tree.heading()}; }

void from_table(int number, const Tree& tree, const Pose& sample, double radius,
                std::span<float> lengths) {
  thesis_table(number).distances(columns(tree), sample, radius, lengths);
}

/// What no path is shorter than.
void bound(const Tree& tree, const Pose& sample, double radius, std::span<float> lengths) {
  std::array<float, 512> high;
  for (std::size_t i = 0; i < lengths.size(); i += high.size()) {
    const std::size_t count = std::min(high.size(), lengths.size() - i);
    const PoseColumns nodes{tree.x().subspan(i, count), tree.y().subspan(i, count),
                            tree.heading().subspan(i, count)};
    length_bounds(nodes, sample, radius, lengths.subspan(i, count), std::span(high).first(count));
  }
}

}  // namespace

Estimate estimate_named(std::string_view name) {
  return static_cast<Estimate>(std::ranges::find(estimate_names, name) - estimate_names.begin());
}

void estimate_lengths(Estimate estimate, const Tree& tree, const Pose& sample, double radius,
                      std::span<float> lengths) {
  switch (estimate) {
    case Estimate::euclid:
      return euclid(tree, sample, lengths);
    case Estimate::hlut_1:
      return from_table(1, tree, sample, radius, lengths);
    case Estimate::hlut_2:
      return from_table(2, tree, sample, radius, lengths);
    case Estimate::hlut_3:
      return from_table(3, tree, sample, radius, lengths);
    case Estimate::hlut_4:
      return from_table(4, tree, sample, radius, lengths);
    case Estimate::bound:
      return bound(tree, sample, radius, lengths);
    case Estimate::reeds_shepp:
      return reeds_shepp_lengths(columns(tree), sample, radius, lengths);
  }
}

}  // namespace vandplan::search
